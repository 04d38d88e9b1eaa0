/** Three lessons for a class: predict first, then see. */
import type { State } from "../state/state";

export interface Task {
  question: string;
  choices: string[];
  /** The number of the right choice, from 0. */
  right: number;
  /** What to look at when the prediction is made, and why it is so. */
  state: Partial<State>;
  explanation: string;
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
      "Tell from a picture of the effective potential whether a steady rotation is a minimum.",
      "Find the spin above which an upright top sleeps.",
      "Explain why more spin makes standing stable.",
    ],
    tasks: [
      {
        question: "Lagrange's top, A = (2, 1, 1), turns upright with l = 1.5. A little more energy than that of the upright rotation is given. Which directions can the vertical reach?",
        choices: ["Only a small cap round the upright direction −r̂", "The whole sphere", "None at all"],
        right: 1,
        state: { ...LAGRANGE, point: { h: "1.6", l: "1.5" }, view: { h: [1.2, 2.8], l: [1.4, 2.4] } },
        explanation: "At l = 1.5 the upright rotation is the highest point of the potential. From it everything falls away: a top that is pushed falls over.",
      },
      {
        question: "Now l = 2.1, again with a little more energy than the upright rotation has. What is accessible near the upright direction −r̂?",
        choices: ["Only a small cap round it, cut off from the rest", "The whole sphere again"],
        right: 0,
        state: { ...LAGRANGE, point: { h: "2.15", l: "2.1" }, view: { h: [1.4, 2.8], l: [1.6, 2.4] } },
        explanation: "The upright rotation has become a minimum with a wall round it. The top can only wobble a little: it sleeps. (The other disc, round the hanging direction, cannot be reached.)",
      },
      {
        question: "At which l does the upright rotation become a minimum?",
        choices: ["l = 1", "l = 2", "l = 4"],
        right: 1,
        state: { ...LAGRANGE, point: { h: "2.03", l: "2.02" }, view: { h: [1.8, 2.2], l: [1.85, 2.1] } },
        explanation: "At l = 2. Just below, a ring of slightly leaning rotations is the minimum instead; at l = 2 it closes on the upright one. With moment A₂ across and the centre of mass at distance 1 the rule is l² = 4 A₂.",
      },
    ],
    worksheet: [
      "Sketch the potential U over the angle from upright, for l = 1.5, 1.9 and 2.1.",
      "Set A to (2, 1.5, 1.5). Predict the l above which the top sleeps, then find it in the diagram. What do you get for l²/A₂?",
      "For l = 1.9 there are two circles of leaning rotations. Which of them is stable? What does a top do that begins close to the other?",
    ],
  },
  {
    id: "genus",
    title: "What the genus means",
    minutes: 40,
    objectives: [
      "Read the number of boundary circles and poles of U off the sphere.",
      "Find the genus of the section from them: circles + poles − 1.",
      "Predict how the genus changes when a curve is crossed.",
    ],
    tasks: [
      {
        question: "U is a disc that holds the pole +r̂ (the centre of mass straight down) and not −r̂. What is the section over it?",
        choices: ["A sphere", "A torus", "A surface with two holes"],
        right: 1,
        state: { point: { h: "0.3", l: "1" } },
        explanation: "One circle and one pole: genus 1 + 1 − 1 = 1, a torus. Without a pole the two halves over a disc, glued along its edge, would make a sphere; each pole adds a handle.",
      },
      {
        question: "U is a sphere with two discs cut out, and holds +r̂ alone. What is the genus?",
        choices: ["1", "2", "3"],
        right: 1,
        state: { point: { h: "3.53", l: "2.862" } },
        explanation: "Two circles and one pole: 2 + 1 − 1 = 2.",
      },
      {
        question: "From there the energy grows until the second pole −r̂ enters U as well, with the same two circles. What becomes of the genus?",
        choices: ["It stays", "It grows by one", "It falls by one"],
        right: 1,
        state: { point: { h: "33.586", l: "8.428" } },
        explanation: "The dotted line is where a pole enters. It brings a handle: genus 3, the largest that this body has.",
      },
    ],
    worksheet: [
      "Fill in a table for all nine regions of the paper's body: circles, poles, genus. Check the rule circles + poles − 1 for each component.",
      "Which curve must be crossed to make two spheres out of one surface? Describe what U does there.",
      "Kovalevskaya's top has a region with three circles. Find it. What is its genus?",
    ],
  },
  {
    id: "order-chaos",
    title: "Order and chaos",
    minutes: 40,
    objectives: [
      "Tell regular and chaotic orbits apart in a section.",
      "Relate a conserved quantity to curves in the section.",
      "Read a Lyapunov exponent as a rate at which neighbours part.",
    ],
    tasks: [
      {
        question: "Kovalevskaya's top has one conserved quantity more than the energy and l. What will a single orbit draw on the section?",
        choices: ["A curve", "A cloud that fills an area", "A single dot"],
        right: 0,
        state: { ...KOVALEVSKAYA, point: { h: "2", l: "1" } },
        explanation: "On the two-dimensional section the further quantity leaves a curve to each orbit. All orbits are regular.",
      },
      {
        question: "The paper's body has no such quantity. At h = 6, l = 2, what do its orbits draw?",
        choices: ["Only curves", "Only clouds", "Curves and clouds side by side"],
        right: 2,
        state: { point: { h: "6", l: "2" }, coloring: "verdict" },
        explanation: "Most weak disturbances leave many curves whole; between them clouds appear. The colours tell which orbits are regular and which chaotic; grey ones could not be decided.",
      },
      {
        question: "At h = −0.5, l = 0.5, a little above the lowest energy, what do you expect?",
        choices: ["Almost only curves", "Almost only clouds"],
        right: 0,
        state: { point: { h: "-0.5", l: "0.5" }, coloring: "lyapunov" },
        explanation: "Near a minimum the body swings like two independent pendulums: almost everything is regular. Energy brings chaos.",
      },
    ],
    worksheet: [
      "For h = 0.6, 1, 2, 4, 6 at l = 2 estimate the part of the section that clouds fill.",
      "Click two points of one cloud very close to each other. After how many crossings are they clearly apart?",
      "An exponent of 0.15 per unit of time: after what time has an error of one part in a million become one of order 1?",
    ],
  },
];

/** A lesson as a page to print. */
export function worksheetOf({ title, minutes, objectives, tasks, worksheet }: Lesson): string {
  const list = (items: string[], kind: "ol" | "ul") => `<${kind}>${items.map((item) => `<li>${item}</li>`).join("")}</${kind}>`;
  const room = '<div class="room"></div>';
  const predictions = tasks.map(({ question, choices }) => `<p>${question}</p>${list(choices.map((choice) => `☐ ${choice}`), "ul")}<p>What I saw:</p>${room}`);
  return `<!doctype html><html lang="en"><meta charset="utf-8"><title>${title}</title>
<style>body{font:16px/1.5 system-ui,sans-serif;max-width:46rem;margin:2rem auto;padding:0 1rem}ul{list-style:none}.room{height:5rem;border-bottom:1px dotted #888}</style>
<h1>${title}</h1><p>${minutes} minutes. Name: ____________________</p><h2>What you will be able to do</h2>${list(objectives, "ol")}
<h2>Predict first, then see</h2>${predictions.join("")}<h2>On your own</h2><ol>${worksheet.map((task) => `<li>${task}${room}</li>`).join("")}</ol></html>`;
}
