//! `bifdiag-web-glue MODULE.wasm nodejs|web DIRECTORY`: the JavaScript and TypeScript around a module.

use anyhow::{Result, bail};
use wasm_bindgen_cli_support::Bindgen;

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [module, target, directory] = &arguments[..] else {
        bail!("write: bifdiag-web-glue MODULE.wasm nodejs|web DIRECTORY");
    };
    let mut bindgen = Bindgen::new();
    bindgen.input_path(module).typescript(true);
    match target.as_str() {
        "nodejs" => bindgen.nodejs(true)?,
        "web" => bindgen.web(true)?,
        other => bail!("`{other}` is neither nodejs nor web"),
    };
    bindgen.generate(directory)
}
