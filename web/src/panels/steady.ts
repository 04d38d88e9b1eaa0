/** The steady rotations at the momentum of the point, with the verdict on each. */
import { make } from "../draw/dom";
import { branchColors, ink } from "../draw/theme";
import { shown } from "../state/numbers";
import type { Session } from "../state/session";
import { stabilityLine } from "./stability";
import { texts } from "../texts";

export function steadyTable(session: Session): HTMLElement {
  const title = make("h3", {});
  const body = make("tbody", {});
  const head = make("tr", {}, ...texts.regions.columns.map((name) => make("th", {}, name)));
  const exceptions = make("p", { className: "note", data: { testid: "verdict-changes" } });
  const element = make("div", { className: "steady", hidden: true }, title, make("table", {}, make("thead", {}, head), body), exceptions);
  const show = () => {
    const { critical, state, drawn } = session;
    // Under the hand the table is that of the place where the hand came from.
    if (session.dragging && body.rows.length > 0) return;
    element.hidden = critical.length === 0 || !state.point;
    if (element.hidden || !state.point || !drawn) return;
    const palette = branchColors(drawn.document, ink().dark);
    title.textContent = texts.regions.steady(state.point.l);
    body.replaceChildren(
      ...[...critical].sort((a, b) => a.h - b.h).map((one) => {
        const swatch = make("i", { className: "swatch line" });
        swatch.style.background = palette.get(one.branch) ?? palette.get(drawn.document.curves.find(({ id }) => id === one.branch)?.branch ?? "") ?? "";
        const friction = { survives: texts.stability.stable, lost: texts.stability.unstable, open: texts.stability.open }[one.friction.conserving_l ?? "open"];
        const row = make("tr", { title: `${one.branch_name}: ${stabilityLine(one)}`, data: { testid: "steady-row", curve: one.branch } }, make("td", {}, swatch, one.branch), make("td", {}, shown(one.h)), make("td", {}, texts.stability[one.nonlinear.verdict]), make("td", {}, friction));
        row.addEventListener("pointerenter", () => session.pointAt({ curve: one.branch }));
        row.addEventListener("pointerleave", () => session.pointAt({}));
        return row;
      }),
    );
  };
  const tell = () => {
    const changes = session.atlas?.verdict_changes ?? [];
    const told = changes.map(({ curve, kind, l, verdict }) => texts.regions.failure(kind === "D4" ? "D₄ = 0" : kind, curve, shown(l), texts.stability[verdict]));
    exceptions.textContent = told.length > 0 ? texts.regions.fails(told.join("; ")) : "";
  };
  const mark = () => {
    for (const row of body.rows) row.classList.toggle("lit", row.dataset.curve === session.hover.curve);
  };
  session.on(["point", "theme", "atlas"], show);
  session.on(["body", "atlas"], tell);
  session.on(["hover"], mark);
  return element;
}
