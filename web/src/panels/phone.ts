/** The bar of a phone: panels are a stack there, and each name goes to its panel. */
import { make } from "../draw/dom";
import { texts } from "../texts";

export function phoneBar(panels: [name: string, panel: HTMLElement][]): HTMLElement {
  const links = panels.map(([name, panel]) => {
    const link = make("button", { type: "button" }, name);
    link.addEventListener("click", () => panel.scrollIntoView({ behavior: matchMedia("(prefers-reduced-motion: reduce)").matches ? "auto" : "smooth", block: "start" }));
    new IntersectionObserver(([entry]) => link.setAttribute("aria-pressed", String(entry?.isIntersecting ?? false)), { rootMargin: "-40% 0px -55% 0px" }).observe(panel);
    return link;
  });
  return make("nav", { className: "stack-bar", attributes: { "aria-label": texts.head.bar }, data: { testid: "stack-bar" } }, ...links);
}
