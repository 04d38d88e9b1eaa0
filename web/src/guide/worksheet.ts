/** A link to a task, for a lecturer: the page as it is now, with texts that are written here. */
import { copied, make } from "../draw/dom";
import { format } from "../state/hash";
import type { Session } from "../state/session";
import { PANELS, type State } from "../state/state";
import { addressIn, language, texts, type Guide } from "../texts";
import { choiceLines, choicesOf, type Assignment } from "../state/task";

/** Mail programs may break longer links. */
const LONG = 2000;

/** What keeps a link from being made, in words, and the field that it is about. */
class Missing extends Error {
  constructor(message: string, readonly field?: HTMLElement) {
    super(message);
  }
}

function worksheetDialog(session: Session, words: Guide["dialog"]): () => void {
  const views: [value: string, text: string][] = [
    ["", words.whole],
    ...(["diagram", "section", "motion"] as const).map((name): [string, string] => [`embed=${name}`, words.only[name]]),
    ...PANELS.map((name): [string, string] => [`present=${name}`, words.large(texts.panels[name])]),
  ];
  const area = (name: string, rows: number, placeholder = "") => make("textarea", { rows, placeholder, data: { testid: `task-${name}` } });
  const heading = make("input", { type: "text", data: { testid: "task-heading" } });
  const question = area("question", 4);
  const choices = area("choices", 3, words.sample);
  const because = area("because", 2);
  const later = make("input", { type: "checkbox", data: { testid: "task-later" } });
  const view = make("select", { data: { testid: "task-view" } }, ...views.map(([value, text]) => make("option", { value }, text)));
  const shown = make("p", { className: "note" });
  const hint = make("p", { className: "attempt", attributes: { role: "status" }, data: { testid: "task-hint" } });
  const [link, frame] = [make("code", { data: { testid: "task-link" } }), make("code", { data: { testid: "task-frame" } })];
  const attempt = make("a", { target: "_blank", rel: "noopener", data: { testid: "task-try" } }, words.attempt);
  const framed = make("div", {}, make("h3", {}, words.frame), copied(frame));
  const made = make("div", {}, make("h3", {}, words.link), copied(link), attempt, framed);

  const stateOf = (): State => {
    const { state, orbits, message } = session;
    if (message) throw new Missing(words.error(message));
    if (question.value.trim() === "") throw new Missing(words.question, question);
    let chosen: ReturnType<typeof choicesOf>;
    try {
      chosen = choicesOf(choices.value);
    } catch (error) {
      throw new Missing((error as Error).message, choices);
    }
    if (later.checked && chosen.choices.length === 0) throw new Missing(words.laterChoices, choices);
    if (later.checked && !state.point) throw new Missing(words.laterPoint, later);
    const [kind, panel] = view.value.split("=");
    if (kind === "embed" && panel !== "diagram" && !state.point) throw new Missing(words.noPoint, view);
    if (kind === "embed" && panel !== "diagram" && orbits.reason) throw new Missing(words.noSection(orbits.reason), view);
    const task: Assignment = { heading: heading.value.trim(), question: question.value.trim(), ...chosen, explanation: because.value.trim(), then: later.checked ? state.point : null };
    return { ...state, tour: null, lesson: null, theme: null, embed: null, present: null, ...(kind ? { [kind]: panel } : {}), point: later.checked ? null : state.point, task };
  };
  const show = () => {
    for (const field of [question, choices, later, view]) field.removeAttribute("aria-invalid");
    try {
      const address = addressIn(language, `#${format(stateOf())}`);
      link.textContent = attempt.href = address;
      frame.textContent = `<iframe src="${address.replace(/&/g, "&amp;")}" width="600" height="600" style="border: 0"></iframe>`;
      framed.hidden = !view.value.startsWith("embed=");
      made.hidden = false;
      hint.textContent = `${words.length(address.length)}${address.length > LONG ? `: ${words.long}` : ""}`;
    } catch (error) {
      made.hidden = true;
      hint.textContent = (error as Error).message;
      if (error instanceof Missing) error.field?.setAttribute("aria-invalid", "true");
    }
  };
  const labelled = (text: string, field: HTMLElement) => make("label", {}, text, field);
  const form = make("div", { className: "form" },
    shown,
    labelled(words.heading, heading),
    labelled(words.task, question),
    labelled(words.choices, choices),
    labelled(words.because, because),
    make("label", { className: "row" }, later, words.later),
    labelled(words.view, view),
    hint, made);
  form.addEventListener("input", show);
  const close = make("button", { type: "button", title: texts.dom.close }, "×");
  const dialog = make("dialog", { attributes: { "aria-label": words.title }, data: { testid: "task-dialog" } }, make("header", {}, make("h2", {}, words.title), close), form);
  close.addEventListener("click", () => dialog.close());
  document.body.append(dialog);
  const refresh = () => {
    const { A, r, point } = session.state;
    shown.textContent = words.begins(`A = ${A.join(", ")}; r = ${r.join(", ")}`, point ? `h = ${point.h}, l = ${point.l}` : words.pointless);
    show();
  };
  // What the page learns while the dialog is open, such as that there is no section, holds for the link too.
  session.on(["body", "point", "section", "message", "address"], () => dialog.open && refresh());
  // With what is shown now; the texts of before, or of the task that is open, to go on with.
  return () => {
    const { task } = session.state;
    if (task && question.value === "") [heading.value, question.value, choices.value, because.value] = [task.heading, task.question, choiceLines(task), task.explanation];
    refresh();
    dialog.showModal();
  };
}

let open: (() => void) | undefined;

/** What opens the dialog over the page. */
export const worksheet = (session: Session, words: Guide["dialog"]): (() => void) => (open ??= worksheetDialog(session, words));
