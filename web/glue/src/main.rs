//! `bifdiag-web-glue MODULE.wasm nodejs|web DIRECTORY`: the JavaScript and TypeScript around a module.

use anyhow::{Result, bail};
use wasm_bindgen_cli_support::Bindgen;

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [module, target, directory] = &arguments[..] else {
        bail!("write: bifdiag-web-glue MODULE.wasm nodejs|web DIRECTORY");
    };
    let mut bindgen = Bindgen::new();
    // Names of functions are a twentieth of the module, and only a trap would show them.
    bindgen.input_path(module).typescript(true).remove_name_section(true).remove_producers_section(true);
    match target.as_str() {
        "nodejs" => bindgen.nodejs(true)?,
        "web" => bindgen.web(true)?,
        other => bail!("`{other}` is neither nodejs nor web"),
    };
    bindgen.generate(directory)
}
