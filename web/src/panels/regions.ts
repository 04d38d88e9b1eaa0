/** The table of regions: the command line's ids, and what lies over each. */
import type { Region } from "../bindings/documents";
import { make, panel } from "../draw/dom";
import { css, ink, tint } from "../draw/theme";
import { shown, surface } from "../state/numbers";
import type { Session } from "../state/session";

export const typeOf = (region: Region): string => region.signature ?? region.components.map((component) => component.accessible_region).join("+");

export const circlesOf = (region: Region): number => region.components.reduce((sum, component) => sum + component.boundary_circles, 0);

const joined = (names: (string | null)[]): string => names.map((name) => (name === null ? "–" : surface(name))).join(" + ");

function row(session: Session, region: Region, dark: boolean): HTMLTableRowElement {
  const swatch = make("i", { className: "swatch" });
  swatch.style.background = css(tint(typeOf(region), circlesOf(region), dark));
  const { components } = region;
  const element = make(
    "tr",
    { tabIndex: 0, title: `Go to the sample of ${region.id}: h = ${shown(region.sample.h)}, l = ${shown(region.sample.l)}`, data: { testid: "region-row", region: region.id, signature: region.signature ?? "" } },
    make("td", {}, swatch, region.id),
    make("td", {}, joined(components.map((component) => component.section))),
    make("td", {}, joined(components.map((component) => component.accessible_region))),
    make("td", {}, joined(components.map((component) => component.energy_surface))),
  );
  const go = () => session.point({ h: String(region.sample.h), l: String(region.sample.l) });
  element.addEventListener("click", go);
  element.addEventListener("keydown", (event) => event.key === "Enter" && go());
  element.addEventListener("pointerenter", () => session.pointAt({ region: region.id }));
  element.addEventListener("pointerleave", () => session.pointAt({}));
  return element;
}

export function regionsPanel(session: Session): HTMLElement {
  const body = make("tbody", {});
  const head = make("tr", {}, ...["", "P", "U", "E"].map((name, i) => make("th", { title: ["", "the section", "the accessible region on the sphere", "the energy surface"][i]! }, name)));
  const caption = make("p", { className: "note" });
  let shownDocument: unknown;
  const show = () => {
    const document = session.dragging === "body" ? session.drawn?.document : (session.atlas ?? session.drawn?.document);
    const { dark } = ink();
    if (!document) {
      shownDocument = undefined;
      body.replaceChildren();
      caption.textContent = "";
      return;
    }
    if (document === shownDocument) return;
    shownDocument = document;
    const focused = (globalThis.document.activeElement as HTMLElement | null)?.dataset.region;
    body.replaceChildren(...document.regions.map((region) => row(session, region, dark)));
    if (focused) body.querySelector<HTMLElement>(`[data-region="${focused}"]`)?.focus();
    const exact = document === session.atlas;
    caption.textContent = `${document.regions.length} regions, ${document.events.length} events; ${exact ? (document.summary.complete ? "complete" : "not everything could be decided") : "while moving"}`;
    mark();
  };
  const mark = () => {
    const lit = session.hover.region ?? session.known.region ?? "";
    for (const element of body.rows) element.classList.toggle("lit", element.dataset.region === lit);
  };
  session.on(["drawing", "atlas"], show);
  session.on(["theme"], () => ((shownDocument = undefined), show()));
  session.on(["hover", "point"], mark);
  return panel("Regions", "U (accessible region), E (energy surface) and P (Poincaré section) have the same topology throughout a region", make("div", { className: "scroll" }, make("table", {}, make("thead", {}, head), body)), caption);
}
