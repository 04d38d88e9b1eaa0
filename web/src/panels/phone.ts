/** The bar of a phone: panels are a stack there, and each name goes to its panel. */
import { make } from "../draw/dom";
import { texts } from "../texts";

export function phoneBar(panels: [name: string, panel: HTMLElement][]): HTMLElement {
  const seen = new Set<Element>();
  const links = panels.map(([name, panel]) => {
    const link = make("button", { type: "button" }, name);
    link.addEventListener("click", () => panel.scrollIntoView({ behavior: matchMedia("(prefers-reduced-motion: reduce)").matches ? "auto" : "smooth", block: "start" }));
    return link;
  });
  // One at a time, also where the border between two lies in the strip that is looked at.
  const look = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) isIntersecting ? seen.add(target) : seen.delete(target);
    const here = panels.findIndex(([, panel]) => seen.has(panel));
    links.forEach((link, i) => link.setAttribute("aria-pressed", String(i === here)));
  }, { rootMargin: "-40% 0px -55% 0px" });
  for (const [, panel] of panels) look.observe(panel);
  return make("nav", { className: "stack-bar", attributes: { "aria-label": texts.head.bar }, data: { testid: "stack-bar" } }, ...links);
}
