/** Three lessons for a class, predict first, then see: what each question shows, and which choice is right. Their words are among the texts. */
import type { State } from "../state/state";
import type { Guide } from "../texts";

export interface Lesson {
  id: string;
  minutes: number;
  /** The number of the right choice, from 0, and what to look at when the prediction is made. */
  tasks: { right: number; state: Partial<State> }[];
}

export type Words = Guide["lessons"][number];

const LAGRANGE: Pick<State, "A" | "r"> = { A: ["2", "1", "1"], r: ["1", "0", "0"] };
const KOVALEVSKAYA: Pick<State, "A" | "r"> = { A: ["2", "2", "1"], r: ["1", "0", "0"] };

export const LESSONS: Lesson[] = [
  {
    id: "sleeping-top",
    minutes: 30,
    tasks: [
      { right: 1, state: { ...LAGRANGE, point: { h: "1.6", l: "1.5" }, view: { h: [1.2, 2.8], l: [1.4, 2.4] } } },
      { right: 0, state: { ...LAGRANGE, point: { h: "2.15", l: "2.1" }, view: { h: [1.4, 2.8], l: [1.6, 2.4] } } },
      { right: 1, state: { ...LAGRANGE, point: { h: "2.03", l: "2.02" }, view: { h: [1.8, 2.2], l: [1.85, 2.1] } } },
    ],
  },
  {
    id: "genus",
    minutes: 40,
    tasks: [
      { right: 1, state: { point: { h: "0.3", l: "1" } } },
      { right: 1, state: { point: { h: "3.53", l: "2.862" } } },
      { right: 1, state: { point: { h: "33.586", l: "8.428" } } },
    ],
  },
  {
    id: "order-chaos",
    minutes: 40,
    tasks: [
      { right: 0, state: { ...KOVALEVSKAYA, point: { h: "2", l: "1" } } },
      { right: 2, state: { point: { h: "6", l: "2" }, coloring: "verdict" } },
      { right: 0, state: { point: { h: "-0.5", l: "0.5" }, coloring: "lyapunov" } },
    ],
  },
];

/** A lesson as a page to print; `address` opens it. */
export function worksheetOf({ minutes }: Lesson, { title, objectives, tasks, worksheet }: Words, words: Guide["cards"], language: string, address: string): string {
  const list = (items: string[], kind: "ol" | "ul") => `<${kind}>${items.map((item) => `<li>${item}</li>`).join("")}</${kind}>`;
  const room = '<div class="room"></div>';
  const predictions = tasks.map(({ question, choices }) => `<p>${question}</p>${list(choices.map((choice) => `☐ ${choice}`), "ul")}<p>${words.saw}</p>${room}`);
  return `<!doctype html><html lang="${language}"><meta charset="utf-8"><title>${title}</title>
<style>body{font:16px/1.5 system-ui,sans-serif;max-width:46rem;margin:2rem auto;padding:0 1rem}ul{list-style:none}.room{height:5rem;border-bottom:1px dotted #888}</style>
<h1>${title}</h1><p>${words.sheet(minutes)} ____________________</p><p>${words.page} <a href="${address}">${address}</a></p><h2>${words.able}</h2>${list(objectives, "ol")}
<h2>${words.predict}</h2>${predictions.join("")}<h2>${words.alone}</h2><ol>${worksheet.map((task) => `<li>${task}${room}</li>`).join("")}</ol></html>`;
}
