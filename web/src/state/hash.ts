/** The state as the part of an address behind `#`, and back. */
import { FIRST, PANELS, type Coloring, type Embedded, type State, type Theme } from "./state";
import { TASK_KEYS, taskOf, taskParts } from "./task";
import type { Triple, Window } from "../bindings/documents";
import { typed } from "./numbers";
import { texts } from "../texts";

const EMBEDDED: readonly Embedded[] = ["diagram", "section", "motion"];
const THEMES: readonly Theme[] = ["dark", "light"];
const COLORINGS: readonly Coloring[] = ["orbit", "verdict", "lyapunov", "rotation"];

/** Keys of an address. */
const KEYS: string[] = ["A", "r", "h", "l", "body", "view", "orbits", "crossings", "seed", "coloring", "theme", "embed", "present", "tour", "lesson", "beside", "layer", "component", ...TASK_KEYS];

/** The keys that `parse` passes over: misspelt ones, or those of a later version. */
export const unknownKeys = (hash: string): string[] => pairs(hash).map(([name]) => name).filter((name) => !KEYS.includes(name));

export function format(state: State): string {
  const parts = [`A=${state.A.join(",")}`, `r=${state.r.join(",")}`];
  if (state.point) parts.push(`h=${state.point.h}`, `l=${state.point.l}`);
  if (state.straight) parts.push("view=straight");
  else if (state.view) parts.push(`view=${[...state.view.h, ...state.view.l].join(",")}`);
  if (state.chaos) parts.push("layer=chaos");
  if (state.chaos && state.component > 0) parts.push(`component=${state.component}`);
  for (const name of ["orbits", "crossings", "seed", "coloring"] as const) {
    if (state[name] !== FIRST[name]) parts.push(`${name}=${state[name]}`);
  }
  for (const name of ["theme", "embed", "present", "tour", "lesson", "beside"] as const) {
    if (state[name] !== null) parts.push(`${name}=${state[name]}`);
  }
  return [...parts, ...(state.task ? taskParts(state.task, parts) : [])].join("&");
}

/** Reads a hash; `named` finds preset bodies for `body=NAME`. Throws an error that names what is wrong. */
export function parse(hash: string, named: (name: string) => Pick<State, "A" | "r"> | undefined): State {
  const state: State = { ...FIRST };
  let h: string | undefined;
  let l: string | undefined;
  const all = pairs(hash);
  state.task = taskOf(all);
  for (const [name, text] of all) {
    const value = text.trim().replace(/[−–]/g, "-");
    if (name === "h") h = typed(text);
    else if (name === "l") l = typed(text);
    else if (name === "body") Object.assign(state, found(value, named(value)));
    else read(state, name, value);
  }
  if ((h === undefined) !== (l === undefined)) throw new Error(texts.address.missing(h === undefined ? "h" : "l"));
  if (h !== undefined && l !== undefined) state.point = { h, l };
  return state;
}

const pairs = (hash: string): [string, string][] => hash.replace(/^#/, "").split("&").filter((part) => part !== "").map(split);

function split(part: string): [string, string] {
  const at = part.indexOf("=");
  if (at < 0) throw new Error(texts.address.noValue(part));
  try {
    return [decodeURIComponent(part.slice(0, at)), decodeURIComponent(part.slice(at + 1))];
  } catch {
    throw new Error(texts.address.encoding(part));
  }
}

function found(name: string, body: Pick<State, "A" | "r"> | undefined): Pick<State, "A" | "r"> {
  if (!body) throw new Error(texts.address.noPreset(name));
  return body;
}

function read(state: State, name: string, value: string): void {
  if (name === "A" || name === "r") state[name] = triple(name, value);
  else if (name === "view" && value === "straight") state.straight = true;
  else if (name === "view") state.view = window(value);
  else if (name === "layer") state.chaos = word(name, value, ["chaos"]) === "chaos";
  else if (name === "component") state.component = count(name, value, 0, 99);
  else if (name === "orbits") state.orbits = count(name, value, 1, 500);
  else if (name === "crossings") state.crossings = count(name, value, 1, 20_000);
  else if (name === "seed") state.seed = count(name, value, 0, 2 ** 32 - 1);
  else if (name === "coloring") state.coloring = word(name, value, COLORINGS);
  else if (name === "theme") state.theme = word(name, value, THEMES);
  else if (name === "embed") state.embed = word(name, value, EMBEDDED);
  else if (name === "present") state.present = word(name, value, PANELS);
  else if (name === "tour") state.tour = count(name, value, 1, 8);
  else if (name === "lesson") state.lesson = value;
  else if (name === "beside") state.beside = six(name, value);
}

function triple(name: string, value: string): Triple {
  const parts = value.split(",").map((part) => part.trim());
  if (parts.length !== 3) throw new Error(texts.address.triple(name, value));
  return parts as Triple;
}

function six(name: string, value: string): string {
  const parts = value.split(",").map((part) => part.trim());
  if (parts.length !== 6 || parts.includes("")) throw new Error(texts.address.six(name, value));
  return parts.join(",");
}

function window(value: string): Window {
  const [h0, h1, l0, l1, ...rest] = value.split(",").map(Number) as [number, number, number, number];
  if (rest.length > 0 || !(h0 < h1 && l0 < l1)) throw new Error(texts.address.view(value));
  return { h: [h0, h1], l: [l0, l1] };
}

function count(name: string, value: string, least: number, most: number): number {
  const number = Number(value);
  if (!Number.isInteger(number) || number < least || number > most) throw new Error(texts.address.count(name, value, least, most));
  return number;
}

function word<W extends string>(name: string, value: string, words: readonly W[]): W {
  const known = words.find((known) => known === value);
  if (known === undefined) throw new Error(texts.address.word(name, value, words.join(", ")));
  return known;
}
