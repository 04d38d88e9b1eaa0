/** `window.bifdiag`: what tests and tools ask of the page. */
import { AT, ROW } from "./state/orbits";
import type { Window as View } from "./bindings/documents";
import type { Share } from "./state/chaos";
import type { Session } from "./state/session";
import { StraightChart } from "./state/straight";

export interface Crossings {
  orbit: number[];
  index: number[];
  theta: number[];
  psi: number[];
  sheet: number[];
}

declare global {
  interface Window {
    bifdiag: { atlas: () => string; frames: () => number[]; crossings: () => Crossings; rate: () => number; window: () => View | null; suited: () => View | null; shadow: () => boolean; place: (h: number, l: number) => [number, number] | null; chaos: () => { cells: number; running: boolean; at: (h: number, l: number, region: number, component: number) => Share | null | undefined }; straight: () => { columns: number[]; curves: Record<string, number[]> } | null };
  }
}

export function api(session: Session): void {
  window.bifdiag = {
    atlas: () => session.text,
    frames: () => [...session.frames],
    crossings: () => {
      const found: Crossings = { orbit: [], index: [], theta: [], psi: [], sheet: [] };
      for (const rows of session.orbits.rows) {
        for (let at = 0; at < rows.length; at += ROW) {
          for (const name of ["orbit", "index", "theta", "psi", "sheet"] as const) found[name].push(rows[at + AT[name]]!);
        }
      }
      return found;
    },
    window: () => session.drawn?.window ?? null,
    suited: () => session.drawn?.document.drawing.view.main ?? null,
    shadow: () => session.picture.shadow !== null,
    place: (h, l) => session.drawn?.chart.place(h, l) ?? null,
    chaos: () => ({ cells: session.chaos.summary?.level.cells ?? 0, running: session.chaos.running, at: (...place) => session.chaos.at(...place) }),
    straight: () => {
      const { chart, curves } = session.drawn ?? {};
      return chart instanceof StraightChart ? { columns: [...chart.drawing.columns], curves: Object.fromEntries([...curves!].map(([name, points]) => [name, [...points]])) } : null;
    },
    rate: () => session.orbits.count / session.orbits.seconds,
  };
}
