/** The space of bodies: a map of classes; the present body is a point to drag in it. */
import { Sheet } from "../draw/canvas";
import { drag, near } from "../draw/press";
import { button, make, panel } from "../draw/dom";
import type { Session } from "../state/session";
import { boxOf, paintBodies } from "./bodies-paint";
import { bordersOf, type Border } from "./borders";
import { described, loaded, type Catalogue } from "./catalogue";
import { Cells, FINEST } from "./cells";
import { bodyAt, FAMILIES, isIn } from "./families";
import { guideTexts, texts, type Guide } from "../texts";

export function bodiesPanel(session: Session): { element: HTMLElement; sheet: Sheet } {
  let family = FAMILIES[0]!;
  /** Until the reader chooses a plane: the first one in which the body lies. */
  let chosen = false;
  let borders: Border[] = [];
  let asked = false;
  let known: { catalogue: Catalogue; words: Guide["classes"] } | undefined;
  const canvas = make("canvas", { tabIndex: 0, attributes: { role: "application", "aria-label": texts.bodies.canvas }, data: { testid: "bodies-map" } });
  const text = make("div", { className: "note" });
  const list = make("div", { className: "note", data: { testid: "borders" } });
  const cells = new Cells(() => show());
  const stop = button(texts.body.stop, texts.section.stopHelp, () => cells.stop(), { testid: "stop-map" });
  stop.hidden = true;
  const sheet = new Sheet(canvas, (pen, size) => paintBodies(pen, size, session.state, family, cells, borders));
  const show = () => {
    const place = family.place(session.state);
    const cell = place && cells.at(family, ...place);
    const name = cell && cells.names[cell.class];
    if (name && !asked) {
      asked = true;
      // Where it cannot be had, classes keep their names alone.
      Promise.all([loaded(), guideTexts()]).then(([catalogue, { classes }]) => ((known = { catalogue, words: classes }), show()), () => undefined);
    }
    const words = name && known ? ` (${described(known.catalogue, known.words, name)})` : "";
    const here = name ? texts.bodies.here(cell.regions, name, words) : place ? (cell ? texts.bodies.border : "") : texts.bodies.elsewhere;
    text.textContent = cells.message || `${here} ${texts.bodies.seen(cells.classes, cells.share < 0.999 ? `${Math.round(100 * cells.share)} %` : texts.bodies.complete)}`;
    list.textContent = borders.length > 0 ? texts.bodies.borders(borders.map((border) => border.text).join("; ")) : "";
    stop.hidden = !cells.running;
    if (cells.share > 0) delete element.dataset.blank;
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
  const choice = make("select", { attributes: { "aria-label": texts.bodies.plane } }, ...FAMILIES.map(({ id }) => make("option", { value: id }, texts.bodies.planes[id])));
  choice.addEventListener("change", () => {
    family = FAMILIES.find(({ id }) => id === choice.value)!;
    chosen = true;
    void fill();
  });
  const share = (value: number, [from, to]: [number, number]) => (value - from) / (to - from);
  const take = (across: number, up: number) => {
    const inside = (part: number, [from, to]: [number, number]) => from + Math.min(0.9999, Math.max(0.0001, part)) * (to - from);
    const body = bodyAt(family, inside(across, family.x), inside(up, family.y), session.state);
    if (body) session.body(body.A, body.r);
  };
  drag(canvas, {
    start: () => ((session.dragging = "body"), true),
    handle: (event) => {
      const { x, y, side } = boxOf(sheet.size);
      const place = family.place(session.state);
      return place !== null && near(sheet.place(event), [x + side * share(place[0], family.x), y + side * (1 - share(place[1], family.y))]);
    },
    move: (event) => {
      const { x, y, side } = boxOf(sheet.size);
      const [px, py] = sheet.place(event);
      take((px - x) / side, 1 - (py - y) / side);
    },
    end: () => session.release(),
  });
  canvas.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    const place = family.place(session.state);
    if (!step || !place) return;
    event.preventDefault();
    const far = event.shiftKey ? 0.05 : 0.005;
    take(share(place[0], family.x) + far * step[0]!, share(place[1], family.y) + far * step[1]!);
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
  const element = panel(texts.bodies.title, texts.bodies.help, make("div", { className: "bar" }, choice, stop), make("div", { className: "stage map" }, canvas), make("div", { className: "bar" }, text, list));
  element.dataset.blank = "";
  return { element, sheet };
}
