/** Classes in words, from the catalogue of classes that are known. */
import type { Guide } from "../texts";

export interface Catalogue {
  /** Classes of generic bodies: their share of all bodies that exist (0: too thin for a sample), null where none exists. */
  generic: Record<string, number | null>;
  /** Classes of special bodies: the numbers of the strata that have them, and the first preset of the class. */
  special: Record<string, { in: number[]; preset?: string }>;
  strata: string[];
}

/** What is known of the class of this name; a share is that of `docs/survey.md`. */
export function described({ generic, special, strata }: Catalogue, words: Guide["classes"], name: string): string {
  const share = generic[name];
  if (share !== undefined) {
    const shares = Object.values(generic).filter((other) => other !== null);
    if (share === null) return words.unreal;
    if (share === 0) return words.thin(shares.length);
    const rank = 1 + shares.filter((other) => other > share).length;
    return words.share(rank, shares.length, Number((100 * share).toPrecision(3)));
  }
  const entry = special[name];
  if (!entry) return words.unlisted;
  const where = entry.in.map((stratum) => strata[stratum]).join("; ");
  return entry.preset ? `${entry.preset} (${where})` : where;
}

/** The file is loaded when a class is told for the first time, not with the page. */
export const loaded = (): Promise<Catalogue> => import("virtual:classes").then((module) => module.default);
