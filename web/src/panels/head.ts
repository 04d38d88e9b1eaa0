/** The head of the page: its name, the guides, the language, dark or light. */
import { button, make } from "../draw/dom";
import type { Session } from "../state/session";
import { addressIn, language, LANGUAGES, texts, type Language } from "../texts";

let onPaper = false;

/** The theme that is asked for, or the system's; on paper the light one. */
export function applyTheme(session: Session): void {
  const system = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
  document.documentElement.dataset.theme = onPaper ? "light" : session.state.theme ?? system;
  document.documentElement.dataset.embed = session.state.embed ?? "";
}

/** Another language is another page, at the same state. */
function languages(): HTMLSelectElement {
  const choice = make("select", { title: texts.head.language, attributes: { "aria-label": texts.head.language }, data: { testid: "language" } });
  for (const [name, title] of Object.entries(LANGUAGES)) choice.append(make("option", { value: name, lang: name, selected: name === language }, title));
  choice.addEventListener("change", () => location.assign(addressIn(choice.value as Language, location.hash)));
  return choice;
}

export function headPanel(session: Session, buttons: HTMLElement[]): HTMLElement {
  applyTheme(session);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => session.emit("theme"));
  // Before sheets, which paint what is asked of them before it is printed.
  for (const [event, paper] of [["beforeprint", true], ["afterprint", false]] as const) addEventListener(event, () => ((onPaper = paper), session.emit("theme")), { capture: true });
  const theme = button("◐", texts.head.theme, () => {
    const dark = document.documentElement.dataset.theme === "dark";
    session.update({ theme: dark ? "light" : "dark" }, "theme");
  }, { testid: "theme" });
  return make("header", { className: "head" }, make("h1", {}, "bifdiag"), make("span", { className: "subtitle" }, texts.head.subtitle), make("nav", {}, ...buttons, make("span", {}, languages(), theme)));
}
