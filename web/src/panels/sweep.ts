/** One number of the body runs through its range and back, and what the diagram goes through on the way is told. */
import type { Atlas, Triple } from "../bindings/documents";
import { button, make } from "../draw/dom";
import { rounded, shown, stepOf, valueOf } from "../state/numbers";
import type { Session } from "../state/session";
import { texts } from "../texts";

const SECONDS = 16;
const NAMES = ["A1", "A2", "A3", "r1", "r2", "r3"];
/** Changes that are told at a time. */
const TOLD = 3;

const numbersOf = (session: Session): number[] => [...session.state.A, ...session.state.r].map(valueOf);
const keyOf = ({ regions, events }: Atlas): string => [regions.map(({ signature }) => signature).sort(), events.map(({ kind }) => kind).sort()].join(";");

/** `told` stands apart: what it tells must not move what the hand holds. */
export function sweep(session: Session): { controls: HTMLElement; told: HTMLElement } {
  const choice = make("select", { title: texts.body.sweepNumber, attributes: { "aria-label": texts.body.sweepLabel } }, ...NAMES.map((name) => make("option", { value: name, selected: name === "r2" }, name)));
  const told = make("p", { className: "passed", attributes: { "aria-live": "polite" }, data: { testid: "passed" } });
  let running = false;
  const play = button(`▶ ${texts.body.sweep}`, texts.body.sweepHelp, () => void (running ? (running = false) : run()), { testid: "sweep" });
  const run = async () => {
    const index = NAMES.indexOf(choice.value);
    const start = numbersOf(session)[index]!;
    const reach = index < 3 ? start / 2 : Math.max(...numbersOf(session).slice(3).map(Math.abs)) || 1;
    const [low, high] = index < 3 ? [start - reach, start + reach] : [-reach, reach];
    const step = stepOf(index < 3 ? start : reach, 3);
    const [A, r] = [session.state.A, session.state.r];
    running = true;
    play.textContent = texts.body.stop;
    told.replaceChildren();
    const begun = performance.now();
    for (let share = 0; running && share < 1; share = (performance.now() - begun) / 1000 / SECONDS) {
      const wave = Math.sin(2 * Math.PI * share);
      const value = start + (wave > 0 ? wave * (high - start) : -wave * (low - start));
      const text = [...A, ...r].map((number, i) => (i === index ? rounded(value, step) : number));
      session.dragging = "body";
      session.body(text.slice(0, 3) as Triple, text.slice(3) as Triple);
      await new Promise(requestAnimationFrame);
    }
    if (running) session.body(A, r);
    running = false;
    play.textContent = `▶ ${texts.body.sweep}`;
    session.release();
  };
  // Another hand, or another address, ends it.
  addEventListener("pointerdown", ({ target }) => target !== play && (running = false), { capture: true });
  session.on(["guide"], () => (running = false));
  // Whatever moves the body, a border between two pictures is looked for where their regions or events differ.
  let before: { key: string; numbers: number[] } | null = null;
  session.on(["drawing"], () => {
    if (!session.drawn || session.dragging !== "body") return void (before = null);
    const now = { key: keyOf(session.drawn.document), numbers: session.drawn.numbers };
    const from = before;
    before = now;
    if (!from || from.key === now.key) return;
    session.border(from.numbers, now.numbers).then(({ t, text }) => {
      const moved = NAMES.filter((_, i) => from.numbers[i] !== now.numbers[i]);
      const at = moved.map((name) => `${name} = ${shown(from.numbers[NAMES.indexOf(name)]! * (1 - t) + t * now.numbers[NAMES.indexOf(name)]!)}`);
      told.prepend(make("span", {}, `${at.join(", ")}: ${text}`));
      while (told.childElementCount > TOLD) told.lastElementChild!.remove();
    }, () => undefined);
  });
  return { controls: make("div", { className: "row sweep" }, choice, play), told };
}
