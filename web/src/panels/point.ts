/** The point (h, l): exact texts, and what is known of it in words. */
import { make, panel } from "../draw/dom";
import { numberField } from "../draw/field";
import { shown, surface } from "../state/numbers";
import type { Known } from "../state/known";
import type { Session } from "../state/session";
import { inWords, listed } from "../state/words";

const STATUS: Record<Known["status"], string> = {
  open: "Click in the diagram to choose an energy h and a vertical angular momentum l.",
  regular: "",
  forbidden: "Below the lowest possible energy: there is no such motion.",
  critical: "Exactly on a curve: the topology changes here.",
  undecided: "Too close to a curve for fast arithmetic to decide.",
};

export function pointPanel(session: Session): HTMLElement {
  const input = (name: "h" | "l", meaning: string) => numberField(name, meaning, () => change());
  const h = input("h", "energy");
  const l = input("l", "vertical angular momentum");
  const change = () => {
    const [energy, momentum] = [h.value.trim(), l.value.trim()];
    if (energy && momentum) session.point({ h: energy, l: momentum });
    else if (!energy && !momentum) session.point(null);
  };
  const status = make("span", { title: "Exactly: with certainty, by exact arithmetic wherever rounding could mislead", data: { testid: "point-status", status: "" } });
  const region = make("b", { data: { testid: "point-region", region: "" } });
  const signature = make("span", { data: { testid: "point-signature", signature: "" } });
  const margin = make("span", { className: "note" });
  const parts = make("div", { className: "components" });
  const sentence = make("p", { className: "sentence", attributes: { "aria-live": "polite" }, data: { testid: "surgery" } });
  // What a screen reader says once the hand rests: the region and what lies over it.
  const told = make("p", { className: "unseen", attributes: { role: "status" }, data: { testid: "told" } });
  let listing = session.known.components;
  const show = () => {
    const { known, state } = session;
    if (document.activeElement !== h) h.value = state.point?.h ?? "";
    if (document.activeElement !== l) l.value = state.point?.l ?? "";
    status.dataset.status = known.status === "open" ? "" : known.status;
    status.textContent = known.status === "regular" ? `${known.exact ? "decided exactly" : "while moving"}` : known.status === "open" && state.point ? "" : STATUS[known.status];
    region.dataset.region = known.region ?? "";
    region.textContent = known.region ?? "";
    signature.dataset.signature = known.signature;
    signature.textContent = known.signature ? `P = ${known.signature.split("+").map(surface).join(" + ")}` : "";
    margin.textContent = known.margin && state.point ? `${shown(known.margin.h)} in h from ${known.margin.nearest}` : "";
    if (listing !== known.components) parts.replaceChildren(
      ...((listing = known.components) ?? []).map((component, i) => {
        const poles = component.poles?.map((pole) => `${pole === "-" ? "−" : "+"}r̂`).join(", ");
        const text = `U = ${surface(component.accessible_region)}${poles ? ` with ${poles}` : ""}, E = ${surface(component.energy_surface)}, P = ${component.section ? `${surface(component.section)}, genus ${component.genus}` : "none"}`;
        const words = `Accessible: ${inWords(component.accessible_region)}. Section: ${component.section ? inWords(component.section) : "none"}. The genus counts handles: boundary circles + poles − 1.`;
        const element = make("div", { tabIndex: 0, title: words }, text);
        element.addEventListener("pointerenter", () => session.pointAt({ component: i }));
        element.addEventListener("pointerleave", () => session.pointAt({}));
        return element;
      }),
    );
    sentence.textContent = session.sentence;
    if (known.exact && state.point) told.textContent = known.region ? `Region ${known.region}. Section: ${listed(known.components?.map(({ section }) => section) ?? [])}. Accessible: ${listed(known.components?.map(({ accessible_region }) => accessible_region) ?? [])}.` : STATUS[known.status];
  };
  const mark = () => [...parts.children].forEach((line, i) => line.classList.toggle("lit", session.hover.component === i));
  session.on(["point", "body"], show);
  session.on(["point", "hover"], mark);
  return panel(
    "The point",
    "Energy h and vertical angular momentum l, both conserved. The lines below are the separate pieces of U and what lies over each: E, and P with its genus, the number of handles",
    make("div", { className: "point" }, make("label", {}, "h ", h), make("label", {}, "l ", l), region, signature, status, margin),
    parts,
    sentence,
    told,
  );
}
