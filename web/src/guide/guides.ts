/** Tour, lessons, a lecturer's task and the glossary as cards over the page. */
import { button, make } from "../draw/dom";
import type { Session } from "../state/session";
import { FIRST, type State } from "../state/state";
import type { Assignment } from "../state/task";
import type { Lesson } from "./lessons";
import { questionCard } from "./question";
import type { Step } from "./tour";

/** A state over the first one; what the reader chose to look at stays. */
const over = ({ theme, embed, present }: State, change: Partial<State>): State => ({ ...FIRST, theme, embed, present, ...change });

export function guides(session: Session): { card: HTMLElement; buttons: HTMLElement[]; step: (by: number) => boolean } {
  const card = make("aside", { className: "card", hidden: true, attributes: { "aria-live": "polite" }, data: { testid: "guide" } });
  const close = () => session.update({ tour: null, lesson: null, task: null }, "guide");
  const go = async (number: number) => {
    const { TOUR } = await load();
    const tour = Math.min(TOUR.length, Math.max(1, number));
    session.set(over(session.state, { ...TOUR[tour - 1]!.state, tour }));
  };
  let open: Lesson | Assignment | undefined;
  /** Texts that few read are loaded when they are asked for. */
  let texts: (typeof import("./lessons") & typeof import("./tour")) | undefined;
  const load = async () => (texts ??= { ...(await import("./lessons")), ...(await import("./tour")) });
  const show = () => {
    const { tour, lesson, task, embed } = session.state;
    if ((lesson !== null || tour !== null) && !texts) return void load().then(show);
    const chosen = texts?.LESSONS.find(({ id }) => id === lesson);
    card.hidden = tour === null && !chosen && lesson !== "list" && !task;
    // Where one panel is alone, beside it.
    const home = document.querySelector(embed === "section" || embed === "motion" ? ".column.right" : ".column.middle");
    if (home && card.parentElement !== home) home.append(card);
    // What is under way stays as it is, with its answers in sight.
    const now = chosen ?? (lesson === null && tour === null ? (task ?? undefined) : undefined);
    if (now && now === open) return;
    open = now;
    // From the link of a worksheet.
    if (chosen && !session.state.point) asked(session, chosen, 0, true);
    if (tour !== null) card.replaceChildren(...tourCard(tour, texts!.TOUR, go, close));
    else if (chosen) card.replaceChildren(...lessonCard(session, chosen, texts!.worksheetOf, close));
    else if (lesson === "list") card.replaceChildren(...lessonList(session, texts!.LESSONS, close));
    else if (task) card.replaceChildren(...assignmentCard(session, task, close));
  };
  session.on(["guide"], show);
  addEventListener("keydown", (event) => event.key === "Escape" && !card.hidden && !session.state.task && close());
  let glossary: Promise<HTMLDialogElement> | undefined;
  /** On or back in the tour, if it is open. */
  const step = (by: number): boolean => {
    const { tour } = session.state;
    if (tour === null) return false;
    void go(tour + by);
    return true;
  };
  return {
    card,
    step,
    buttons: [
      button("Tour", "Eight steps through the paper", () => void go(1), { testid: "tour" }),
      button("Lessons", "Three lessons for a class", () => session.update({ lesson: "list", tour: null }, "guide"), { testid: "lessons" }),
      button("Glossary", "What the terms mean", () => void (glossary ??= glossaryDialog()).then((dialog) => dialog.showModal()), { testid: "glossary" }),
    ],
  };
}

const head = (title: string, close: () => void) => make("header", {}, make("h2", {}, title), button("×", "Close (Escape)", close));

function tourCard(number: number, steps: Step[], go: (number: number) => void, close: () => void): HTMLElement[] {
  const step = steps[number - 1]!;
  const previous = button("Back", "Previous step", () => go(number - 1));
  previous.disabled = number === 1;
  const last = number === steps.length;
  const next = button(last ? "End" : "Next", last ? "End the tour" : "Next step", () => (last ? close() : go(number + 1)), { testid: "tour-next" });
  return [head(`${number}. ${step.title}`, close), make("p", {}, step.text), make("p", { className: "attempt" }, step.attempt), make("div", { className: "row" }, previous, make("span", { className: "note" }, `${number} of ${steps.length}`), next)];
}

/** A lecturer's task: the page stays the reader's, and can be brought back to where it began. */
function assignmentCard(session: Session, task: Assignment, close: () => void): HTMLElement[] {
  const begun = session.state;
  const show = () => task.then && session.set({ ...session.state, point: task.then });
  const again = button("Start again", "The body and the point that the task begins with", () => session.set({ ...begun, task: { ...task } }), { testid: "task-again" });
  return [head(task.heading || "Task", close), questionCard(task, () => void show()), make("div", { className: "row" }, again)];
}

function lessonList(session: Session, lessons: Lesson[], close: () => void): HTMLElement[] {
  const rows = lessons.map((lesson) => button(`${lesson.title} (${lesson.minutes} minutes)`, lesson.objectives.join(" "), () => asked(session, lesson, 0)));
  return [head("Lessons: predict, then observe", close), make("div", { className: "stack" }, ...rows, make("p", { className: "note" }, "For a question of your own: “Link to a task” under Export."))];
}

/** A question shows the body that it asks about, and not yet the point at which it is answered. */
function asked(session: Session, lesson: Lesson, number: number, opened = false): void {
  const { A, r } = over(session.state, lesson.tasks[number]!.state);
  session.set(over(session.state, { A, r, lesson: lesson.id }), opened);
}

function lessonCard(session: Session, lesson: Lesson, worksheetOf: (lesson: Lesson, address: string) => string, close: () => void): HTMLElement[] {
  const place = make("div", {});
  const turn = (number: number) => {
    const task = lesson.tasks[number]!;
    const next = number + 1 < lesson.tasks.length ? button("Next question", "", () => (asked(session, lesson, number + 1), turn(number + 1))) : null;
    const show = () => session.set(over(session.state, { ...task.state, lesson: lesson.id }));
    place.replaceChildren(questionCard({ ...task, question: `${number + 1}. ${task.question}` }, show, next));
  };
  turn(0);
  return [
    head(lesson.title, close),
    make("details", {}, make("summary", {}, "What you will be able to do"), make("ul", {}, ...lesson.objectives.map((objective) => make("li", {}, objective)))),
    place,
    make("div", { className: "row" }, button("Worksheet", "A printable page", () => void import("../export/files").then(({ save }) => save(`${lesson.id}.html`, worksheetOf(lesson, `${location.href.split("#")[0]}#lesson=${lesson.id}`), "text/html")), { testid: "worksheet" })),
  ];
}

async function glossaryDialog(): Promise<HTMLDialogElement> {
  const { GLOSSARY } = await import("./glossary");
  const dialog = make("dialog", { attributes: { "aria-label": "What the terms mean" } });
  const list = make("dl", {}, ...GLOSSARY.flatMap(([word, meaning]) => [make("dt", {}, word), make("dd", {}, meaning)]));
  dialog.append(head("What the terms mean", () => dialog.close()), list);
  document.body.append(dialog);
  return dialog;
}
