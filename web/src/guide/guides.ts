/** Tour, lessons, a lecturer's task and the glossary as cards over the page. */
import { button, make } from "../draw/dom";
import type { Session } from "../state/session";
import { FIRST, type State } from "../state/state";
import type { Assignment } from "../state/task";
import type { Lesson } from "./lessons";
import { questionCard } from "./question";
import { addressIn, guideTexts, language, texts, type Guide } from "../texts";

type Loaded = typeof import("./lessons") & typeof import("./tour") & { words: Guide };

/** A state over the first one; what the reader chose to look at stays. */
const over = ({ theme, embed, present }: State, change: Partial<State>): State => ({ ...FIRST, theme, embed, present, ...change });

export function guides(session: Session): { card: HTMLElement; buttons: HTMLElement[]; step: (by: number) => boolean } {
  const card = make("aside", { className: "card", hidden: true, attributes: { "aria-live": "polite" }, data: { testid: "guide" } });
  const close = () => session.update({ tour: null, lesson: null, task: null }, "guide");
  const go = async (number: number) => {
    const { TOUR } = await load();
    const tour = Math.min(TOUR.length, Math.max(1, number));
    session.set(over(session.state, { ...TOUR[tour - 1]!, tour }));
  };
  let open: Lesson | Assignment | undefined;
  /** What few read is loaded when it is asked for. */
  let loaded: Loaded | undefined;
  const load = async () => (loaded ??= { ...(await import("./lessons")), ...(await import("./tour")), words: await guideTexts() });
  const show = () => {
    const { tour, lesson, task, embed } = session.state;
    if ((lesson !== null || tour !== null) && !loaded) return void load().then(show);
    const chosen = loaded?.LESSONS.find(({ id }) => id === lesson);
    card.hidden = tour === null && !chosen && lesson !== "list" && !task;
    // Where one panel of the right column is alone, over it.
    const right = embed === "section" || embed === "motion";
    const home = document.querySelector(right ? ".column.right" : ".column.middle");
    if (home && card.parentElement !== home) home[right ? "prepend" : "append"](card);
    // What is under way stays as it is, with its answers in sight.
    const now = chosen ?? (lesson === null && tour === null ? (task ?? undefined) : undefined);
    if (now && now === open) return;
    open = now;
    // From the link of a worksheet.
    if (chosen && !session.state.point) asked(session, chosen, 0, true);
    if (tour !== null) card.replaceChildren(...tourCard(tour, loaded!.words, go, close));
    else if (chosen) card.replaceChildren(...lessonCard(session, chosen, loaded!, close));
    else if (lesson === "list") card.replaceChildren(...lessonList(session, loaded!, close));
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
      button(texts.guide.tour, texts.guide.tourHelp, () => void go(1), { testid: "tour" }),
      button(texts.guide.lessons, texts.guide.lessonsHelp, () => session.update({ lesson: "list", tour: null }, "guide"), { testid: "lessons" }),
      button(texts.guide.glossary, texts.guide.glossaryHelp, () => void (glossary ??= glossaryDialog()).then((dialog) => dialog.showModal()), { testid: "glossary" }),
    ],
  };
}

const head = (title: string, close: () => void) => make("header", {}, make("h2", {}, title), button("×", texts.dom.close, close));

function tourCard(number: number, { tour: steps, cards: words }: Guide, go: (number: number) => void, close: () => void): HTMLElement[] {
  const step = steps[number - 1]!;
  const previous = button(words.back, words.backHelp, () => go(number - 1));
  previous.disabled = number === 1;
  const last = number === steps.length;
  const next = button(last ? words.end : words.next, last ? words.endHelp : words.nextHelp, () => (last ? close() : go(number + 1)), { testid: "tour-next" });
  return [head(`${number}. ${step.title}`, close), make("p", {}, step.text), make("p", { className: "attempt" }, step.attempt), make("div", { className: "row" }, previous, make("span", { className: "note" }, words.of(number, steps.length)), next)];
}

/** A lecturer's task: the page stays the reader's, and can be brought back to where it began. */
function assignmentCard(session: Session, task: Assignment, close: () => void): HTMLElement[] {
  const begun = session.state;
  const show = () => task.then && session.set({ ...session.state, point: task.then });
  const again = button(texts.task.again, texts.task.againHelp, () => session.set({ ...begun, task: { ...task } }), { testid: "task-again" });
  return [head(task.heading || texts.task.title, close), questionCard(task, () => void show()), make("div", { className: "row" }, again)];
}

function lessonList(session: Session, { LESSONS, words: { lessons, cards } }: Loaded, close: () => void): HTMLElement[] {
  const rows = LESSONS.map((lesson, i) => button(cards.lesson(lessons[i]!.title, lesson.minutes), lessons[i]!.objectives.join(" "), () => asked(session, lesson, 0)));
  return [head(cards.list, close), make("div", { className: "stack" }, ...rows, make("p", { className: "note" }, cards.own))];
}

/** A question shows the body that it asks about, and not yet the point at which it is answered. */
function asked(session: Session, lesson: Lesson, number: number, opened = false): void {
  const { A, r } = over(session.state, lesson.tasks[number]!.state);
  session.set(over(session.state, { A, r, lesson: lesson.id }), opened);
}

function lessonCard(session: Session, lesson: Lesson, { LESSONS, words, worksheetOf }: Loaded, close: () => void): HTMLElement[] {
  const [told, { cards }] = [words.lessons[LESSONS.indexOf(lesson)]!, words];
  const place = make("div", {});
  const turn = (number: number) => {
    const task = lesson.tasks[number]!;
    const next = number + 1 < lesson.tasks.length ? button(cards.nextQuestion, "", () => (asked(session, lesson, number + 1), turn(number + 1))) : null;
    const show = () => session.set(over(session.state, { ...task.state, lesson: lesson.id }));
    place.replaceChildren(questionCard({ ...task, ...told.tasks[number]!, question: `${number + 1}. ${told.tasks[number]!.question}` }, show, next));
  };
  turn(0);
  return [
    head(told.title, close),
    make("details", {}, make("summary", {}, cards.able), make("ul", {}, ...told.objectives.map((objective) => make("li", {}, objective)))),
    place,
    make("div", { className: "row" }, button(cards.worksheet, cards.worksheetHelp, () => void import("../export/files").then(({ save }) => save(`${lesson.id}.html`, worksheetOf(lesson, told, cards, language, addressIn(language, `#lesson=${lesson.id}`)), "text/html")), { testid: "worksheet" })),
  ];
}

async function glossaryDialog(): Promise<HTMLDialogElement> {
  const { glossary, cards } = await guideTexts();
  const dialog = make("dialog", { attributes: { "aria-label": cards.terms } });
  const list = make("dl", {}, ...glossary.flatMap(([word, meaning]) => [make("dt", {}, word), make("dd", {}, meaning)]));
  dialog.append(head(cards.terms, () => dialog.close()), list);
  document.body.append(dialog);
  return dialog;
}
