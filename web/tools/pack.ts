/** Beside each built file that is worth it, the same packed with Brotli: servers send it to browsers that take it. */
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { brotliCompressSync, constants } from "node:zlib";
import type { Plugin } from "vite";

const WORTH = /\.(html|js|css|wasm)$/;

export function pack(): Plugin {
  let folder = "";
  return {
    name: "pack",
    apply: "build",
    configResolved: (config) => void (folder = path.resolve(config.root, config.build.outDir)),
    closeBundle() {
      for (const file of readdirSync(folder, { recursive: true, encoding: "utf8" }).filter((file) => WORTH.test(file))) {
        const content = readFileSync(path.join(folder, file));
        const packed = brotliCompressSync(content, { params: { [constants.BROTLI_PARAM_LGWIN]: 24, [constants.BROTLI_PARAM_SIZE_HINT]: content.length } });
        if (packed.length < 0.9 * content.length) writeFileSync(path.join(folder, `${file}.br`), packed);
      }
    },
  };
}
