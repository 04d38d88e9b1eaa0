/** Who wants to know of a change. */
export type Change = "body" | "drawing" | "atlas" | "point" | "section" | "orbits" | "selection" | "motion" | "hover" | "theme" | "message" | "guide" | "shadow" | "address" | "chaos" | "ready";

export class Emitter {
  private readonly listeners = new Map<Change, (() => void)[]>();

  on(changes: Change[], listener: () => void): void {
    for (const change of changes) this.listeners.set(change, [...(this.listeners.get(change) ?? []), listener]);
  }

  emit(change: Change): void {
    for (const listener of this.listeners.get(change) ?? []) listener();
  }
}
