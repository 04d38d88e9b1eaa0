/** What hands do on a diagram: press and drag sets the point, with shift, two fingers or the middle button it moves the picture; wheel and
 * pinch zoom. One finger taps, drags the point by its handle or after a long press, and else scrolls the page. */
import { Finger } from "../draw/press";

interface Handlers {
  ready: () => boolean;
  /** The place of a pointer in the picture. */
  place: (event: MouseEvent) => Place;
  /** Whether the point is within a finger's reach. */
  handle: (x: number, y: number) => boolean;
  point: (x: number, y: number) => void;
  pan: (dx: number, dy: number) => void;
  zoom: (at: Place, factor: number) => void;
  /** Whether the picture zooms; else the wheel scrolls the page. */
  zooms: () => boolean;
  start: (what: "point" | "view") => void;
  end: () => void;
  hover: (x: number, y: number) => void;
  leave: () => void;
}

type Place = [number, number];

export function gestures(canvas: HTMLCanvasElement, handlers: Handlers): void {
  const { place } = handlers;
  const fingers = new Map<number, Place>();
  let mode: "point" | "view" | null = null;
  const begin = (what: "point" | "view") => {
    mode = what;
    handlers.start(what);
  };
  const set = (event: PointerEvent) => {
    begin("point");
    handlers.point(...place(event));
  };
  const end = () => {
    mode = null;
    handlers.end();
  };
  // A point taken by its handle stays where it is until the finger moves.
  const finger = new Finger(canvas, (event) => (handlers.handle(...place(event)) ? begin("point") : set(event)), (event) => (set(event), end()));
  canvas.addEventListener("pointerdown", (event) => {
    if (!handlers.ready() || event.button === 2) return;
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, place(event));
    if (event.pointerType !== "mouse" && fingers.size === 1) return finger.down(event, handlers.handle(...place(event)));
    finger.up();
    if (fingers.size > 1 || event.shiftKey || event.button === 1) begin("view");
    else set(event);
  });
  canvas.addEventListener("pointermove", (event) => {
    const now = place(event);
    const before = fingers.get(event.pointerId);
    if (!before) return handlers.hover(...now);
    fingers.set(event.pointerId, now);
    finger.move(event);
    if (mode === "point") handlers.point(...now);
    else if (mode === "view" && fingers.size === 1) handlers.pan(now[0] - before[0], now[1] - before[1]);
    else if (mode === "view") pinch(fingers, event.pointerId, before, handlers);
  });
  const stop = (event: PointerEvent) => {
    if (!fingers.delete(event.pointerId) || fingers.size > 0) return;
    if (mode !== null) end();
    finger.up(event);
  };
  canvas.addEventListener("pointerup", stop);
  canvas.addEventListener("pointercancel", stop);
  canvas.addEventListener("pointerleave", handlers.leave);
  canvas.addEventListener("wheel", (event) => {
    if (!handlers.ready() || !handlers.zooms()) return;
    event.preventDefault();
    handlers.zoom(place(event), Math.exp(0.0016 * event.deltaY * (event.deltaMode === 1 ? 30 : 1)));
  }, { passive: false });
  canvas.addEventListener("dblclick", (event) => handlers.zoom(place(event), 0.4));
}

function pinch(fingers: Map<number, Place>, moved: number, before: Place, handlers: Handlers): void {
  const other = [...fingers].find(([id]) => id !== moved)?.[1];
  const now = fingers.get(moved);
  if (!other || !now) return;
  const distance = (p: Place) => Math.hypot(p[0] - other[0], p[1] - other[1]) || 1;
  handlers.pan((now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
  handlers.zoom([(now[0] + other[0]) / 2, (now[1] + other[1]) / 2], distance(before) / distance(now));
}
