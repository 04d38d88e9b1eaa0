/** A link to a task, for a lecturer: the page as it is now, with texts that are written here. */
import { copied, make } from "../draw/dom";
import { format } from "../state/hash";
import type { Session } from "../state/session";
import { PANELS, type State } from "../state/state";
import { choiceLines, choicesOf, type Assignment } from "../state/task";

/** Mail programs may break longer links. */
const LONG = 2000;

const VIEWS: [value: string, text: string][] = [
  ["", "The whole page"],
  ["embed=diagram", "Only the diagram"],
  ["embed=section", "Only the section"],
  ["embed=motion", "Only the motion"],
  ...PANELS.map((name): [string, string] => [`present=${name}`, `Large, the others one key away: ${name}`]),
];

/** What keeps a link from being made, in words, and the field that it is about. */
class Missing extends Error {
  constructor(message: string, readonly field?: HTMLElement) {
    super(message);
  }
}

export function worksheetDialog(session: Session): HTMLDialogElement {
  const area = (name: string, rows: number, placeholder = "") => make("textarea", { rows, placeholder, data: { testid: `task-${name}` } });
  const heading = make("input", { type: "text", data: { testid: "task-heading" } });
  const question = area("question", 4);
  const choices = area("choices", 3, "* the right answer\nanother answer");
  const because = area("because", 2);
  const later = make("input", { type: "checkbox", data: { testid: "task-later" } });
  const view = make("select", { data: { testid: "task-view" } }, ...VIEWS.map(([value, text]) => make("option", { value }, text)));
  const shown = make("p", { className: "note" });
  const hint = make("p", { className: "attempt", attributes: { role: "status" }, data: { testid: "task-hint" } });
  const [link, frame] = [make("code", { data: { testid: "task-link" } }), make("code", { data: { testid: "task-frame" } })];
  const attempt = make("a", { target: "_blank", rel: "noopener", data: { testid: "task-try" } }, "Try it");
  const framed = make("div", {}, make("h3", {}, "For a page of your own"), copied(frame));
  const made = make("div", {}, make("h3", {}, "The link"), copied(link), attempt, framed);

  const stateOf = (): State => {
    const { state, orbits, message } = session;
    if (message) throw new Missing(`The page itself has an error, which comes first: ${message}`);
    if (question.value.trim() === "") throw new Missing("Write the task: what should the reader do, or answer?", question);
    let chosen: ReturnType<typeof choicesOf>;
    try {
      chosen = choicesOf(choices.value);
    } catch (error) {
      throw new Missing((error as Error).message, choices);
    }
    if (later.checked && chosen.choices.length === 0) throw new Missing("The point can wait for an answer only if there are answers to choose from", choices);
    if (later.checked && !state.point) throw new Missing("Choose the point in the diagram that is shown after the answer", later);
    const [kind, panel] = view.value.split("=");
    if (kind === "embed" && panel !== "diagram" && !state.point) throw new Missing(`Choose a point in the diagram: without one there is no ${panel}`, view);
    if (kind === "embed" && panel !== "diagram" && orbits.reason) throw new Missing(`There is no ${panel} at this point: ${orbits.reason}`, view);
    const task: Assignment = { heading: heading.value.trim(), question: question.value.trim(), ...chosen, explanation: because.value.trim(), then: later.checked ? state.point : null };
    return { ...state, tour: null, lesson: null, theme: null, embed: null, present: null, ...(kind ? { [kind]: panel } : {}), point: later.checked ? null : state.point, task };
  };
  const show = () => {
    for (const field of [question, choices, later, view]) field.removeAttribute("aria-invalid");
    try {
      const address = `${location.href.split("#")[0]}#${format(stateOf())}`;
      link.textContent = attempt.href = address;
      frame.textContent = `<iframe src="${address.replace(/&/g, "&amp;")}" width="600" height="600" style="border: 0"></iframe>`;
      framed.hidden = !view.value.startsWith("embed=");
      made.hidden = false;
      hint.textContent = `${address.length} characters${address.length > LONG ? ": some mail programs break links of this length; a reader whose link came over broken is told so" : ""}`;
    } catch (error) {
      made.hidden = true;
      hint.textContent = (error as Error).message;
      if (error instanceof Missing) error.field?.setAttribute("aria-invalid", "true");
    }
  };
  const labelled = (text: string, field: HTMLElement) => make("label", {}, text, field);
  const form = make("div", { className: "form" },
    shown,
    labelled("Heading (may stay empty)", heading),
    labelled("The task or question", question),
    labelled("Answers to choose from, each on a line of its own, * before the right one (may stay empty)", choices),
    labelled("What is told after the answer (may stay empty)", because),
    make("label", { className: "row" }, later, "Show the point only after the answer"),
    labelled("What the reader sees", view),
    hint, made);
  form.addEventListener("input", show);
  const close = make("button", { type: "button", title: "Close (Escape)" }, "×");
  const dialog = make("dialog", { attributes: { "aria-label": "Link to a task" }, data: { testid: "task-dialog" } }, make("header", {}, make("h2", {}, "Link to a task"), close), form);
  close.addEventListener("click", () => dialog.close());
  // With what is shown now; the texts of before, or of the task that is open, to go on with.
  dialog.addEventListener("toggle", () => {
    if (!dialog.open) return;
    const { A, r, point, task } = session.state;
    shown.textContent = `The reader starts from what you see now: A = ${A.join(", ")}; r = ${r.join(", ")}; ${point ? `h = ${point.h}, l = ${point.l}` : "no point"}. Links are read by this page alone: nothing is sent to anybody.`;
    if (task && question.value === "") [heading.value, question.value, choices.value, because.value] = [task.heading, task.question, choiceLines(task), task.explanation];
    show();
  });
  document.body.append(dialog);
  return dialog;
}

let dialog: HTMLDialogElement | undefined;

/** Opens the dialog over the page. */
export function openWorksheet(session: Session): void {
  (dialog ??= worksheetDialog(session)).showModal();
}
