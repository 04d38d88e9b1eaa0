/** The chaotic share as a layer of the diagram: when it is measured, and what is told below. */
import { button, make } from "../draw/dom";
import { same } from "../state/view";
import type { Session } from "../state/session";
import { bodyText } from "../state/state";
import type { Window } from "../bindings/documents";

/** Milliseconds for which body and window stay before orbits are followed. */
const PAUSE = 300;

export function chaosLayer(session: Session): { tool: HTMLButtonElement; legend: HTMLElement } {
  const { chaos } = session;
  const tool = button("Chaos", "Colour each place by the chaotic share of the energy surface over it, measured in cells that become finer while you look", () => session.update({ chaos: !session.state.chaos }, "theme"), { testid: "chaos" });
  const words = make("span", { attributes: { "aria-live": "polite" }, data: { testid: "chaos-note" } });
  const choice = make("select", { title: "The component of the energy surface, as `bifdiag classify` counts them", attributes: { "aria-label": "component" }, data: { testid: "chaos-component" } });
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
    if (choice.options.length !== several) choice.replaceChildren(...Array.from({ length: several }, (_, k) => make("option", { value: String(k) }, `component ${k} of E`)));
    choice.value = String(component);
    choice.hidden = several === 1;
    const told = chaos.summary;
    legend.dataset.cells = String(told?.level.cells ?? 0);
    if (chaos.message) words.textContent = chaos.message;
    else if (!told) words.textContent = "chaotic share: following the first orbits …";
    else {
      const cells = ({ cells }: { cells: number }) => `${cells} × ${cells} cells`;
      const next = told.next && told.next.level !== told.level ? `; ${cells(told.next.level)}: ${Math.round(100 * told.next.share)} % done` : told.next ? `, ${Math.round(100 * told.next.share)} % done` : "";
      words.textContent = `${cells(told.level)}, standard deviations up to ${told.error.toFixed(2)}, ${(100 * told.open).toFixed(1)} % without a verdict${next}. Grey: no orbit of the region in the cell`;
    }
  };
  session.on(["body", "drawing", "theme"], follow);
  session.on(["chaos", "theme"], show);
  return { tool, legend };
}
