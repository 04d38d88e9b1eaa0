/** The effective potential. */
import type { Vec } from "../draw/ball";

/** U_l(γ) = l²/(2⟨γ,Aγ⟩) − ⟨γ,r⟩, Eq. (Ul) of the paper. */
export const potential = (a: Vec, r: Vec, l: number) => (g: Vec): number =>
  (0.5 * l * l) / (a[0] * g[0] * g[0] + a[1] * g[1] * g[1] + a[2] * g[2] * g[2]) - g[0] * r[0] - g[1] * r[1] - g[2] * r[2];
