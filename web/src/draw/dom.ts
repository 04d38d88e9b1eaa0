/** Elements in one line. */
import { texts } from "../texts";

type Child = Node | string | null | undefined | false;
type Properties<K extends keyof HTMLElementTagNameMap> = Partial<Omit<HTMLElementTagNameMap[K], "dataset" | "style" | "attributes">> & {
  data?: Record<string, string>;
  attributes?: Record<string, string>;
};

export function make<K extends keyof HTMLElementTagNameMap>(name: K, properties: Properties<K> = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(name);
  const { data, attributes, ...rest } = properties;
  Object.assign(element, rest);
  Object.assign(element.dataset, data);
  for (const [key, value] of Object.entries(attributes ?? {})) element.setAttribute(key, value);
  for (const child of children) if (child) element.append(child);
  return element;
}

export const button = (label: string, title: string, onclick: () => void, data: Record<string, string> = {}): HTMLButtonElement =>
  make("button", { type: "button", title, onclick, data }, label);

/** A titled panel with a body; `help` stands under the title when it is asked for. */
export function panel(title: string, help: string, ...children: Child[]): HTMLElement {
  const words = make("p", { className: "help", hidden: true }, help);
  const ask = button("?", help, () => {
    words.hidden = !words.hidden;
    ask.setAttribute("aria-expanded", String(!words.hidden));
  });
  ask.className = "ask";
  ask.setAttribute("aria-expanded", "false");
  ask.setAttribute("aria-label", texts.dom.what(title));
  return make("section", { className: "panel", attributes: { "aria-label": title } }, make("header", {}, make("h2", { title: help }, title), ask), words, ...children);
}

/** Text that is copied when its button is pressed. */
export function copied(code: HTMLElement): HTMLElement {
  const copy = button(texts.dom.copy, texts.dom.copyHelp, () => void navigator.clipboard?.writeText(code.textContent ?? "").then(() => (copy.textContent = texts.dom.copied)));
  copy.addEventListener("blur", () => (copy.textContent = texts.dom.copy));
  return make("div", { className: "copied" }, code, copy);
}
