/** Eight steps through the paper; each is a state of the page and what to see in it. */
import type { State } from "../state/state";

export interface Step {
  title: string;
  text: string;
  /** What is to be tried, by the reader's own hand. */
  attempt: string;
  /** What the step sets over the first state. */
  state: Partial<State>;
}

const KOVALEVSKAYA: Pick<State, "A" | "r"> = { A: ["2", "2", "1"], r: ["1", "0", "0"] };
const LAGRANGE: Pick<State, "A" | "r"> = { A: ["2", "1", "1"], r: ["1", "0", "0"] };

export const TOUR: Step[] = [
  {
    title: "One body, nine regions",
    text: "A rigid body hangs on a fixed point. While it moves, two numbers stay the same: its energy h and its angular momentum l about the vertical. The diagram shows all pairs (h, l) of the paper's body at once. In each of the nine tinted regions all motions have room of the same shape; grey means that no motion has so little energy.",
    attempt: "Move the pointer over the diagram and watch the table of regions.",
    state: {},
  },
  {
    title: "Curves are steady rotations",
    text: "On each solid or dashed curve the body can turn steadily about the vertical: solid where that rotation is stable to first order, dashed where it is not. Dots are events, where curves meet, end in cusps or split. On the dotted lines nothing turns steadily; there the direction in which the centre of mass hangs straight down or stands straight up becomes possible.",
    attempt: "Hover over a curve: its index and stability are told.",
    state: { view: { h: [0.5, 6], l: [1.7, 4] } },
  },
  {
    title: "What the energy allows",
    text: "Seen from the body, the vertical is a moving direction: a point on a sphere. With given h and l it stays within the coloured part U. Here, in region R5, U consists of two discs, and a motion that begins in one can never reach the other.",
    attempt: "Turn the sphere. Hover over one of the two lines under the diagram to see its disc.",
    state: { point: { h: "3.8", l: "3.25" } },
  },
  {
    title: "The section",
    text: "A dot is drawn whenever the centre of mass is at its highest or lowest. All these moments form a surface, the Poincaré section, shown as two halves that are glued along the dark line. Over a disc without a pole it is a sphere, over a disc with one pole a torus.",
    attempt: "Click anywhere into the section: the orbit that begins there appears, and the body moves along it. Each flash is a turning point of the centre of mass.",
    state: { point: { h: "3.8", l: "3.25" }, seed: 1 },
  },
  {
    title: "Surgery",
    text: "Cross a curve, and the section changes its shape. Here, in the narrow region R6, the two discs have just merged into a strip with a hole on either side: the section is a surface with two holes, as of a pretzel.",
    attempt: "Drag the point slowly to the left and right over the curves. A sentence tells what happened.",
    state: { point: { h: "3.53", l: "2.862" }, view: { h: [2.6, 4.6], l: [2.3, 3.4] } },
  },
  {
    title: "Kovalevskaya's top",
    text: "Sofya Kovalevskaya found a body, A = (2, 2, 1) with its centre of mass in the plane of equal moments, whose motion has one conserved quantity more. Every orbit then keeps to a curve: there is no chaos at any h and l.",
    attempt: "Move A a little off (2, 2, 1) by its triangle and compare.",
    state: { ...KOVALEVSKAYA, point: { h: "2", l: "1" } },
  },
  {
    title: "The sleeping top",
    text: "Lagrange's top has its centre of mass on its axis. Standing upright it falls when it turns slowly; above l = 2 it sleeps. In the diagram this is where the curve of the upright rotation meets that of leaning ones, which come in whole circles.",
    attempt: "Drag the point along the curve near (h, l) = (2, 2) and watch the island of U round the upright direction −r̂.",
    state: { ...LAGRANGE, point: { h: "2.1", l: "2.05" }, view: { h: [1.4, 2.8], l: [1.6, 2.4] } },
  },
  {
    title: "Chaos in one click",
    text: "Back to the paper's body, with more energy. Some orbits draw curves, others fill areas: there the motion is chaotic, and two motions that begin almost alike soon have nothing in common. Two witnesses must agree before an orbit is called regular or chaotic; otherwise the question stays open.",
    attempt: "Click into the cloud and into a curve: below the section stands what the orbit is, and why.",
    state: { point: { h: "6", l: "2" }, coloring: "verdict" },
  },
];
