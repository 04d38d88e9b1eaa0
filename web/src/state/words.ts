/** Surfaces and regions in words, for who hears the page and who meets the signs for the first time. */
import { texts } from "../texts";

/** M3 as “surface of genus 3”, S2-2D2 as “sphere with 2 holes”; other names as they are. */
export function inWords(name: string): string {
  const words = texts.surfaces;
  const genus = /^M(\d+)$/.exec(name)?.[1];
  if (genus) return words.genus(genus);
  const discs = /^S2-(\d*)D2$/.exec(name)?.[1];
  if (discs !== undefined) return words.holes(Number(discs || 1));
  return words.names[name] ?? name;
}

/** Names joined by “and”. */
export const listed = (names: (string | null)[]): string => names.map((name) => (name === null ? texts.surfaces.none : inWords(name))).join(texts.surfaces.and);
