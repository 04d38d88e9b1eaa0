/** The table of regions: the command line's ids, and what lies over each. */
import type { Region } from "../bindings/documents";
import { make, panel } from "../draw/dom";
import { css, ink, tint } from "../draw/theme";
import { listed } from "../state/words";
import { typeOf } from "../state/names";
import { steadyTable } from "./steady";
import { shown, surface } from "../state/numbers";
import type { Session } from "../state/session";

export const circlesOf = (region: Region): number => region.components.reduce((sum, component) => sum + component.boundary_circles, 0);

/** Types as signs, with what they mean beside the pointer. */
const cell = (names: (string | null)[]): HTMLTableCellElement => make("td", { title: listed(names) }, joined(names));

const joined = (names: (string | null)[]): string => names.map((name) => (name === null ? "–" : surface(name))).join(" + ");

function row(session: Session, region: Region, dark: boolean): HTMLTableRowElement {
  const swatch = make("i", { className: "swatch" });
  swatch.style.background = css(tint(typeOf(region), circlesOf(region), dark));
  const { components } = region;
  const element = make(
    "tr",
    { tabIndex: 0, title: `Go to the sample of ${region.id}: h = ${shown(region.sample.h)}, l = ${shown(region.sample.l)}`, data: { testid: "region-row", region: region.id, signature: region.signature ?? "" } },
    make("td", {}, swatch, region.id),
    cell(components.map((component) => component.section)),
    cell(components.map((component) => component.accessible_region)),
    cell(components.map((component) => component.energy_surface)),
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
  const head = make("tr", {}, ...["region", "P", "U", "E"].map((name, i) => make("th", { title: ["its id in documents", "the section: S² a sphere, T² a torus, M²₂ a surface of genus 2, which has two handles", "the accessible region on the sphere: D² a disc, S² the whole sphere, S²∖2D² a sphere with two holes", "the energy surface, of three dimensions"][i]! }, name)));
  const caption = make("p", { className: "note" });
  let shownDocument: string | undefined;
  const show = () => {
    const document = session.dragging === "body" ? session.drawn?.document : (session.atlas ?? session.drawn?.document);
    const { dark } = ink();
    if (!document) {
      shownDocument = undefined;
      body.replaceChildren();
      caption.textContent = "";
      return;
    }
    // Under the hand a body keeps its regions for many frames: rows are made anew where one differs.
    const key = `${dark}${JSON.stringify(document.regions.map(({ id, signature, components, sample }) => [id, signature, components, session.dragging ? 0 : sample]))}`;
    const exact = document === session.atlas;
    caption.textContent = `${document.regions.length} regions, ${document.events.length} events; ${exact ? (document.summary.complete ? "complete, exact" : "not everything could be decided") : "while moving"}`;
    if (key === shownDocument) return;
    shownDocument = key;
    const focused = (globalThis.document.activeElement as HTMLElement | null)?.dataset.region;
    body.replaceChildren(...document.regions.map((region) => row(session, region, dark)));
    if (focused) body.querySelector<HTMLElement>(`[data-region="${focused}"]`)?.focus();
    mark();
  };
  const mark = () => {
    const lit = session.hover.region ?? session.known.region ?? "";
    for (const element of body.rows) element.classList.toggle("lit", element.dataset.region === lit);
  };
  session.on(["drawing", "atlas"], show);
  session.on(["theme"], () => ((shownDocument = undefined), show()));
  session.on(["hover", "point"], mark);
  return panel("Regions", "Within a region the motions have the same shape: U is the accessible region, E the energy surface and P the Poincaré section. Signs: D² disc, S² sphere, T² torus, M²₂ surface of genus 2, that is with two handles; + joins separate pieces. Click on a row to go there. “Decided exactly” means with certainty: by exact arithmetic wherever rounding could mislead", make("div", { className: "scroll" }, make("table", {}, make("thead", {}, head), body), steadyTable(session)), caption);
}
