/** A canvas as sharp as the screen, and pictures of it as files. */
import { inTurn } from "./turns";

export interface Size {
  width: number;
  height: number;
}

export type Pen = CanvasRenderingContext2D;

/** A panel's canvas: it calls `paint` when it was asked to, once a frame and while it can be seen, in CSS pixels. */
export class Sheet {
  readonly pen: Pen;
  size: Size = { width: 0, height: 0 };
  private asked = false;
  private seen = true;
  /** Whether it was asked to paint while nobody could see it. */
  private stale = false;

  constructor(
    readonly element: HTMLCanvasElement,
    private readonly paint: (pen: Pen, size: Size) => void,
  ) {
    this.pen = element.getContext("2d")!;
    new ResizeObserver(() => this.resize()).observe(element);
    new IntersectionObserver((entries) => {
      this.seen = entries.at(-1)!.isIntersecting;
      if (this.seen && this.stale) this.now();
    }).observe(element);
    addEventListener("beforeprint", () => this.painted());
  }

  /** Paints with the next frame. */
  ask(): void {
    if (this.asked || (this.stale = !this.seen)) return;
    this.asked = true;
    requestAnimationFrame(() => this.now());
  }

  /** Paints with one of the next frames. */
  askInTurn(): void {
    if (!this.asked && !(this.stale = !this.seen)) inTurn(this.turn);
  }

  private readonly turn = (): void => this.now();

  /** Paints at once. */
  now(): void {
    this.asked = this.stale = false;
    if (this.size.width === 0) this.measure();
    if (this.size.width === 0) return;
    const scale = this.element.width / this.size.width;
    this.pen.setTransform(scale, 0, 0, scale, 0, 0);
    this.pen.clearRect(0, 0, this.size.width, this.size.height);
    this.paint(this.pen, this.size);
  }

  /** With what it would show if it were seen. */
  painted(): this {
    if (this.stale || this.asked) this.now();
    return this;
  }

  /** Paints on another pen, such as one that writes SVG. */
  onto(pen: Pen): void {
    this.paint(pen, this.size);
  }

  /** The place of a pointer in CSS pixels of the canvas. */
  place(event: { clientX: number; clientY: number }): [number, number] {
    const box = this.element.getBoundingClientRect();
    // A panel that is shown large is magnified.
    const scale = box.width > 0 ? this.element.clientWidth / box.width : 1;
    return [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
  }

  private measure(): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    const magnified = width > 0 ? this.element.getBoundingClientRect().width / width : 1;
    const scale = Math.min(3, (window.devicePixelRatio || 1) * magnified);
    this.size = { width, height };
    this.element.width = Math.round(width * scale);
    this.element.height = Math.round(height * scale);
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (width === this.size.width && height === this.size.height) return;
    this.measure();
    this.now();
  }
}

/** Pixels on their way to a canvas, kept for the next picture of the same size. */
export class Pixels {
  image = new ImageData(1, 1);
  private readonly canvas = document.createElement("canvas");

  /** As large as asked, with what was in it before. */
  sized(width: number, height: number): ImageData {
    if (this.image.width !== width || this.image.height !== height) {
      this.image = new ImageData(width, height);
      Object.assign(this.canvas, { width, height });
    }
    return this.image;
  }

  draw(pen: Pen, x: number, y: number, width: number, height: number): void {
    this.canvas.getContext("2d")!.putImageData(this.image, 0, 0);
    pen.drawImage(this.canvas, x, y, width, height);
  }
}

/** The power of ten in whose units the numbers of an axis are written: 0 unless they would be long. */
export function powerOf(from: number, to: number): number {
  const power = Math.floor(Math.log10(Math.max(Math.abs(from), Math.abs(to))));
  return power > 4 || power < -3 ? power : 0;
}

/** Round numbers for an axis: about `count` of them in [from, to], and the text of each with digits enough to tell them apart. */
export function ticks(from: number, to: number, count: number): { value: number; text: string }[] {
  const raw = (to - from) / count;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = power * ([1, 2, 5, 10].find((factor) => factor * power >= raw) ?? 10);
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const list: { value: number; text: string }[] = [];
  for (let k = Math.ceil(from / step); k * step <= to; k++) {
    const value = k * step;
    list.push({ value, text: digits > 20 ? value.toExponential(4) : value.toFixed(digits).replace("-", "−") });
  }
  return list;
}
