/** Diagrams by the module, on whatever thread it is: a fast document of a body, kept as long as the body is asked for, and what is drawn of it. */
import type { Drawing, Place } from "./calls";
import type { Atlas, Window } from "./documents";
import init, * as guest from "./generated/bifdiag_web.js";

export { guest, init };

export interface Diagram {
  body: string;
  of: guest.Diagram;
  text: string;
  document: Atlas;
}

let diagram: Diagram | undefined;

export function diagramOf(body: string): Diagram {
  if (diagram?.body !== body) {
    const of = new guest.Diagram(body);
    const text = of.document();
    diagram?.of.free();
    diagram = { body, of, text, document: JSON.parse(text) as Atlas };
  }
  return diagram;
}

/** What any drawing begins with. `view`: what is to be seen; null: what suits the body. */
export function begun(body: string, view: Window | null, width: number, height: number, point: [number, number] | null) {
  const { text, document } = diagramOf(body);
  return { text, window: view ?? document.drawing.view.main, width, height, names: document.curves.map((curve) => curve.id), place: point && locate(body, ...point) };
}

/** The diagram in the plane. */
export function plane(body: string, view: Window | null, width: number, height: number, point: [number, number] | null): Drawing {
  const drawing = begun(body, view, width, height, point);
  const { h, l } = drawing.window;
  const { of } = diagramOf(body);
  const curves = of.curves(drawing.names, Math.max(0, l[0]), l[1], (h[1] - h[0]) / width / 3);
  return { ...drawing, rows: of.columns(l[0], l[1], height), curves, straight: null };
}

export function locate(body: string, h: number, l: number): Place {
  const { of } = diagramOf(body);
  const [region, distance] = of.locate(h, l) as unknown as [number, number];
  return { region, distance, nearest: of.nearest(h, l) };
}
