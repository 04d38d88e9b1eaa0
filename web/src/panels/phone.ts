/** The bar of a phone: panels are a stack there, and each name goes to its panel. */
import { make } from "../draw/dom";

export function phoneBar(panels: Record<string, HTMLElement>): HTMLElement {
  const links = Object.entries(panels).map(([name, panel]) => {
    const link = make("button", { type: "button" }, name);
    link.addEventListener("click", () => panel.scrollIntoView({ behavior: matchMedia("(prefers-reduced-motion: reduce)").matches ? "auto" : "smooth", block: "start" }));
    new IntersectionObserver(([entry]) => link.setAttribute("aria-pressed", String(entry?.isIntersecting ?? false)), { rootMargin: "-40% 0px -55% 0px" }).observe(panel);
    return link;
  });
  return make("nav", { className: "stack-bar", attributes: { "aria-label": "panels" }, data: { testid: "stack-bar" } }, ...links);
}
