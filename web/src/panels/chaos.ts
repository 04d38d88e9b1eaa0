/** The chaotic share as a layer of the diagram: when it is measured, and what is told below. */
import { button, make } from "../draw/dom";
import { same } from "../state/view";
import type { Session } from "../state/session";
import { bodyText } from "../state/state";
import type { Window } from "../bindings/documents";
import { texts } from "../texts";

/** Milliseconds for which body and window stay before orbits are followed. */
const PAUSE = 300;

export function chaosLayer(session: Session): { tool: HTMLButtonElement; legend: HTMLElement } {
  const { chaos } = session;
  const tool = button(texts.diagram.chaos, texts.diagram.chaosHelp, () => session.update({ chaos: !session.state.chaos }, "theme"), { testid: "chaos" });
  const words = make("span", { attributes: { "aria-live": "polite" }, data: { testid: "chaos-note" } });
  const choice = make("select", { title: texts.diagram.componentHelp, attributes: { "aria-label": texts.diagram.component }, data: { testid: "chaos-component" } });
  choice.addEventListener("change", () => session.update({ component: Number(choice.value) }, "theme"));
  const legend = make("div", { className: "bar chaos", hidden: true }, choice, words);
  let waiting: ReturnType<typeof setTimeout> | undefined;
  let measured: { body: string; window: Window } | null = null;

  const wanted = () => {
    const { state, drawn } = session;
    if (!state.chaos || !drawn || session.dragging === "body" || session.dragging === "view") return null;
    return { body: bodyText(state), window: state.straight ? drawn.document.drawing.view.everything : drawn.window };
  };
  const follow = () => {
    const next = wanted();
    if (next && measured && next.body === measured.body && same(next.window, measured.window)) return;
    clearTimeout(waiting);
    if (measured) chaos.clear();
    measured = null;
    waiting = setTimeout(() => {
      const now = wanted();
      if (!now) return;
      measured = now;
      void chaos.measure(session.state.A, session.state.r, now.window);
    }, PAUSE);
  };
  const show = () => {
    const { chaos: on, component } = session.state;
    tool.setAttribute("aria-pressed", String(on));
    legend.hidden = !on;
    if (!on) return;
    const several = Math.max(chaos.components, component + 1);
    if (choice.options.length !== several) choice.replaceChildren(...Array.from({ length: several }, (_, k) => make("option", { value: String(k) }, texts.diagram.componentOf(k))));
    choice.value = String(component);
    choice.hidden = several === 1;
    const told = chaos.summary;
    legend.dataset.cells = String(told?.level.cells ?? 0);
    if (chaos.message) words.textContent = chaos.message;
    else if (!told) words.textContent = texts.diagram.first;
    else {
      const cells = ({ cells }: { cells: number }) => texts.diagram.cells(cells);
      const done = (share: number) => texts.diagram.done(Math.round(100 * share));
      const next = told.next && told.next.level !== told.level ? `; ${cells(told.next.level)}: ${done(told.next.share)}` : told.next ? `, ${done(told.next.share)}` : "";
      words.textContent = texts.diagram.measured(cells(told.level), told.error.toFixed(2), (100 * told.open).toFixed(1), next);
    }
  };
  session.on(["body", "drawing", "theme"], follow);
  session.on(["chaos", "theme"], show);
  return { tool, legend };
}
