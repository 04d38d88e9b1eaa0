/** The point (h, l): exact texts, and what is known of it in words. */
import { make, panel } from "../draw/dom";
import { mark as markField, numberField } from "../draw/field";
import { inTurn } from "../draw/turns";
import { isNumber, shown, surface } from "../state/numbers";
import type { Session } from "../state/session";
import { inWords, listed } from "../state/words";
import { texts } from "../texts";

export function pointPanel(session: Session): HTMLElement {
  const input = (name: "h" | "l", meaning: string) => numberField(name, meaning, () => change());
  const h = input("h", texts.point.h);
  const l = input("l", texts.point.l);
  const change = () => {
    const [energy, momentum] = [h.value.trim(), l.value.trim()];
    if (energy && momentum) session.point({ h: energy, l: momentum });
    else if (!energy && !momentum) session.point(null);
  };
  const status = make("span", { title: texts.point.exactHelp, data: { testid: "point-status", status: "" } });
  const region = make("b", { data: { testid: "point-region", region: "" } });
  const signature = make("span", { data: { testid: "point-signature", signature: "" } });
  const margin = make("span", { className: "note" });
  const parts = make("div", { className: "components" });
  const sentence = make("p", { className: "sentence", attributes: { "aria-live": "polite" }, data: { testid: "surgery" } });
  // What a screen reader says once the hand rests: the region and what lies over it.
  const told = make("p", { className: "unseen", attributes: { role: "status" }, data: { testid: "told" } });
  let listing = session.known.components;
  // What is being typed stays until it is taken, or another address is opened.
  const typing = new Set<HTMLInputElement>();
  for (const field of [h, l]) {
    field.addEventListener("input", () => typing.add(field));
    field.addEventListener("change", () => field.value !== "" && !field.hasAttribute("aria-invalid") && typing.delete(field));
  }
  const show = () => {
    const { known, state } = session;
    if (session.address.opened) typing.clear();
    if (!typing.has(h)) h.value = state.point?.h ?? "";
    if (!typing.has(l)) l.value = state.point?.l ?? "";
    status.dataset.status = known.status === "open" ? "" : known.status;
    status.textContent = known.status === "regular" ? known.exact ? texts.point.exact : texts.point.moving : known.status === "open" && state.point ? "" : texts.point.status[known.status];
    region.dataset.region = known.region ?? "";
    region.textContent = known.region ?? "";
    signature.dataset.signature = known.signature;
    signature.textContent = known.signature ? `P = ${known.signature.split("+").map(surface).join(" + ")}` : "";
    margin.textContent = known.margin && state.point ? texts.diagram.from(shown(known.margin.h), known.margin.nearest) : "";
    if (listing !== known.components) parts.replaceChildren(
      ...((listing = known.components) ?? []).map((component, i) => {
        const poles = component.poles?.map((pole) => `${pole === "-" ? "−" : "+"}r̂`).join(", ");
        const text = `U = ${surface(component.accessible_region)}${poles ? texts.point.poles(poles) : ""}, E = ${surface(component.energy_surface)}, P = ${component.section ? texts.point.genus(surface(component.section), String(component.genus)) : texts.diagram.none}`;
        const words = texts.point.words(inWords(component.accessible_region), component.section ? inWords(component.section) : texts.surfaces.none);
        const element = make("div", { tabIndex: 0, title: words }, text);
        element.addEventListener("pointerenter", () => session.pointAt({ component: i }));
        element.addEventListener("pointerleave", () => session.pointAt({}));
        // By a key, or by a finger that taps.
        element.addEventListener("focus", () => session.pointAt({ component: i }));
        element.addEventListener("blur", () => session.pointAt({}));
        return element;
      }),
    );
    sentence.textContent = session.sentence;
    if (!state.point) told.textContent = "";
    else if (known.exact) told.textContent = known.region ? texts.point.told(known.region, listed(known.components?.map(({ section }) => section) ?? []), listed(known.components?.map(({ accessible_region }) => accessible_region) ?? [])) : texts.point.status[known.status];
  };
  const mark = () => [...parts.children].forEach((line, i) => line.classList.toggle("lit", session.hover.component === i));
  session.on(["point", "body"], () => (session.dragging === "body" ? inTurn(show) : show()));
  session.on(["point", "hover"], mark);
  // What an address asked for and is none.
  session.on(["message"], () => [h, l].forEach((field) => markField(field, session.message !== "" && field.value !== "" && !isNumber(field.value))));
  return panel(
    texts.point.title,
    texts.point.help,
    make("div", { className: "point" }, make("label", {}, "h ", h), make("label", {}, "l ", l), region, signature, status, margin),
    parts,
    sentence,
    told,
  );
}
