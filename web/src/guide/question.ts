/** A question on a card: a prediction first, then what is so. */
import { button, make } from "../draw/dom";
import type { Question } from "../state/task";
import { texts } from "../texts";

/** `show` puts the page where the answer can be seen; `next` leads on from there. */
export function questionCard({ question, choices, right, explanation }: Question, show: () => void, next: HTMLElement | null = null): HTMLElement {
  const outcome = make("div", {});
  const answers = choices.map((choice, i) =>
    button(choice, texts.task.predict, () => {
      for (const one of answers) one.disabled = true;
      answers[i]!.setAttribute("aria-pressed", "true");
      const verdict = i === right ? texts.task.right : texts.task.wrong(choices[right]!);
      outcome.replaceChildren(make("p", { className: "attempt" }, verdict), make("p", { className: "lines" }, explanation), ...(next ? [next] : []));
      show();
    }),
  );
  const hidden = choices.length === 0 && explanation !== "" && make("details", {}, make("summary", {}, texts.task.explanation), make("p", { className: "lines" }, explanation));
  return make("div", { className: "stack" }, make("p", { className: "lines" }, question), ...answers, hidden, outcome);
}
