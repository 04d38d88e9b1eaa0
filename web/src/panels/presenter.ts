/** For a lecture: one panel fills the screen in large type; keys go on to the next panel, or to the next step of the tour. */
import { make } from "../draw/dom";
import type { Session } from "../state/session";
import { PANELS, type Panel } from "../state/state";
import { texts } from "../texts";

export function presenter(session: Session, panels: Record<Panel, HTMLElement>, step: (by: number) => boolean): void {
  const show = (panel: Panel | null) => session.update({ present: panel }, "theme");
  for (const name of PANELS) {
    const large = make("button", { type: "button", className: "enlarge", title: texts.presenter.enlarge, attributes: { "aria-label": texts.presenter.fill(texts.panels[name]) }, data: { testid: `present-${name}` } }, "⤢");
    large.addEventListener("click", () => show(session.state.present === name ? null : name));
    panels[name].querySelector("header")!.append(large);
  }
  session.on(["theme"], () => {
    const { present } = session.state;
    document.documentElement.dataset.present = present ?? "";
    for (const name of PANELS) panels[name].classList.toggle("large", name === present);
  });
  addEventListener("keydown", (event) => {
    const { present } = session.state;
    if (present === null) return;
    const by = { PageDown: 1, PageUp: -1 }[event.key];
    if (event.key === "Escape") show(null);
    else if (by !== undefined) {
      event.preventDefault();
      if (!step(by)) show(PANELS[(PANELS.indexOf(present) + by + PANELS.length) % PANELS.length]!);
    }
  });
}
