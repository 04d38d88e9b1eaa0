/** Stability in words. */
import type { RelativeEquilibrium } from "../bindings/documents";
import { texts } from "../texts";

/** The verdict on a steady motion, without friction and with it. */
export function stabilityLine({ nonlinear, friction }: Pick<RelativeEquilibrium, "nonlinear" | "friction">): string {
  const words = texts.stability;
  const damped = { survives: words.survives, lost: words.lost(friction.growing), open: words.open };
  return words.friction(words[nonlinear.verdict], words.why[nonlinear.why], damped[friction.conserving_l ?? "open"]);
}
