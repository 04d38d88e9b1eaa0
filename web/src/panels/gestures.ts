/** What hands do on a diagram: press and drag sets the point, with shift, two fingers or the middle button it moves the picture; wheel and pinch zoom. */

interface Handlers {
  ready: () => boolean;
  point: (x: number, y: number) => void;
  pan: (dx: number, dy: number) => void;
  zoom: (at: [number, number], factor: number) => void;
  start: (what: "point" | "view") => void;
  end: () => void;
  hover: (x: number, y: number) => void;
  leave: () => void;
}

type Place = [number, number];

/** A finger that moves less than this, in pixels, lies still. */
const SLIP = 4;

export function gestures(canvas: HTMLCanvasElement, handlers: Handlers): void {
  const fingers = new Map<number, Place>();
  let mode: "point" | "view" | null = null;
  /** A finger that lies still: the first of two, or one that will tap or drag. */
  let still = false;
  let touched: Place = [0, 0];
  const place = (event: MouseEvent): Place => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const begin = (what: "point" | "view") => {
    mode = what;
    handlers.start(what);
  };
  canvas.addEventListener("pointerdown", (event) => {
    if (!handlers.ready() || event.button === 2) return;
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, place(event));
    still = event.pointerType === "touch" && fingers.size === 1;
    touched = place(event);
    if (still) return;
    begin(fingers.size > 1 || event.shiftKey || event.button === 1 ? "view" : "point");
    if (mode === "point") handlers.point(...place(event));
  });
  canvas.addEventListener("pointermove", (event) => {
    const now = place(event);
    const before = fingers.get(event.pointerId);
    if (!before) return handlers.hover(...now);
    fingers.set(event.pointerId, now);
    if (still) {
      if (Math.hypot(now[0] - touched[0], now[1] - touched[1]) < SLIP) return;
      still = false;
      begin("point");
    }
    if (mode === "point") handlers.point(...now);
    else if (fingers.size === 1) handlers.pan(now[0] - before[0], now[1] - before[1]);
    else pinch(fingers, event.pointerId, before, handlers);
  });
  const stop = (event: PointerEvent) => {
    if (!fingers.delete(event.pointerId) || fingers.size > 0) return;
    if (still && event.type === "pointerup") {
      begin("point");
      handlers.point(...place(event));
    }
    const idle = mode === null;
    still = false;
    mode = null;
    if (idle) return;
    handlers.end();
  };
  canvas.addEventListener("pointerup", stop);
  canvas.addEventListener("pointercancel", stop);
  canvas.addEventListener("pointerleave", handlers.leave);
  canvas.addEventListener("wheel", (event) => {
    if (!handlers.ready()) return;
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
