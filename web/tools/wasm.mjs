// Builds the module and writes the JavaScript around it to src/bindings/generated. PROFILE=release is quicker to build.
import { execFileSync } from "node:child_process";
import path from "node:path";
import { fileURLToPath } from "node:url";

const web = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "..");
const target = process.env.CARGO_TARGET_DIR ?? path.join(web, "../target");
const profile = process.env.PROFILE ?? "wasm";
const triple = "wasm32-unknown-unknown";

const cargo = (args, environment = {}) =>
  execFileSync("cargo", args, { cwd: web, stdio: "inherit", env: { ...process.env, CARGO_TARGET_DIR: target, ...environment } });

// Two orbits a register: every browser of the last three years has these instructions.
const modules = (process.env.MODULES ?? "bifdiag-web,bifdiag-web-parts,bifdiag-web-straight,bifdiag-web-chaos").split(",");
cargo(["build", "--profile", profile, ...modules.flatMap((name) => ["-p", name]), "--target", triple], { RUSTFLAGS: "-C target-feature=+simd128" });
for (const name of modules.map((name) => name.replaceAll("-", "_"))) {
  const module = path.join(target, triple, profile, `${name}.wasm`);
  cargo(["run", "--quiet", "--release", "-p", "bifdiag-web-glue", "--", module, "web", path.join(web, "src/bindings/generated")]);
}
