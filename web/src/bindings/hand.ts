/** The module on the page's own thread, for what a hand waits for and what takes a fraction of a millisecond. An answer from a worker
 * waits until the page has painted the frame that the question came with, and is seen a frame later. */
import type { Arguments, Drawing, Place } from "./calls";
import { compile } from "./client";

/** Milliseconds that an answer may take, and how many in a row may take longer before workers have the rest of the drag. */
const [LIMIT, LATE] = [50, 4];

export class Hand {
  private module: typeof import("./drawing") | undefined;
  private loading: Promise<void> | undefined;
  private late = 0;

  /** With the first drag, not with the page. */
  private begin(): void {
    this.loading ??= Promise.all([import("./drawing"), compile()])
      .then(async ([module, compiled]) => {
        await module.init({ module_or_path: compiled });
        this.module = module;
      })
      .catch(() => undefined);
  }

  /** The hand rests: what was slow may be quick with the next body. */
  rest(): void {
    this.late = 0;
  }

  /** Null: somebody else has to. */
  draw(...[body, view, width, height, point, how]: Arguments<"draw">): Drawing | null {
    return how ? null : this.timed((module) => module.plane(body, view, width, height, point));
  }

  locate(...place: Arguments<"locate">): Place | null {
    return this.timed((module) => module.locate(...place));
  }

  private timed<T>(what: (module: typeof import("./drawing")) => T): T | null {
    this.begin();
    if (!this.module || this.late >= LATE) return null;
    const from = performance.now();
    try {
      return what(this.module);
    } catch (error) {
      if (!(error instanceof WebAssembly.RuntimeError)) throw error;
      // After a trap the module's memory cannot be trusted; a worker tells what is wrong.
      this.module = undefined;
      return null;
    } finally {
      this.late = performance.now() - from > LIMIT ? this.late + 1 : 0;
    }
  }
}
