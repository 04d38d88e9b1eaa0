/** Stability in words. */
import type { Reason, RelativeEquilibrium } from "../bindings/documents";

/** The verdict on a steady motion, without friction and with it. */
export function stabilityLine({ nonlinear, friction }: Pick<RelativeEquilibrium, "nonlinear" | "friction">): string {
  const damped = { survives: "stable too", lost: `unstable in ${friction.growing} direction${friction.growing === 1 ? "" : "s"}`, open: "open" };
  return `${nonlinear.verdict} (${WHY[nonlinear.why]}); with friction ${damped[friction.conserving_l ?? "open"]}`;
}

const WHY: Record<Reason, string> = {
  energy: "minimum of energy",
  integral: "a further integral",
  arnold: "Arnold's theorem",
  spectrum: "eigenvalues",
  "resonance 1:2": "1:2 resonance",
  "resonance 1:3": "1:3 resonance",
  "resonance 1:1": "1:1 resonance",
  degenerate: "degenerate",
};
