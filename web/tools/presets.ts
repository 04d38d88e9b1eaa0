/** The named bodies for the page, asked of the module when the page is built: the page is there before the module is. */
import { readFileSync } from "node:fs";
import type { Plugin } from "vite";
import type { Preset } from "../src/panels/body";
import init, { presets as texts } from "../src/bindings/generated/bifdiag_web.js";

const NAME = "virtual:presets";
const MODULE = new URL("../src/bindings/generated/bifdiag_web_bg.wasm", import.meta.url);

async function list(): Promise<Preset[]> {
  await init({ module_or_path: readFileSync(MODULE) });
  const [all, found] = [texts(), [] as Preset[]];
  for (let at = 0; at < all.length; at += 8) {
    const [name, note, a1, a2, a3, r1, r2, r3] = all.slice(at, at + 8) as [string, string, string, string, string, string, string, string];
    found.push({ name, note, A: [a1, a2, a3], r: [r1, r2, r3] });
  }
  return found;
}

export const presets = (): Plugin => ({
  name: "presets",
  resolveId: (id) => (id === NAME ? `\0${NAME}` : undefined),
  load: async (id) => (id === `\0${NAME}` ? `export default JSON.parse(${JSON.stringify(JSON.stringify(await list()))});` : undefined),
});
