/** Surfaces and regions in words, for who hears the page and who meets the signs for the first time. */

const NAMES: Record<string, string> = { S2: "sphere", T2: "torus", D2: "disc", S3: "3-sphere", RP3: "projective space", S1xS2: "circle times sphere" };
const holes = (count: number): string => (count === 1 ? "one hole" : `${count} holes`);

/** M3 as “surface of genus 3”, S2-2D2 as “sphere with 2 holes”; other names as they are. */
export function inWords(name: string): string {
  const genus = /^M(\d+)$/.exec(name)?.[1];
  if (genus) return `surface of genus ${genus}, with ${genus} handles`;
  const discs = /^S2-(\d*)D2$/.exec(name)?.[1];
  if (discs !== undefined) return `sphere with ${holes(Number(discs || 1))}`;
  return NAMES[name] ?? name;
}

/** Names joined by “and”. */
export const listed = (names: (string | null)[]): string => names.map((name) => (name === null ? "none" : inWords(name))).join(" and ");
