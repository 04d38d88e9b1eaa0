/** A lecturer's task as an address carries it: its texts, what may be chosen, and the point that is shown once something was. */
import type { Point } from "./state";
import { texts } from "../texts";

/** A question with what may be predicted; of no choices, it is a task to work at. */
export interface Question {
  question: string;
  choices: string[];
  /** The number of the right choice, from 0. */
  right: number;
  /** Why it is so. */
  explanation: string;
}

export interface Assignment extends Question {
  heading: string;
  /** The point that is shown after the choice; null: the one of the address, from the beginning. */
  then: Point | null;
}

type Pairs = [name: string, value: string][];

/** Keys of a task; the last one shows whether the link came over whole. */
export const TASK_KEYS = ["heading", "task", "choices", "because", "then", "check"] as const;

/** Lines of choices, the right one of which begins with `*`. Throws what is wrong with them. */
export function choicesOf(text: string): Pick<Question, "choices" | "right"> {
  const lines = text.split("\n").map((line) => line.trim()).filter((line) => line !== "");
  const marked = lines.flatMap((line, i) => (line.startsWith("*") ? [i] : []));
  if (lines.length === 1) throw new Error(texts.task.single);
  if (lines.length > 0 && marked.length !== 1) throw new Error(marked.length === 0 ? texts.task.unmarked : texts.task.marked);
  return { choices: lines.map((line) => line.replace(/^\*\s*/, "")), right: marked[0] ?? 0 };
}

/** The same as a text. */
export const choiceLines = ({ choices, right }: Question): string => choices.map((choice, i) => (i === right ? `* ${choice}` : choice)).join("\n");

/** The parts of an address that carry a task, behind all others. */
export function taskParts(task: Assignment, before: string[]): string[] {
  const pairs: [string, string][] = [["heading", task.heading], ["task", task.question], ["choices", choiceLines(task)], ["because", task.explanation], ["then", task.then ? `${task.then.h},${task.then.l}` : ""]];
  const told = pairs.filter(([, value]) => value !== "");
  const check = checkOf([...before, ...told.map((pair) => pair.join("="))]);
  return [...told.map(([name, value]) => `${name}=${encoded(value)}`), `check=${check}`];
}

/** The task of an address, if it has one. Throws an error that says what is wrong with it. */
export function taskOf(pairs: Pairs): Assignment | null {
  const own = new Map(pairs.filter(([name]) => (TASK_KEYS as readonly string[]).includes(name)));
  if (own.size === 0) return null;
  const check = checkOf(pairs.filter(([name]) => name !== "check").map(([name, value]) => `${name}=${value}`));
  if (own.get("check") !== check) throw new Error(texts.task.broken);
  const [question, then] = [own.get("task") ?? "", own.get("then")?.split(",")];
  if (question.trim() === "") throw new Error(texts.task.empty);
  if (then && then.length !== 2) throw new Error(texts.task.then);
  return { heading: own.get("heading") ?? "", question, ...choicesOf(own.get("choices") ?? ""), explanation: own.get("because") ?? "", then: then ? { h: then[0]!, l: then[1]! } : null };
}

/** Signs that mail programs take for the end of a link are encoded too. */
const encoded = (text: string): string => encodeURIComponent(text).replace(/[!'()*]/g, (sign) => `%${sign.charCodeAt(0).toString(16).toUpperCase()}`);

/** FNV-1a of what the parts mean, so that another encoding of the same is no damage. */
function checkOf(parts: string[]): string {
  let sum = 0x811c9dc5;
  for (const byte of new TextEncoder().encode(parts.join("&"))) sum = Math.imul(sum ^ byte, 0x01000193) >>> 0;
  return sum.toString(36);
}
