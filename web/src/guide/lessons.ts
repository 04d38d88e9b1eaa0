/** Three lessons for a class: predict first, then see. */
import type { State } from "../state/state";
import type { Question } from "../state/task";

export interface Task extends Question {
  /** What to look at when the prediction is made. */
  state: Partial<State>;
}

export interface Lesson {
  id: string;
  title: string;
  minutes: number;
  objectives: string[];
  tasks: Task[];
  worksheet: string[];
}

const LAGRANGE: Pick<State, "A" | "r"> = { A: ["2", "1", "1"], r: ["1", "0", "0"] };
const KOVALEVSKAYA: Pick<State, "A" | "r"> = { A: ["2", "2", "1"], r: ["1", "0", "0"] };

export const LESSONS: Lesson[] = [
  {
    id: "sleeping-top",
    title: "The sleeping top",
    minutes: 30,
    objectives: [
      "Decide from a picture of the effective potential whether a steady rotation is a minimum.",
      "Find the spin above which an upright top sleeps.",
      "Explain why faster spin makes the upright position stable.",
    ],
    tasks: [
      {
        question: "Lagrange's top, A = (2, 1, 1), spins upright with l = 1.5. It gets slightly more energy than the upright rotation has. Which directions can the vertical reach?",
        choices: ["Only a small cap around the upright direction −r̂", "The whole sphere", "None at all"],
        right: 1,
        state: { ...LAGRANGE, point: { h: "1.6", l: "1.5" }, view: { h: [1.2, 2.8], l: [1.4, 2.4] } },
        explanation: "At l = 1.5 the upright rotation is the highest point of the potential. Everything slopes away from it: a top that is pushed falls over.",
      },
      {
        question: "Now l = 2.1, again with slightly more energy than the upright rotation. What is accessible near the upright direction −r̂?",
        choices: ["Only a small cap around it, cut off from the rest", "The whole sphere again"],
        right: 0,
        state: { ...LAGRANGE, point: { h: "2.15", l: "2.1" }, view: { h: [1.4, 2.8], l: [1.6, 2.4] } },
        explanation: "The upright rotation has become a minimum surrounded by a barrier. The top can only wobble a little: it sleeps. (The other disc, around the hanging direction, cannot be reached.)",
      },
      {
        question: "At which l does the upright rotation become a minimum?",
        choices: ["l = 1", "l = 2", "l = 4"],
        right: 1,
        state: { ...LAGRANGE, point: { h: "2.03", l: "2.02" }, view: { h: [1.8, 2.2], l: [1.85, 2.1] } },
        explanation: "At l = 2. Just below, a ring of slightly tilted rotations is the minimum instead; at l = 2 it shrinks to the upright one. With transverse moment A₂ and |r| = 1 the rule is l² = 4 A₂.",
      },
    ],
    worksheet: [
      "Sketch the potential U against the angle from upright, for l = 1.5, 1.9 and 2.1.",
      "Set A to (2, 1.5, 1.5). Predict the l above which the top sleeps, then find it in the diagram. What do you get for l²/A₂?",
      "For l = 1.9 there are two circles of tilted rotations. Which of them is stable? What does a top do that starts close to the other?",
    ],
  },
  {
    id: "genus",
    title: "What the genus means",
    minutes: 40,
    objectives: [
      "Count the boundary circles and poles of U on the sphere.",
      "Find the genus of the section from them: circles + poles − 1.",
      "Predict how the genus changes when a curve is crossed.",
    ],
    tasks: [
      {
        question: "U is a disc that contains the pole +r̂ (centre of mass straight down) but not −r̂. What is the section over it?",
        choices: ["A sphere", "A torus", "A surface of genus two"],
        right: 1,
        state: { point: { h: "0.3", l: "1" } },
        explanation: "One circle and one pole: genus 1 + 1 − 1 = 1, a torus. Without a pole the two halves over a disc, glued along its edge, would make a sphere; each pole adds a handle.",
      },
      {
        question: "U is a sphere with two discs cut out and contains only the pole +r̂. What is the genus?",
        choices: ["1", "2", "3"],
        right: 1,
        state: { point: { h: "3.53", l: "2.862" } },
        explanation: "Two circles and one pole: 2 + 1 − 1 = 2.",
      },
      {
        question: "From there the energy increases until the second pole −r̂ enters U as well, with the same two circles. How does the genus change?",
        choices: ["It stays the same", "It increases by one", "It decreases by one"],
        right: 1,
        state: { point: { h: "33.586", l: "8.428" } },
        explanation: "At the dotted line a pole enters and adds a handle: genus 3, the largest for this body.",
      },
    ],
    worksheet: [
      "Fill in a table for all nine regions of the paper's body: circles, poles, genus. Check the rule circles + poles − 1 for each component.",
      "Which curve must you cross to turn one surface into two spheres? Describe what U does there.",
      "Kovalevskaya's top has a region with three circles. Find it. What is its genus?",
    ],
  },
  {
    id: "order-chaos",
    title: "Order and chaos",
    minutes: 40,
    objectives: [
      "Distinguish regular and chaotic orbits in a section.",
      "Relate a conserved quantity to curves in the section.",
      "Interpret a Lyapunov exponent as the rate at which neighbouring motions separate.",
    ],
    tasks: [
      {
        question: "Kovalevskaya's top has one conserved quantity besides energy and l. What will a single orbit draw on the section?",
        choices: ["A curve", "A cloud that fills an area", "A single dot"],
        right: 0,
        state: { ...KOVALEVSKAYA, point: { h: "2", l: "1" } },
        explanation: "On the two-dimensional section the additional quantity confines each orbit to a curve. All orbits are regular.",
      },
      {
        question: "The paper's body has no such quantity. At h = 6, l = 2, what do its orbits draw?",
        choices: ["Only curves", "Only clouds", "Curves and clouds side by side"],
        right: 2,
        state: { point: { h: "6", l: "2" }, coloring: "verdict" },
        explanation: "A weak perturbation leaves many curves intact, with clouds between them. Colours show which orbits are regular and which are chaotic; grey ones are undecided.",
      },
      {
        question: "At h = −0.5, l = 0.5, slightly above the lowest energy, what do you expect?",
        choices: ["Almost only curves", "Almost only clouds"],
        right: 0,
        state: { point: { h: "-0.5", l: "0.5" }, coloring: "lyapunov" },
        explanation: "Near a minimum the body swings like two independent pendulums: almost everything is regular. Chaos appears with more energy.",
      },
    ],
    worksheet: [
      "For h = 0.6, 1, 2, 4, 6 at l = 2 estimate the fraction of the section that clouds fill.",
      "Click two points of one cloud very close to each other. After how many crossings have the orbits clearly separated?",
      "An exponent of 0.15 per unit of time: after what time has an error of one part in a million grown to order 1?",
    ],
  },
];

/** A lesson as a page to print; `address` opens it. */
export function worksheetOf({ title, minutes, objectives, tasks, worksheet }: Lesson, address: string): string {
  const list = (items: string[], kind: "ol" | "ul") => `<${kind}>${items.map((item) => `<li>${item}</li>`).join("")}</${kind}>`;
  const room = '<div class="room"></div>';
  const predictions = tasks.map(({ question, choices }) => `<p>${question}</p>${list(choices.map((choice) => `☐ ${choice}`), "ul")}<p>What I saw:</p>${room}`);
  return `<!doctype html><html lang="en"><meta charset="utf-8"><title>${title}</title>
<style>body{font:16px/1.5 system-ui,sans-serif;max-width:46rem;margin:2rem auto;padding:0 1rem}ul{list-style:none}.room{height:5rem;border-bottom:1px dotted #888}</style>
<h1>${title}</h1><p>${minutes} minutes. Name: ____________________</p><p>The page: <a href="${address}">${address}</a></p><h2>What you will be able to do</h2>${list(objectives, "ol")}
<h2>Predict, then observe</h2>${predictions.join("")}<h2>On your own</h2><ol>${worksheet.map((task) => `<li>${task}${room}</li>`).join("")}</ol></html>`;
}
