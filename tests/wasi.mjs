// Runs a WebAssembly program with Node's WASI: cargo's runner for wasm32-wasip1 (`.ci/run`). It sees the repository and
// the environment, which the tests read, and nothing else.
import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { WASI } from "node:wasi";

const [program, ...options] = process.argv.slice(2);
const repository = fileURLToPath(new URL("..", import.meta.url)).replace(/\/$/, "");
const wasi = new WASI({
    version: "preview1",
    args: [program, ...options],
    env: process.env,
    preopens: { [repository]: repository, "/tmp": "/tmp" },
    returnOnExit: true,
});
const module = await WebAssembly.compile(await readFile(program));
const instance = await WebAssembly.instantiate(module, wasi.getImportObject());
process.exitCode = wasi.start(instance);
