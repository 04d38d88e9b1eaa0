/** Eight steps through the paper; each is a state of the page and what to see in it. */
import type { State } from "../state/state";

export interface Step {
  title: string;
  text: string;
  /** What the reader can try. */
  attempt: string;
  /** What the step sets over the first state. */
  state: Partial<State>;
}

const KOVALEVSKAYA: Pick<State, "A" | "r"> = { A: ["2", "2", "1"], r: ["1", "0", "0"] };
const LAGRANGE: Pick<State, "A" | "r"> = { A: ["2", "1", "1"], r: ["1", "0", "0"] };

export const TOUR: Step[] = [
  {
    title: "One body, nine regions",
    text: "A rigid body turns about a fixed point under gravity. Two quantities are conserved: its energy h and its angular momentum l about the vertical. The diagram shows all pairs (h, l) for the paper's body. Within each of the nine tinted regions the set of possible motions has the same shape; grey means that no motion has so little energy.",
    attempt: "Move the pointer over the diagram, or tap in it, and watch the table of regions.",
    state: {},
  },
  {
    title: "Curves are steady rotations",
    text: "On each solid or dashed curve the body can turn steadily about the vertical: solid where that rotation is stable (thin if only as long as there is no friction), dashed where it is unstable. Dots are events, where curves meet, end in cusps or split. The dotted lines are not steady rotations: there it becomes possible for the centre of mass to hang straight down or stand straight up.",
    attempt: "Hover over a curve to see its index and stability.",
    state: { view: { h: [0.5, 6], l: [1.7, 4] } },
  },
  {
    title: "What the energy allows",
    text: "Seen from the body, the vertical is a moving direction, a point on a sphere. For given h and l it stays within the coloured part U. Here, in region R5, U consists of two discs, and a motion that starts in one can never reach the other.",
    attempt: "Turn the sphere. Hover over one of the two lines under the diagram to see its disc.",
    state: { point: { h: "3.8", l: "3.25" } },
  },
  {
    title: "The section",
    text: "A dot is drawn whenever the centre of mass is at its highest or lowest. All these moments form a surface, the Poincaré section, shown as two halves that are glued along the dark line. Over a disc without a pole it is a sphere; over a disc with one pole it is a torus.",
    attempt: "Click anywhere in the section: the orbit that starts there appears, and the body moves along it. Each flash marks a moment at which the centre of mass is highest or lowest.",
    state: { point: { h: "3.8", l: "3.25" }, seed: 1 },
  },
  {
    title: "Surgery",
    text: "When you cross a curve, the section changes its shape. Here, in the narrow region R6, the two discs have just merged into a strip with a hole on either side. The section is a surface with two handles, like a pretzel.",
    attempt: "Drag the point slowly left and right across the curves. A sentence describes each change.",
    state: { point: { h: "3.53", l: "2.862" }, view: { h: [2.6, 4.6], l: [2.3, 3.4] } },
  },
  {
    title: "Kovalevskaya's top",
    text: "Sofya Kovalevskaya found a body, A = (2, 2, 1) with its centre of mass in the plane of equal moments, whose motion has one more conserved quantity. Every orbit therefore stays on a curve of the section: there is no chaos at any h and l.",
    attempt: "Move A slightly away from (2, 2, 1) in the triangle and compare.",
    state: { ...KOVALEVSKAYA, point: { h: "2", l: "1" } },
  },
  {
    title: "The sleeping top",
    text: "Lagrange's top has its centre of mass on its axis. Upright, it falls when it spins slowly and sleeps above l = 2. In the diagram this is where the curve of the upright rotation meets that of the tilted rotations, which form circles.",
    attempt: "Drag the point along the curve near (h, l) = (2, 2) and watch the island of U around the upright direction −r̂.",
    state: { ...LAGRANGE, point: { h: "2.1", l: "2.05" }, view: { h: [1.4, 2.8], l: [1.6, 2.4] } },
  },
  {
    title: "Chaos in one click",
    text: "Back to the paper's body, with more energy. Some orbits draw curves; others fill areas. Those are chaotic: two motions that start almost alike soon have nothing in common. Two independent criteria must agree before an orbit is called regular or chaotic; otherwise it stays open.",
    attempt: "Click in the cloud, then on a curve. The verdict on the orbit and its reason appear below the section.",
    state: { point: { h: "6", l: "2" }, coloring: "verdict" },
  },
];
