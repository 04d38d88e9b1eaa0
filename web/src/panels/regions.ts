/** The table of regions: the command line's ids, and what lies over each. */
import type { Region } from "../bindings/documents";
import { make, panel } from "../draw/dom";
import { css, ink, tint, type Rgb } from "../draw/theme";
import { inTurn } from "../draw/turns";
import { listed } from "../state/words";
import { typeOf } from "../state/names";
import { steadyTable } from "./steady";
import { shown, surface } from "../state/numbers";
import type { Session } from "../state/session";
import { texts } from "../texts";

const circlesOf = (region: Region): number => region.components.reduce((sum, component) => sum + component.boundary_circles, 0);

/** The colour of a region: of its ground in the diagram, its swatch and U on the sphere. */
export const colorOf = (region: Region, dark: boolean): Rgb => tint(typeOf(region), circlesOf(region), dark);

/** Types as signs, with what they mean beside the pointer. */
const cell = (names: (string | null)[]): HTMLTableCellElement => make("td", { title: listed(names) }, joined(names));

const joined = (names: (string | null)[]): string => names.map((name) => (name === null ? "–" : surface(name))).join(" + ");

function row(session: Session, region: Region, dark: boolean): HTMLTableRowElement {
  const swatch = make("i", { className: "swatch" });
  swatch.style.background = css(colorOf(region, dark));
  const { components } = region;
  const element = make(
    "tr",
    { tabIndex: 0, title: texts.regions.goTo(region.id, shown(region.sample.h), shown(region.sample.l)), data: { testid: "region-row", region: region.id, signature: region.signature ?? "" } },
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
  const { region, regionHelp, P, U, E } = texts.regions;
  const columns: [string, string][] = [[region, regionHelp], ["P", P], ["U", U], ["E", E]];
  const head = make("tr", {}, ...columns.map(([name, title]) => make("th", { title }, name)));
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
    caption.textContent = texts.regions.count(document.regions.length, document.events.length, exact ? (document.summary.complete ? texts.regions.complete : texts.regions.incomplete) : texts.regions.moving);
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
  session.on(["drawing", "atlas"], () => (session.dragging === "body" ? inTurn(show) : show()));
  session.on(["theme"], () => ((shownDocument = undefined), show()));
  session.on(["hover", "point"], mark);
  return panel(texts.regions.title, texts.regions.help, make("div", { className: "scroll" }, make("table", {}, make("thead", {}, head), body), steadyTable(session)), caption);
}
