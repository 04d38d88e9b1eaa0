/** The Poincaré section on the PP-torus: two sheets T⁺ and T⁻ over the same angles, glued along ∂U; orbits as they are computed. */
import { Sheet, type Pen, type Size } from "../draw/canvas";
import { button, make, panel } from "../draw/dom";
import { tipAt } from "../draw/tip";
import { AT, ROW } from "../state/orbits";
import type { Session } from "../state/session";
import type { Coloring } from "../state/state";
import type { Clock } from "./clock";
import { scaleText } from "./orbit-colors";
import { drawStill, halves, paintMoving, placeOf, TAU } from "./section-paint";
import { orbitLine, verdicts } from "./verdicts";
import { texts } from "../texts";

/** A crossing no farther than this from the pointer, in pixels, is the one that is meant. */
const REACH = 5;

const COLORINGS: readonly Coloring[] = ["orbit", "verdict", "lyapunov", "rotation"];

export function sectionPanel(session: Session, clock: Clock): { element: HTMLElement; sheet: Sheet } {
  const { orbits } = session;
  const canvas = make("canvas", { tabIndex: 0, attributes: { role: "application", "aria-label": texts.section.canvas }, data: { testid: "section" } });
  let cursor: { psi: number; theta: number } | null = null;
  let still: HTMLCanvasElement | null = null;
  /** What the points of `still` are. */
  let drawn = "";
  const paint = (pen: Pen, size: Size) => {
    still = still ?? drawStill(session, size, pen.canvas.width ? pen.canvas.width / size.width : 1);
    pen.drawImage(still, 0, 0, size.width, size.height);
    paintMoving(pen, size, session, clock, cursor);
  };
  const sheet = new Sheet(canvas, paint);
  const anew = () => {
    still = null;
    sheet.ask();
  };
  const angles = (event: MouseEvent) => {
    const [x, y] = sheet.place(event);
    const half = halves(sheet.size).find((half) => x >= half.x && x <= half.x + half.width && y >= half.y && y <= half.y + half.height);
    return half && { psi: ((x - half.x) / half.width) * TAU, theta: ((y - half.y) / half.height) * Math.PI, sheet: half.sheet };
  };
  const tip = make("div", { className: "tip", hidden: true, data: { testid: "orbit-tip" } });
  canvas.addEventListener("pointermove", (event) => {
    cursor = angles(event) ?? null;
    sheet.ask();
    const place = sheet.place(event);
    if (place[1] < 22) return tipAt(tip, sheet.size, place, texts.section.halves);
    const orbit = orbitAt(session, sheet.size, place);
    const found = orbit === null ? undefined : orbits.judged[orbit];
    tipAt(tip, sheet.size, place, found ? [orbitLine(found), found.reason] : []);
  });
  canvas.addEventListener("pointerleave", () => {
    cursor = null;
    tip.hidden = true;
    sheet.ask();
  });
  const begin = (place: { psi: number; theta: number; sheet: number } | undefined) => {
    if (!place || !orbits.portrait) return;
    note.textContent = "";
    void orbits.start(place.theta, place.psi % TAU, place.sheet, session.state.crossings).catch((error: Error) => (note.textContent = error.message));
  };
  canvas.addEventListener("click", (event) => begin(angles(event)));
  // The cross of the keyboard: on the left half, with shift on the right one.
  canvas.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (!step && event.key !== "Enter") return;
    event.preventDefault();
    cursor ??= { psi: Math.PI, theta: Math.PI / 2 };
    if (step) cursor = { psi: Math.min(TAU, Math.max(0, cursor.psi + (step[0]! * TAU) / 60)), theta: Math.min(Math.PI, Math.max(0, cursor.theta + (step[1]! * Math.PI) / 60)) };
    else begin({ ...cursor, sheet: event.shiftKey ? -1 : 1 });
    sheet.ask();
  });
  const count = make("b", { data: { testid: "crossing-count" } }, "0");
  const note = make("span", { className: "note" });
  const stop = button(texts.body.stop, texts.section.stopHelp, () => orbits.stop());
  stop.hidden = true;
  const coloring = make("select", { title: texts.section.colorsHelp, attributes: { "aria-label": texts.section.colorsLabel } });
  for (const value of COLORINGS) coloring.append(make("option", { value }, texts.section.colors[value]));
  coloring.addEventListener("change", () => session.update({ coloring: coloring.value as Coloring }, "orbits"));
  session.on(["orbits", "section"], () => {
    count.textContent = String(orbits.count);
    stop.hidden = !orbits.running;
    coloring.value = session.state.coloring;
    note.textContent = orbits.reason || scaleText(session);
    const { coloring: colors } = session.state;
    const points = [orbits.count, orbits.rows.length, colors, colors === "orbit" || orbits.judged.filter(Boolean).length].join();
    if (points === drawn) return;
    drawn = points;
    anew();
  });
  session.on(["section", "selection", "theme"], anew);
  session.on(["section"], () => (tip.hidden = true));
  new ResizeObserver(anew).observe(canvas);
  clock.on(() => session.dragging !== "body" && sheet.ask());
  const { legend, choice, reason } = verdicts(session);
  const bar = make("div", { className: "bar" }, count, make("span", { className: "counted" }, make("span", {}, texts.section.crossings), stop), coloring, choice, note);
  const element = panel(texts.section.title, texts.section.help, make("div", { className: "stage" }, canvas, tip), bar, reason);
  element.querySelector("header")!.append(legend);
  return { element, sheet };
}

/** The orbit that has a crossing nearest to a place of the picture, if one is within reach. */
function orbitAt(session: Session, size: Size, [px, py]: [number, number]): number | null {
  let [best, found]: [number, number | null] = [REACH * REACH, null];
  const [plus, minus] = halves(size);
  session.orbits.rows.forEach((rows, orbit) => {
    for (let at = 0; at < rows.length; at += ROW) {
      const [x, y] = placeOf(rows[at + AT.sheet]! > 0 ? plus : minus, rows[at + AT.psi]!, rows[at + AT.theta]!);
      const distance = (x - px) ** 2 + (y - py) ** 2;
      if (distance < best) [best, found] = [distance, orbit];
    }
  });
  return found;
}
