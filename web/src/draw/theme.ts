/** Colours: told apart by colour-blind readers, in the dark and in print; the tints are those of the command line's pictures. */

import type { Atlas, Curve, Verdict } from "../bindings/documents";

export interface Ink {
  paper: string;
  panel: string;
  text: string;
  faint: string;
  line: string;
  accent: string;
  forbidden: string;
  dark: boolean;
}

const LIGHT: Ink = { paper: "#ffffff", panel: "#ffffff", text: "#1c2530", faint: "#5b6875", line: "#c8d0d8", accent: "#b3261e", forbidden: "#f4f5f7", dark: false };
const DARK: Ink = { paper: "#12171d", panel: "#171d25", text: "#e6ebf0", faint: "#9aa7b4", line: "#3a4552", accent: "#ff8a70", forbidden: "#1b222b", dark: true };

export const ink = (): Ink => (document.documentElement.dataset.theme === "dark" ? DARK : LIGHT);

/** Grounds of regions by type, on light paper; in the dark they are turned down. */
const TINTS: Record<string, number> = {
  S2: 0xdfebf7, T2: 0xe6f3d8, M2: 0xfff1c9, M3: 0xfbddd3, M4: 0xe9d6d6, "S2+S2": 0xd0e8ee, "S2+T2": 0xddd9f0,
  "T2+T2": 0xf5ddee, "M2+S2": 0xeae4d0, "M2+T2": 0xd5efe2, "M3+S2": 0xf7e2c0, "S2+S2+T2": 0xe3e3e3,
};
const ALL_TINTS = Object.values(TINTS);

export type Rgb = [number, number, number];

/** The ground of a region: a function of its type alone, so that it keeps its colour while it persists. */
export function tint(signature: string, circles: number, dark: boolean): Rgb {
  const name = signature.split("+").sort().join("+");
  let sum = 0;
  for (const [place, letter] of [...name].entries()) sum += (place + 1) * letter.charCodeAt(0);
  const code = TINTS[name] ?? ALL_TINTS[sum % ALL_TINTS.length]!;
  const shade = [1, 30 / 32, 31 / 32][circles % 3]!;
  const deeper = dark ? shade ** 4 : shade;
  const light: Rgb = [code >> 16, (code >> 8) & 255, code & 255];
  // In the dark: the same hue, more saturated, at a fifth of the light.
  const mean = (light[0] + light[1] + light[2]) / 3;
  return light.map((value) => Math.round(dark ? Math.max(0, 52 + 1.6 * (value - mean)) * deeper : value * deeper)) as Rgb;
}

export const css = ([r, g, b]: Rgb, alpha = 1): string => (alpha === 1 ? `rgb(${r} ${g} ${b})` : `rgb(${r} ${g} ${b} / ${alpha})`);

/** Colours of curves: the branch from +r̂, that from −r̂, pairs, others. */
const CURVES = {
  light: { first: "#c2142d", last: "#1250a8", pair: "#008a5e", others: ["#a98a00", "#8e3b9e", "#12809c", "#7a4a21", "#b84a82"], pole: "#5b6875" },
  dark: { first: "#ff6b74", last: "#7db3ff", pair: "#3fd6a0", others: ["#ecd04a", "#d48be4", "#4dd0ee", "#d19a68", "#ff9cca"], pole: "#9aa7b4" },
};

/** A colour for each branch of an atlas. */
export function branchColors({ curves, drawing }: Pick<Atlas, "curves" | "drawing">, dark: boolean): Map<string, string> {
  const palette = dark ? CURVES.dark : CURVES.light;
  const colors = new Map<string, string>();
  const start = ({ id }: Curve) => {
    const first = drawing.curves[id]?.polyline[0];
    return first?.[1] === 0 ? first[0] : NaN;
  };
  const critical = curves.filter((curve) => !curve.kind.startsWith("pole"));
  const started = critical.filter((curve) => !Number.isNaN(start(curve))).sort((a, b) => start(a) - start(b));
  const [lowest, highest] = [started[0], started.at(-1)];
  if (lowest) colors.set(lowest.branch, palette.first);
  if (highest && highest.branch !== lowest?.branch) colors.set(highest.branch, palette.last);
  let other = 0;
  let pairs = 0;
  for (const { branch, kind } of critical) {
    if (colors.has(branch)) continue;
    const isPair = kind === "pair" || kind === "circle";
    colors.set(branch, isPair && pairs++ === 0 ? palette.pair : palette.others[other++ % palette.others.length]!);
  }
  for (const { branch, kind } of curves) if (kind.startsWith("pole")) colors.set(branch, palette.pole);
  return colors;
}

/** Colours of orbits: Okabe and Ito's, which colour-blind readers tell apart, without the yellow that paper swallows. */
const ORBITS = {
  light: ["#0072b2", "#d55e00", "#009e73", "#9a4f80", "#3a8ec4", "#b07d00", "#3d3d3d", "#7a3b00"],
  dark: ["#56b4e9", "#ff9a4d", "#3fd6a0", "#e59cc4", "#8fd0ff", "#f0c948", "#e0e0e0", "#d9a577"],
};

export const orbitColor = (orbit: number, dark: boolean): string => {
  const colors = dark ? ORBITS.dark : ORBITS.light;
  return colors[orbit % colors.length]!;
};

export const openColor = (dark: boolean): string => (dark ? "#66727f" : "#aab4bd");

/** Regular, chaotic or open, in Okabe and Ito's blue and vermilion. */
export function verdictColor(verdict: Verdict, dark: boolean): string {
  if (verdict === "open") return openColor(dark);
  return (dark ? ORBITS.dark : ORBITS.light)[verdict === "regular" ? 0 : 1]!;
}

/** A scale from 0 to 1 that grows evenly in lightness (viridis, five stops). */
const SCALE: Rgb[] = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];

/** The scale of the command line's maps of the chaotic share, from 0 to 1, and a share that is not known. */
const SHARES: Rgb[] = [[22, 27, 92], [91, 35, 140], [165, 44, 131], [217, 74, 94], [238, 125, 45], [242, 177, 19]];
export const NO_SHARE: Rgb = [138, 138, 138];

export function shareColor(share: number): Rgb {
  const place = Math.min(0.9999, Math.max(0, share)) * (SHARES.length - 1);
  const [from, to] = [SHARES[Math.floor(place)]!, SHARES[Math.floor(place) + 1]!];
  return from.map((low, i) => Math.round(low + (place - Math.floor(place)) * (to[i]! - low))) as Rgb;
}

export function scaled(value: number): string {
  const place = Math.min(0.9999, Math.max(0, value)) * (SCALE.length - 1);
  const [from, to] = [SCALE[Math.floor(place)]!, SCALE[Math.floor(place) + 1]!];
  const share = place - Math.floor(place);
  return css(from.map((low, i) => Math.round(low + share * (to[i]! - low))) as Rgb);
}
