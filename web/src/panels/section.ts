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

/** A crossing no farther than this from the pointer, in pixels, is the one that is meant. */
const REACH = 5;

const COLORINGS: [Coloring, string][] = [["orbit", "colour: orbit"], ["verdict", "colour: verdict"], ["lyapunov", "colour: Lyapunov exponent"], ["rotation", "colour: rotation number"]];

export function sectionPanel(session: Session, clock: Clock): { element: HTMLElement; sheet: Sheet } {
  const { orbits } = session;
  const canvas = make("canvas", { tabIndex: 0, attributes: { role: "application", "aria-label": "Poincaré section: click to start an orbit" }, data: { testid: "section" } });
  let cursor: { psi: number; theta: number } | null = null;
  let still: HTMLCanvasElement | null = null;
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
    const orbit = orbitAt(session, sheet.size, place);
    const found = orbit === null ? undefined : orbits.judged[orbit];
    tipAt(tip, sheet.size, place, found ? [orbitLine(found), found.reason] : []);
  });
  canvas.addEventListener("pointerleave", () => {
    cursor = null;
    tip.hidden = true;
    sheet.ask();
  });
  canvas.addEventListener("click", (event) => {
    const place = angles(event);
    if (!place || !orbits.portrait) return;
    note.textContent = "";
    void orbits.start(place.theta, place.psi % TAU, place.sheet, session.state.crossings).catch((error: Error) => (note.textContent = error.message));
  });
  const count = make("b", { data: { testid: "crossing-count" } }, "0");
  const note = make("span", { className: "note" });
  const stop = button("Stop", "Stop the computation", () => orbits.stop());
  const coloring = make("select", { title: "What the colours of the points show", attributes: { "aria-label": "colours" } });
  for (const [value, text] of COLORINGS) coloring.append(make("option", { value }, text));
  coloring.addEventListener("change", () => session.update({ coloring: coloring.value as Coloring }, "orbits"));
  session.on(["orbits", "section"], () => {
    count.textContent = String(orbits.count);
    stop.hidden = !orbits.running;
    coloring.value = session.state.coloring;
    note.textContent = orbits.reason || scaleText(session);
    anew();
  });
  session.on(["selection"], anew);
  session.on(["theme"], anew);
  new ResizeObserver(anew).observe(canvas);
  clock.on(() => sheet.ask());
  const { legend, choice, reason } = verdicts(session);
  const bar = make("div", { className: "bar" }, count, " crossings ", stop, coloring, choice, note);
  const element = panel("Poincaré section", "Each orbit leaves a dot whenever its centre of mass is highest or lowest; the two halves are glued along the dark line", make("div", { className: "stage" }, canvas, tip), bar, reason);
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
