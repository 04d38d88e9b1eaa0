/** A field for an exact number: a decimal comma and a typographic minus are read; what is no number is marked and goes no further.
 * Up and down change the last digit, with shift the one before. */
import { isNumber, stepped, typed } from "../state/numbers";
import { make } from "./dom";

export function numberField(name: string, hint: string, change: () => void): HTMLInputElement {
  const input = make("input", { type: "text", inputMode: "decimal", spellcheck: false, autocomplete: "off", title: hint, attributes: { "aria-label": name }, data: { testid: `input-${name}` } });
  input.addEventListener("change", () => {
    const text = typed(input.value);
    const wrong = text !== "" && !isNumber(text);
    mark(input, wrong);
    if (wrong) return;
    input.value = text;
    change();
  });
  input.addEventListener("keydown", (event) => {
    const step = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    const text = typed(input.value);
    if (!step || (text !== "" && !isNumber(text))) return;
    event.preventDefault();
    input.value = stepped(text, event.shiftKey ? 10 * step : step);
    mark(input, false);
    change();
  });
  return input;
}

export function mark(input: HTMLInputElement, wrong: boolean): void {
  if (wrong) input.setAttribute("aria-invalid", "true");
  else input.removeAttribute("aria-invalid");
}
