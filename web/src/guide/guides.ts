/** Tour, lessons and glossary as cards over the page. */
import { save } from "../export/files";
import { button, make } from "../draw/dom";
import type { Session } from "../state/session";
import { FIRST, type State } from "../state/state";
import { GLOSSARY } from "./glossary";
import { LESSONS, worksheetOf, type Lesson, type Task } from "./lessons";
import { TOUR } from "./tour";

/** A state over the first one; what the reader chose to look at stays. */
const over = ({ theme, embed, present }: State, change: Partial<State>): State => ({ ...FIRST, theme, embed, present, ...change });

export function guides(session: Session): { card: HTMLElement; buttons: HTMLElement[]; step: (by: number) => boolean } {
  const card = make("aside", { className: "card", hidden: true, attributes: { "aria-live": "polite" }, data: { testid: "guide" } });
  const close = () => session.update({ tour: null, lesson: null }, "guide");
  const go = (number: number) => session.set(over(session.state, { ...TOUR[number - 1]!.state, tour: number }));
  let open: Lesson | undefined;
  const show = () => {
    const { tour, lesson } = session.state;
    const chosen = LESSONS.find(({ id }) => id === lesson);
    card.hidden = tour === null && !chosen && lesson !== "list";
    // A lesson that is under way stays as it is, with its answers in sight.
    if (chosen && chosen === open) return;
    open = chosen;
    if (tour !== null) card.replaceChildren(...tourCard(tour, go, close));
    else if (chosen) card.replaceChildren(...lessonCard(session, chosen, close));
    else if (lesson === "list") card.replaceChildren(...lessonList(session, close));
  };
  session.on(["guide"], show);
  addEventListener("keydown", (event) => event.key === "Escape" && !card.hidden && close());
  const glossary = glossaryDialog();
  document.body.append(glossary);
  /** On or back in the tour, if it is open. */
  const step = (by: number): boolean => {
    const { tour } = session.state;
    if (tour === null) return false;
    go(Math.min(TOUR.length, Math.max(1, tour + by)));
    return true;
  };
  return {
    card,
    step,
    buttons: [
      button("Tour", "Eight steps through the paper", () => go(1), { testid: "tour" }),
      button("Lessons", "Three lessons for a class", () => session.update({ lesson: "list", tour: null }, "guide"), { testid: "lessons" }),
      button("Glossary", "What the terms mean", () => glossary.showModal(), { testid: "glossary" }),
    ],
  };
}

const head = (title: string, close: () => void) => make("header", {}, make("h2", {}, title), button("×", "Close (Escape)", close));

function tourCard(number: number, go: (number: number) => void, close: () => void): HTMLElement[] {
  const step = TOUR[number - 1]!;
  const previous = button("Back", "Previous step", () => go(number - 1));
  previous.disabled = number === 1;
  const last = number === TOUR.length;
  const next = button(last ? "End" : "Next", last ? "End the tour" : "Next step", () => (last ? close() : go(number + 1)), { testid: "tour-next" });
  return [head(`${number}. ${step.title}`, close), make("p", {}, step.text), make("p", { className: "attempt" }, step.attempt), make("div", { className: "row" }, previous, make("span", { className: "note" }, `${number} of ${TOUR.length}`), next)];
}

function lessonList(session: Session, close: () => void): HTMLElement[] {
  const rows = LESSONS.map((lesson) => button(`${lesson.title} (${lesson.minutes} minutes)`, lesson.objectives.join(" "), () => asked(session, lesson, 0)));
  return [head("Lessons: predict, then observe", close), make("div", { className: "stack" }, ...rows)];
}

/** A question shows the body that it asks about, and not yet the point at which it is answered. */
function asked(session: Session, lesson: Lesson, number: number): void {
  const { A, r } = over(session.state, lesson.tasks[number]!.state);
  session.set(over(session.state, { A, r, lesson: lesson.id }));
}

function lessonCard(session: Session, lesson: Lesson, close: () => void): HTMLElement[] {
  const place = make("div", {});
  const turn = (number: number) => place.replaceChildren(taskCard(session, lesson, number, (next) => (asked(session, lesson, next), turn(next))));
  turn(0);
  return [
    head(lesson.title, close),
    make("details", {}, make("summary", {}, "What you will be able to do"), make("ul", {}, ...lesson.objectives.map((objective) => make("li", {}, objective)))),
    place,
    make("div", { className: "row" }, button("Worksheet", "A printable page", () => save(`${lesson.id}.html`, worksheetOf(lesson), "text/html"), { testid: "worksheet" })),
  ];
}

function taskCard(session: Session, lesson: Lesson, number: number, turn: (number: number) => void): HTMLElement {
  const task = lesson.tasks[number]!;
  const outcome = make("div", {});
  const choices = task.choices.map((choice, i) =>
    button(choice, "My prediction", () => {
      for (const one of choices) one.disabled = true;
      choices[i]!.setAttribute("aria-pressed", "true");
      outcome.replaceChildren(...answer(task, i));
      if (number + 1 < lesson.tasks.length) outcome.append(button("Next question", "", () => turn(number + 1)));
      session.set(over(session.state, { ...task.state, lesson: lesson.id }));
    }),
  );
  return make("div", { className: "stack" }, make("p", {}, `${number + 1}. ${task.question}`), ...choices, outcome);
}

const answer = ({ choices, right, explanation }: Task, chosen: number): HTMLElement[] => [
  make("p", { className: "attempt" }, chosen === right ? "As you predicted." : `Not as predicted: ${choices[right]!.toLowerCase()}.`),
  make("p", {}, explanation),
];

function glossaryDialog(): HTMLDialogElement {
  const dialog = make("dialog", { attributes: { "aria-label": "What the terms mean" } });
  const list = make("dl", {}, ...GLOSSARY.flatMap(([word, meaning]) => [make("dt", {}, word), make("dd", {}, meaning)]));
  dialog.append(head("What the terms mean", () => dialog.close()), list);
  return dialog;
}
