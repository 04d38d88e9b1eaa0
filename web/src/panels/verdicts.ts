/** Regular, chaotic or open: how many orbits are which, which one is chosen, and why it is so. */
import type { Orbit, Verdict } from "../bindings/documents";
import { make } from "../draw/dom";
import { ink, verdictColor } from "../draw/theme";
import { shown } from "../state/numbers";
import type { Session } from "../state/session";
import { texts } from "../texts";

const VERDICTS: readonly Verdict[] = ["regular", "chaotic", "open"];

/** An orbit in a few words. */
export function orbitLine({ orbit, verdict, chaos }: Orbit): string {
  const measures = [chaos?.lyapunov && `λ = ${shown(chaos.lyapunov.exponent, 2)}`, chaos?.rotation && texts.section.rotation(shown(chaos.rotation.number, 4))];
  return [`${texts.section.orbit(orbit)}: ${texts.section.verdicts[verdict]}`, ...measures.filter(Boolean)].join(", ");
}

/** The counts, the orbit that is chosen, and the reason of its verdict. */
export function verdicts(session: Session): { legend: HTMLElement; choice: HTMLElement; reason: HTMLElement } {
  const { orbits } = session;
  const legend = make("span", { className: "legend", data: { testid: "verdicts" } });
  const choice = make("select", { title: texts.section.follow, attributes: { "aria-label": texts.section.orbitLabel }, data: { testid: "orbit" } });
  const reason = make("p", { className: "reason", attributes: { "aria-live": "polite" }, data: { testid: "verdict" } });
  choice.addEventListener("change", () => orbits.select(Number(choice.value)));
  const chosen = () => {
    choice.value = String(orbits.selected);
    const orbit = orbits.judged[orbits.selected];
    reason.textContent = orbit ? texts.section.reason(orbit.orbit, texts.section.verdicts[orbit.verdict], orbit.reason) : orbits.running ? texts.section.computing : "";
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
        return make("span", {}, session.state.coloring === "verdict" && swatch, texts.section.counted(count(verdict), verdict));
      }),
    );
    const there = orbits.rows.length > 0;
    legend.hidden = choice.hidden = !there;
    // An open list is not made anew under the hand while verdicts come in.
    if (choice.options.length !== orbits.rows.length) choice.replaceChildren(...orbits.rows.map((_, i) => make("option", { value: String(i) })));
    for (const [i, option] of [...choice.options].entries()) {
      const verdict = orbits.judged[i]?.verdict;
      option.text = verdict ? `${texts.section.orbit(i)}: ${texts.section.verdicts[verdict]}` : texts.section.orbit(i);
    }
    chosen();
  };
  session.on(["orbits", "section", "theme"], show);
  session.on(["selection"], chosen);
  return { legend, choice, reason };
}
