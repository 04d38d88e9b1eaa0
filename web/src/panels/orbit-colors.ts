/** What the colours of a section's points tell. */
import { openColor, orbitColor, scaled, verdictColor } from "../draw/theme";
import { shown } from "../state/numbers";
import type { Session } from "../state/session";
import { texts } from "../texts";

type Scale = "lyapunov" | "rotation";

const valuesOf = ({ orbits }: Session, scale: Scale): (number | null)[] =>
  orbits.starts.map((_, i) => {
    const chaos = orbits.judged[i]?.chaos;
    return (scale === "lyapunov" ? chaos?.lyapunov?.exponent : chaos?.rotation?.number) ?? null;
  });

const ends = (values: (number | null)[]): [number, number] => {
  const known = values.filter((value) => value !== null);
  return [Math.min(...known), Math.max(...known)];
};

/** The colour of each orbit as it was asked for. */
export function colorsOf(session: Session, dark: boolean): (orbit: number) => string {
  const { coloring } = session.state;
  const { judged } = session.orbits;
  if (coloring === "orbit") return (orbit) => orbitColor(orbit, dark);
  if (coloring === "verdict") return (orbit) => verdictColor(judged[orbit]?.verdict ?? "open", dark);
  const values = valuesOf(session, coloring);
  const [low, high] = ends(values);
  return (orbit) => {
    const value = values[orbit] ?? null;
    return value === null ? openColor(dark) : scaled((value - low) / (high - low || 1));
  };
}

/** The values that the two ends of a scale stand for; empty where the colours are no scale. */
export function scaleText(session: Session): string {
  const { coloring } = session.state;
  if (coloring === "orbit" || coloring === "verdict") return "";
  const [low, high] = ends(valuesOf(session, coloring));
  return low <= high ? texts.section.scale(shown(low, 2), shown(high, 2)) : "";
}
