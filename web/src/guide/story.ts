/** A minute that plays itself: what the page shows, one panel after the other. A touch, a key or another address ends it. */
import { button, make } from "../draw/dom";
import { valueOf } from "../state/numbers";
import type { Session } from "../state/session";
import { FIRST, type State } from "../state/state";
import type { Scene } from "./scenes";
import { guideTexts, texts } from "../texts";

/** The page begins by itself after so many milliseconds without a touch. */
const PATIENCE = 5000;

export function story(session: Session): { card: HTMLElement; play: HTMLElement } {
  const text = make("p", {});
  const bar = make("div", { className: "progress" });
  const stop = button("×", texts.guide.storyEnd, () => end());
  const card = make("aside", { className: "story", hidden: true, attributes: { role: "status" }, data: { testid: "story" } }, text, stop, bar);
  let run = 0;
  const lit = (name: string | null) => {
    for (const panel of document.querySelectorAll<HTMLElement>("[data-panel]")) panel.classList.toggle("told", panel.dataset.panel === name);
  };
  const end = () => {
    if (card.hidden) return;
    run++;
    card.hidden = true;
    lit(null);
    session.address.quiet = false;
    if (session.dragging) session.release();
    else session.address.write();
  };
  const play = async () => {
    const own = ++run;
    card.hidden = false;
    session.address.quiet = true;
    const [{ STORY }, { story: words }] = await Promise.all([import("./scenes"), guideTexts()]);
    for (const [i, scene] of STORY.entries()) {
      if (own !== run) return;
      const { theme, embed, present } = session.state;
      if (scene.state) session.set({ ...FIRST, theme, embed, present, ...scene.state });
      text.textContent = words[i]!;
      bar.style.width = `${(100 * (i + 1)) / STORY.length}%`;
      lit(scene.panel);
      const panel = document.querySelector(`[data-panel="${scene.panel}"]`);
      // Within another page that would scroll, too.
      if (panel && parent === window && panel.getBoundingClientRect().bottom > innerHeight) panel.scrollIntoView({ behavior: "smooth", block: "center" });
      await move(session, scene, () => own === run);
    }
    end();
  };
  // On the way down, before any panel has it.
  for (const kind of ["pointerdown", "keydown", "wheel"] as const) addEventListener(kind, () => (idle(), end()), { capture: true, passive: true });
  addEventListener("hashchange", () => (idle(), end()));
  let clock: ReturnType<typeof setTimeout> | undefined;
  const idle = () => {
    waiting = false;
    clearTimeout(clock);
  };
  let waiting = location.hash.length <= 1 && !matchMedia("(prefers-reduced-motion: reduce)").matches;
  // From when there is something to tell of, however long that took to load.
  session.on(["ready"], () => {
    if (waiting) clock = setTimeout(() => void play(), PATIENCE);
    waiting = false;
  });
  return { card, play: button(`▶ ${texts.guide.story}`, texts.guide.storyHelp, () => void play(), { testid: "play-story" }) };
}

/** A scene's time, in which a hand moves slowly, holds, and lets go. */
async function move(session: Session, { seconds, point, r }: Scene, current: () => boolean): Promise<void> {
  const begun = performance.now();
  const last = () => new Promise((next) => setTimeout(next, Math.min(100, 1000 * seconds)));
  const from = session.state;
  let moved = false;
  for (let share = 0; share < 1 && current(); share = (performance.now() - begun) / 1000 / seconds) {
    const way = Math.min(1, Math.max(0, (share - 0.2) / 0.5));
    if ((point || r) && way > 0 && way < 1) {
      moved = true;
      session.dragging = point ? "point" : "body";
      const between = (a: number, b: number) => (a + way * (b - a)).toFixed(4);
      if (point && from.point) session.point({ h: between(valueOf(from.point.h), point[0]), l: between(valueOf(from.point.l), point[1]) });
      if (r) session.body(from.A, r.map((x, i) => between(valueOf(from.r[i]!), x)) as State["r"]);
      await new Promise((next) => setTimeout(next, 33));
      continue;
    }
    if (moved && session.dragging) {
      if (point) session.point({ h: String(point[0]), l: String(point[1]) });
      session.release();
      moved = false;
    }
    await last();
  }
}
