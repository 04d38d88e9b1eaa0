/** Work that may wait for a frame or few while a hand moves the body, so that what the hand moves is there in time. */

/** Milliseconds between two frames after which one counts as late, and how many frames then have one piece of work each. */
const [LATE, LIGHT] = [25, 30];

const waiting = new Set<() => void>();
let before = -Infinity;
let light = 0;

/** Calls with the next frame, once however often it is asked; after a late frame those who wait have their turns, one a frame. */
export function inTurn(work: () => void): void {
  if (waiting.size === 0) requestAnimationFrame(next);
  waiting.add(work);
}

function next(time: number): void {
  // A longer pause is one of the hand.
  if (time - before > LATE && time - before < 4 * LATE) light = LIGHT;
  else light = Math.max(0, light - 1);
  before = time;
  const now = light > 0 ? [...waiting].slice(0, 1) : [...waiting];
  for (const work of now) waiting.delete(work);
  if (waiting.size > 0) requestAnimationFrame(next);
  for (const work of now) work();
}
