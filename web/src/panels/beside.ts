/** A second body beside the first: its diagram, by this page once more in a frame, in the same window and with the same point. */
import { button, make } from "../draw/dom";
import type { Session } from "../state/session";
import { besideText, FIRST, type State } from "../state/state";
import { format } from "../state/hash";
import type { Triple } from "../bindings/documents";
import { texts } from "../texts";

export function beside(session: Session): { tool: HTMLButtonElement; element: HTMLElement } {
  const tool = button(texts.diagram.beside, texts.diagram.besideHelp, () => choose(session.state.beside === null ? besideText(session.state) : null), { testid: "beside" });
  const words = make("span", {});
  const swap = button("⇄", texts.diagram.swap, () => {
    const [A, r] = bodyOf(session.state.beside!);
    const other = besideText(session.state);
    session.state = { ...session.state, beside: other };
    session.body(A, r);
  }, { testid: "swap" });
  swap.setAttribute("aria-label", swap.title);
  const stage = make("div", { className: "stage" });
  const element = make("div", { className: "twin", hidden: true }, make("div", { className: "bar" }, words, swap), stage);
  let frame: HTMLIFrameElement | null = null;

  const choose = (other: string | null) => {
    session.update({ beside: other }, "theme");
    show();
  };
  const show = () => {
    const { state, drawn } = session;
    const other = state.embed === null ? state.beside : null;
    tool.hidden = state.embed !== null;
    tool.setAttribute("aria-pressed", String(other !== null));
    element.hidden = other === null;
    if (other === null) {
      frame?.remove();
      frame = null;
      return;
    }
    const [A, r] = bodyOf(other);
    words.textContent = texts.diagram.besideBody(A.join(", "), r.join(", "));
    const seen: State = { ...FIRST, A, r, point: state.point, view: drawn?.window ?? state.view, straight: state.straight, embed: "diagram", theme: state.theme };
    const address = `${location.pathname}${location.search}#${format(seen)}`;
    // Another part of the address leaves the page in the frame where it is.
    if (frame?.contentWindow) frame.contentWindow.location.replace(address);
    else stage.replaceChildren((frame = make("iframe", { title: texts.diagram.twin, src: address, data: { testid: "twin" } })));
  };
  session.on(["address", "theme"], show);
  session.on(["drawing"], () => session.dragging || show());
  return { tool, element };
}

function bodyOf(text: string): [Triple, Triple] {
  const numbers = text.split(",");
  return [numbers.slice(0, 3) as Triple, numbers.slice(3) as Triple];
}
