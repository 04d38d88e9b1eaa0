/** The catalogue of classes for the page: of `data/classes.json` and `data/survey/special.json` what tells a class in words. */
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Plugin } from "vite";
import type { Catalogue } from "../src/panels/catalogue";

const MODULE = "virtual:classes";
const PATHS = ["classes.json", "survey/special.json"].map((file) => fileURLToPath(new URL(`../../data/${file}`, import.meta.url)));

interface Generic {
  classes: { name: string; physical: boolean; measure: number }[];
}

type Special = { stratum: string; met: Record<string, { preset?: string }> }[];

/** A class of generic bodies by its share, one of special bodies by the strata that have it, and the preset of it. */
export function catalogue({ classes }: Generic, special: Special): Catalogue {
  const generic: Catalogue["generic"] = Object.fromEntries(classes.map(({ name, physical, measure }) => [name, physical ? measure : null]));
  const found: Catalogue["special"] = {};
  special.forEach(({ met }, stratum) => {
    for (const [name, { preset }] of Object.entries(met)) {
      const entry = (found[name] ??= { in: [], ...(preset && { preset }) });
      entry.in.push(stratum);
    }
  });
  return { generic, special: found, strata: special.map(({ stratum }) => stratum) };
}

export function classes(): Plugin {
  return {
    name: "classes",
    resolveId: (id) => (id === MODULE ? `\0${MODULE}` : undefined),
    load(id) {
      if (id !== `\0${MODULE}`) return undefined;
      for (const path of PATHS) this.addWatchFile(path);
      const [generic, special] = PATHS.map((path) => JSON.parse(readFileSync(path, "utf8")) as unknown);
      return `export default JSON.parse(${JSON.stringify(JSON.stringify(catalogue(generic as Generic, special as Special)))});`;
    },
  };
}
