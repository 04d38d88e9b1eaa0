/** Presses and drags. A mouse drags at once; a finger scrolls the page unless it begins at a handle or has held still: a tap is a press and release. */

/** How long a finger holds still before it drags, in ms, and how far it may slip meanwhile, in pixels. */
const [HOLD, SLIP] = [350, 8];

/** How near to a handle a finger takes it, in pixels. */
const FINGER = 24;
export const near = ([x, y]: [number, number], [px, py]: [number, number]): boolean => Math.hypot(x - px, y - py) < FINGER;

export interface Drag {
  /** False: this press is not meant. */
  start?: (event: PointerEvent) => boolean;
  move: (event: PointerEvent) => void;
  end?: () => void;
  /** Whether a finger that comes down here drags at once. */
  handle?: (event: PointerEvent) => boolean;
  /** A finger that moves sideways drags too: what turns. */
  sideways?: boolean;
}

/** Tells a finger's intent: `begin` when it drags, `tap` when it was lifted without. */
export class Finger {
  /** True while a finger is down that has not shown what it means. */
  waiting = false;
  private first: PointerEvent | undefined;
  private clock: ReturnType<typeof setTimeout> | undefined;
  private holding = false;

  constructor(
    element: HTMLElement,
    private readonly begin: (event: PointerEvent) => void,
    private readonly tap: (event: PointerEvent) => void,
    private readonly sideways = false,
  ) {
    // Only here can a page keep a browser from scrolling after the finger came down.
    element.addEventListener("touchmove", (event) => (this.holding || event.touches.length > 1) && event.cancelable && event.preventDefault(), { passive: false });
    element.addEventListener("contextmenu", (event) => this.first && event.preventDefault());
  }

  down(event: PointerEvent, atOnce: boolean): void {
    this.first = event;
    if (atOnce) return this.take();
    this.waiting = true;
    this.clock = setTimeout(() => this.take(), HOLD);
  }

  move(event: PointerEvent): void {
    if (!this.waiting || !this.first) return;
    const [dx, dy] = [event.clientX - this.first.clientX, event.clientY - this.first.clientY];
    if (Math.hypot(dx, dy) < SLIP) return;
    if (this.sideways && Math.abs(dx) > Math.abs(dy)) this.take();
    else this.drop();
  }

  /** The finger is lifted, or belongs to another gesture now. */
  up(event?: PointerEvent): void {
    const tapped = this.waiting && event?.type === "pointerup";
    this.drop();
    this.holding = false;
    this.first = undefined;
    if (tapped) this.tap(event);
  }

  private take(): void {
    this.drop();
    this.holding = true;
    if (this.first) this.begin(this.first);
  }

  private drop(): void {
    clearTimeout(this.clock);
    this.waiting = false;
  }
}

/** Follows a pointer from its press to its release. */
export function drag(element: HTMLElement, { start, move, end, handle, sideways }: Drag): void {
  let held: number | undefined;
  let down: number | undefined;
  const begin = (event: PointerEvent) => {
    if (start && !start(event)) return;
    held = event.pointerId;
    move(event);
  };
  const finish = () => {
    held = undefined;
    end?.();
  };
  const finger = new Finger(element, begin, (event) => (begin(event), held !== undefined && finish()), sideways);
  element.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || down !== undefined) return;
    down = event.pointerId;
    element.setPointerCapture(event.pointerId);
    if (event.pointerType !== "mouse") finger.down(event, handle?.(event) ?? false);
    else begin(event);
  });
  element.addEventListener("pointermove", (event) => {
    if (event.pointerId !== down) return;
    finger.move(event);
    if (held === event.pointerId) move(event);
  });
  const stop = (event: PointerEvent) => {
    if (event.pointerId !== down) return;
    down = undefined;
    if (held !== undefined) finish();
    finger.up(event);
  };
  element.addEventListener("pointerup", stop);
  element.addEventListener("pointercancel", stop);
}
