/** The space of bodies: a map of classes; the present body is a point to drag in it. */
import { drag, Sheet } from "../draw/canvas";
import { button, make, panel } from "../draw/dom";
import type { Session } from "../state/session";
import { boxOf, paintBodies } from "./bodies-paint";
import { bordersOf, type Border } from "./borders";
import { described, loaded, type Catalogue } from "./catalogue";
import { Cells, FINEST } from "./cells";
import { bodyAt, FAMILIES, isIn } from "./families";

export function bodiesPanel(session: Session): { element: HTMLElement; sheet: Sheet } {
  let family = FAMILIES[0]!;
  /** Until the reader chooses a plane: the first one in which the body lies. */
  let chosen = false;
  let borders: Border[] = [];
  let asked = false;
  let known: Catalogue | undefined;
  const canvas = make("canvas", { tabIndex: 0, attributes: { role: "application", "aria-label": "Map of classes of bodies: drag the point" }, data: { testid: "bodies-map" } });
  const text = make("div", { className: "note" });
  const list = make("div", { className: "note", data: { testid: "borders" } });
  const cells = new Cells(() => show());
  const stop = button("Stop", "Stop the computation", () => cells.stop(), { testid: "stop-map" });
  stop.hidden = true;
  const sheet = new Sheet(canvas, (pen, size) => paintBodies(pen, size, session.state, family, cells, borders));
  const show = () => {
    const place = family.place(session.state);
    const cell = place && cells.at(family, ...place);
    const name = cell && cells.names[cell.class];
    if (name && !asked) {
      asked = true;
      // Where it cannot be had, classes keep their names alone.
      loaded().then((found) => ((known = found), show()), () => undefined);
    }
    const words = name && known ? ` (${described(known, name)})` : "";
    const here = name ? `Here: ${cell.regions} regions, class ${name}${words}.` : place ? (cell ? "Here: on a border, or not a body." : "") : "The current body does not lie in this plane.";
    text.textContent = cells.message || `${here} ${cells.classes} classes seen, ${cells.share < 0.999 ? `${Math.round(100 * cells.share)} %` : "complete"}`;
    list.textContent = borders.length > 0 ? `Nearest borders: ${borders.map((border) => border.text).join("; ")}` : "";
    stop.hidden = !cells.running;
    sheet.ask();
  };
  const seek = async () => {
    borders = [];
    const { A, r } = session.state;
    const found = await bordersOf(cells.channel, family, { A, r }, (x, y) => cells.at(family, x, y)?.class, FINEST).catch(() => []);
    if (session.state.A !== A || session.state.r !== r) return;
    borders = found;
    show();
  };
  const fill = async () => {
    borders = [];
    await cells.fill(family, session.state);
    if (cells.share > 0.999) await seek();
  };
  const choice = make("select", { attributes: { "aria-label": "plane" } }, ...FAMILIES.map(({ id, title }) => make("option", { value: id }, title)));
  choice.addEventListener("change", () => {
    family = FAMILIES.find(({ id }) => id === choice.value)!;
    chosen = true;
    void fill();
  });
  drag(canvas, {
    start: () => ((session.dragging = "body"), true),
    move: (event) => {
      const { x, y, side } = boxOf(sheet.size);
      const [px, py] = sheet.place(event);
      const inside = (share: number, [from, to]: [number, number]) => from + Math.min(0.9999, Math.max(0.0001, share)) * (to - from);
      const body = bodyAt(family, inside((px - x) / side, family.x), inside(1 - (py - y) / side, family.y), session.state);
      if (body) session.body(body.A, body.r);
    },
    end: () => session.release(),
  });
  session.on(["body", "theme"], () => ((borders = []), show()));
  let seen = false;
  let last = "";
  session.on(["atlas"], () => {
    if (!chosen) family = FAMILIES.find((plane) => isIn(plane, session.state)) ?? family;
    choice.value = family.id;
    // A plane through the present body is another plane when the body has moved out of it.
    const key = family.id === "katok" || family.id === "eta" ? family.id : family.id === "moments" ? session.state.r.join() : session.state.A.join();
    const stale = key !== last || cells.share === 0;
    last = key;
    if (stale) cells.clear();
    if (seen) void (stale ? fill() : seek());
  });
  // Nothing is computed for a map that nobody sees.
  new IntersectionObserver((entries) => {
    seen = entries.some((entry) => entry.isIntersecting);
    if (seen && cells.share === 0 && session.atlas) void fill();
  }).observe(canvas);
  const element = panel("The space of bodies", "Bodies of the same colour have diagrams of the same shape", make("div", { className: "bar" }, choice, stop), make("div", { className: "stage map" }, canvas), make("div", { className: "bar" }, text, list));
  return { element, sheet };
}
