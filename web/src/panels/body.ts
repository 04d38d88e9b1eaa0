/** The body: exact texts, presets, and two points to drag, A in the triangle of bodies and r on an octant of the sphere. */
import presets from "virtual:presets";
import type { Flags, Triple } from "../bindings/documents";
import { make, panel } from "../draw/dom";
import { mark, numberField } from "../draw/field";
import { inTurn } from "../draw/turns";
import { rounded, valueOf } from "../state/numbers";
import type { Session } from "../state/session";
import { octant } from "./octant";
import { sweep } from "./sweep";
import { triangle } from "./triangle";
import { guideTexts, texts } from "../texts";

export interface Preset {
  name: string;
  note: string;
  A: Triple;
  r: Triple;
}

/** Writes what is not there yet: each write makes the browser lay out the field anew. */
const written = (input: HTMLInputElement, value: string) => input.value === value || (input.value = value);

/** A slider for a number of r; while it is held, its ends stay. */
function slider(session: Session, axis: number): { element: HTMLInputElement; show: () => void } {
  const element = make("input", { type: "range", step: "any", title: texts.body.slider, attributes: { "aria-label": texts.body.sliderOf(axis + 1) }, data: { testid: `slider-r${axis + 1}` } });
  // From −1 to 1, unless r is longer or a hundred times shorter: that of a real part may be.
  const reach = () => {
    const most = Math.max(...session.state.r.map((text) => Math.abs(valueOf(text))));
    return most > 1 || (most > 0 && most < 0.01) ? 2 ** Math.ceil(Math.log2(most)) : 1;
  };
  element.addEventListener("input", () => {
    const numbers = [...session.state.r] as Triple;
    numbers[axis] = rounded(Number(element.value), Number(element.max) / 1000);
    session.dragging = "body";
    session.body(session.state.A, numbers);
  });
  element.addEventListener("change", () => session.release());
  // A step with the arrow keys: a hundredth of the reach.
  element.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key];
    if (!step) return;
    event.preventDefault();
    element.value = String(Number(element.value) + (step * Number(element.max)) / 100);
    element.dispatchEvent(new Event("input"));
    element.dispatchEvent(new Event("change"));
  });
  const show = () => {
    if (!session.dragging) [element.min, element.max] = [String(-reach()), String(reach())];
    written(element, String(valueOf(session.state.r[axis]!)));
  };
  return { element, show };
}

export function bodyPanel(session: Session): HTMLElement {
  const inputs = (name: "A" | "r", hint: string) =>
    [0, 1, 2].map((axis) => {
      const input = numberField(`${name}${axis + 1}`, hint, () => {
        const numbers = [...session.state[name]] as Triple;
        numbers[axis] = input.value;
        session.body(name === "A" ? numbers : session.state.A, name === "r" ? numbers : session.state.r);
      });
      return input;
    });
  const moments = inputs("A", texts.body.moment);
  const center = inputs("r", texts.body.center);
  const sliders = [0, 1, 2].map((axis) => slider(session, axis));
  const choice = make("select", { title: texts.body.presets, attributes: { "aria-label": texts.body.preset }, data: { testid: "presets" } });
  choice.append(make("option", { value: "" }, texts.body.another));
  for (const { name, note } of presets) choice.append(make("option", { value: name, title: note }, `${name}: ${note}`));
  choice.addEventListener("change", () => {
    const preset = presets.find(({ name }) => name === choice.value);
    if (!preset) return;
    session.adopt(preset.A, preset.r);
  });
  const notes = make("p", { className: "note" });
  const show = () => {
    const { A, r } = session.state;
    for (const [inputs, numbers] of [[moments, A], [center, r]] as const) inputs.forEach((input, i) => (written(input, numbers[i]!), mark(input, false)));
    sliders.forEach(({ show }) => show());
    choice.value = presets.find((preset) => preset.A.join() === A.join() && preset.r.join() === r.join())?.name ?? "";
  };
  session.on(["body"], () => (session.dragging === "body" ? inTurn(show) : show()));
  // What is a number and yet no moment of inertia.
  session.on(["message"], () => moments.forEach((input) => mark(input, session.message !== "" && !(valueOf(input.value) > 0))));
  session.on(["atlas"], () => (notes.textContent = session.atlas ? remarks(session.atlas.body) : ""));
  const passing = sweep(session);
  const element = panel(
    texts.body.title,
    texts.body.help,
    make("div", { className: "body-controls" },
      choice,
      make("div", { className: "numbers" }, make("b", {}, "A"), ...moments),
      make("div", { className: "numbers" }, make("b", {}, "r"), ...center, make("span"), ...sliders.map(({ element }) => element)),
      passing.controls,
      make("div", { className: "pair" }, triangle(session), octant(session)),
      passing.told,
      notes,
    ),
  );
  // Loaded when a part is about to be given.
  const part = make("details", { className: "part", data: { testid: "part" } }, make("summary", {}, texts.body.part));
  let form: Promise<void> | undefined;
  const load = () => void (form ??= Promise.all([import("./part"), guideTexts()]).then(([{ partForm }, words]) => partForm(session, words.part, part, element)));
  part.addEventListener("toggle", load);
  element.addEventListener("dragover", (event) => (event.preventDefault(), load()));
  element.append(part);
  return element;
}

/** What is special about a body, in words; the document knows. */
function remarks(flags: Flags): string {
  const said: string[] = [];
  if (flags.euler) said.push(texts.body.euler);
  else if (flags.axis) said.push(texts.body.axis);
  if (flags.symmetric) said.push(texts.body.symmetric);
  if (flags.unphysical) said.push(texts.body.unphysical);
  return said.join(" ");
}
