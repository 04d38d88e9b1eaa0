/** The address of the page, which follows what is settled. */
import type { Emitter } from "./emitter";
import { format } from "./hash";
import type { State } from "./state";

/** Milliseconds within which steps are one entry of the history. */
const STEPS = 700;

export class Address {
  /** True while the page shows something by itself: the address stays. */
  quiet = false;
  /** What is wrong is not written. */
  failed = false;
  /** Whether it was just opened, or stays as it is wrong. */
  opened: boolean | "wrong" = true;
  private written = 0;

  constructor(private readonly owner: Emitter & { readonly state: State }) {}

  /** Each rest is a step to go back to, unless it only looks at the same in another way. */
  write(replace = false): void {
    const hash = `#${format(this.owner.state)}`;
    if (this.quiet || this.failed || this.opened === "wrong" || hash === location.hash) return;
    const now = performance.now();
    if (replace || this.opened || now - this.written < STEPS) history.replaceState(null, "", hash);
    else history.pushState(null, "", hash);
    this.written = now;
    this.owner.emit("address");
  }
}
