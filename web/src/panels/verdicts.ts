/** Regular, chaotic or open: how many orbits are which, which one is chosen, and why it is so. */
import type { Orbit, Verdict } from "../bindings/documents";
import { make } from "../draw/dom";
import { ink, verdictColor } from "../draw/theme";
import { shown } from "../state/numbers";
import type { Session } from "../state/session";

const VERDICTS: readonly Verdict[] = ["regular", "chaotic", "open"];

/** An orbit in a few words. */
export function orbitLine({ orbit, verdict, chaos }: Orbit): string {
  const measures = [chaos?.lyapunov && `λ = ${shown(chaos.lyapunov.exponent, 2)}`, chaos?.rotation && `rotation number ${shown(chaos.rotation.number, 4)}`];
  return [`orbit ${orbit}: ${verdict}`, ...measures.filter(Boolean)].join(", ");
}

/** The counts, the orbit that is chosen, and the reason of its verdict. */
export function verdicts(session: Session): { legend: HTMLElement; choice: HTMLElement; reason: HTMLElement } {
  const { orbits } = session;
  const legend = make("span", { className: "legend", data: { testid: "verdicts" } });
  const choice = make("select", { title: "The orbit that the body follows", attributes: { "aria-label": "orbit" }, data: { testid: "orbit" } });
  const reason = make("p", { className: "reason", attributes: { "aria-live": "polite" }, data: { testid: "verdict" } });
  choice.addEventListener("change", () => orbits.select(Number(choice.value)));
  const chosen = () => {
    choice.value = String(orbits.selected);
    const orbit = orbits.judged[orbits.selected];
    reason.textContent = orbit ? `Orbit ${orbit.orbit} is ${orbit.verdict}: ${orbit.reason}` : orbits.running ? "Computing orbits …" : "";
    reason.dataset.verdict = orbit?.verdict ?? "";
  };
  const show = () => {
    const { dark } = ink();
    const count = (verdict: Verdict) => orbits.judged.filter((orbit) => orbit?.verdict === verdict).length;
    legend.replaceChildren(
      ...VERDICTS.map((verdict) => {
        const swatch = make("i", { className: "swatch" });
        swatch.style.background = verdictColor(verdict, dark);
        legend.dataset[verdict] = String(count(verdict));
        return make("span", {}, session.state.coloring === "verdict" && swatch, `${count(verdict)} ${verdict}`);
      }),
    );
    const there = orbits.rows.length > 0;
    legend.hidden = choice.hidden = !there;
    // An open list is not made anew under the hand while verdicts come in.
    if (choice.options.length !== orbits.rows.length) choice.replaceChildren(...orbits.rows.map((_, i) => make("option", { value: String(i) })));
    for (const [i, option] of [...choice.options].entries()) {
      const verdict = orbits.judged[i]?.verdict;
      option.text = verdict ? `orbit ${i}: ${verdict}` : `orbit ${i}`;
    }
    chosen();
  };
  session.on(["orbits", "section", "theme"], show);
  session.on(["selection"], chosen);
  return { legend, choice, reason };
}
