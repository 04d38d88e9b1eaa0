/** What happens to the sections when a point goes over a curve, in a sentence. */
import type { Component } from "../bindings/documents";
import { surface } from "./numbers";

const genus = (component: Component) => component.genus ?? 0;

const named = (components: Component[]): string =>
  components.length === 0 ? "nothing" : components.map((component) => surface(component.section ?? component.accessible_region)).join(" and ");

/** Components without those that are the same on both sides. */
function differences(before: Component[], after: Component[]): [Component[], Component[]] {
  const key = (component: Component) => `${component.boundary_circles}${component.poles?.join("") ?? ""}`;
  const rest = [...after];
  const gone = before.filter((component) => {
    const same = rest.findIndex((other) => key(other) === key(component));
    if (same >= 0) rest.splice(same, 1);
    return same < 0;
  });
  return [gone, rest];
}

export function surgery(before: Component[], after: Component[]): string | null {
  const [gone, come] = differences(before, after);
  if (gone.length === 0 && come.length === 0) return null;
  return `${event(gone, come)} Before: ${named(before)}; now: ${named(after)}.`;
}

function event(gone: Component[], come: Component[]): string {
  const poles = (list: Component[]) => list.flatMap((component) => component.poles ?? []).length;
  if (gone.length === 0) return "A new component is born at a minimum of the effective potential.";
  if (come.length === 0) return "A component shrinks to a point and is gone.";
  if (gone.length === 2 && come.length === 1) return "Two components of U touch at a saddle and merge into one.";
  if (gone.length === 1 && come.length === 2) return "A component of U pinches at a saddle and falls into two.";
  if (gone.length === 1 && come.length === 1) return one(gone[0]!, come[0]!, poles(come) - poles(gone));
  return "Several things happen at once here.";
}

function one(before: Component, after: Component, poles: number): string {
  const circles = after.boundary_circles - before.boundary_circles;
  const handles = genus(after) - genus(before);
  const change = handles === 0 ? "the genus stays" : handles > 0 ? `the section gains ${count(handles, "handle")}` : `the section loses ${count(-handles, "handle")}`;
  if (poles !== 0 && circles === 0) return `A pole ±r̂ ${poles > 0 ? "enters" : "leaves"} U: ${change}.`;
  if (circles > 0) return `U touches itself at a saddle and a hole opens between: ${count(circles, "boundary circle")} more, ${change}.`;
  if (circles < 0) return `A hole of U closes at a maximum: ${count(-circles, "boundary circle")} less, ${change}.`;
  return `U changes: ${change}.`;
}

const count = (number: number, what: string) => (number === 1 ? `one ${what}` : `${number} ${what}s`);
