/** The head of the page: its name, the guides, dark or light. */
import { button, make } from "../draw/dom";
import type { Session } from "../state/session";

/** The theme that is asked for, or the system's. */
export function applyTheme(session: Session): void {
  const system = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
  document.documentElement.dataset.theme = session.state.theme ?? system;
  document.documentElement.dataset.embed = session.state.embed ?? "";
}

export function headPanel(session: Session, buttons: HTMLElement[]): HTMLElement {
  applyTheme(session);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => session.emit("theme"));
  const theme = button("◐", "Dark or light", () => {
    const dark = document.documentElement.dataset.theme === "dark";
    session.update({ theme: dark ? "light" : "dark" }, "theme");
  }, { testid: "theme" });
  return make("header", { className: "head" }, make("h1", {}, "bifdiag"), make("span", { className: "subtitle" }, "all motions of a heavy rigid body with a fixed point"), make("nav", {}, ...buttons, theme));
}
