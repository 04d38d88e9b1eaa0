/** A few lines beside the pointer. */
import type { Size } from "./canvas";
import { make } from "./dom";

/** Shows lines beside a place of a panel, within its bounds; no lines hide it. */
export function tipAt(tip: HTMLElement, size: Size, [x, y]: [number, number], lines: string[]): void {
  tip.hidden = lines.length === 0;
  if (tip.hidden) return;
  tip.replaceChildren(...lines.map((line) => make("div", {}, line)));
  tip.style.left = `${Math.max(0, Math.min(x + 14, size.width - tip.offsetWidth - 4))}px`;
  tip.style.top = `${y + 16 + tip.offsetHeight > size.height ? Math.max(0, y - tip.offsetHeight - 8) : y + 16}px`;
}
