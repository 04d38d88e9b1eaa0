/** Take it away: the address, the documents, pictures, data, and the lines that give the same. */
import type { Sheet } from "../draw/canvas";
import { button, copied, make, panel } from "../draw/dom";
import { valueOf } from "../state/numbers";
import type { Session } from "../state/session";
import { FIRST, PANELS, type Panel, type State } from "../state/state";
import { guideTexts, texts } from "../texts";

export type Sheets = Record<Panel, Sheet>;

type Asked = Pick<State, "A" | "r" | "straight" | "point" | "orbits" | "crossings" | "seed">;

/** What was asked of the section beyond the usual. */
const asked = (state: Asked, option: (name: string, value: number) => string): string =>
  (["orbits", "crossings", "seed"] as const).filter((name) => state[name] !== FIRST[name]).map((name) => option(name, state[name])).join("");

export function commandLines(state: Asked): string {
  const { A, r, straight, point } = state;
  const body = `--A=${A.join(",")} --r=${r.join(",")}`;
  const lines = [`bifdiag ${body}${straight ? " --view=straight" : ""}`];
  const options = asked(state, (name, value) => ` --${name}=${value}`);
  if (point) lines.push(`bifdiag classify ${body} --h=${point.h} --l=${point.l}`, `bifdiag section ${body} --h=${point.h} --l=${point.l}${options}`);
  return lines.join("\n");
}

export function pythonLines(state: Asked): string {
  const { A, r, point } = state;
  const list = (numbers: string[]) => `[${numbers.map((number) => `"${number}"`).join(", ")}]`;
  const lines = ["import bifdiag", `body = bifdiag.Body(A=${list(A)}, r=${list(r)})`, "atlas = body.atlas()"];
  const options = asked(state, (name, value) => `, ${name}=${value}`);
  if (point) lines.push(`body.classify("${point.h}", "${point.l}")`, `body.section("${point.h}", "${point.l}"${options})`);
  return lines.join("\n");
}

/** Loaded when first used. */
const files = () => import("../export/files");

export function takePanel(session: Session, sheets: Sheets): HTMLElement {
  const link = make("a", { href: "#", data: { testid: "permalink" } }, texts.take.link);
  link.addEventListener("click", (event) => {
    event.preventDefault();
    void navigator.clipboard?.writeText(location.href).then(() => (link.textContent = texts.take.linked));
  });
  // Loaded once: what opens again must not show for a moment what it said before.
  let openTask: (() => void) | null = null;
  const task = button(texts.take.task, texts.take.taskHelp, async () => {
    if (!openTask) {
      const [{ worksheet }, { dialog }] = await Promise.all([import("../guide/worksheet"), guideTexts()]);
      openTask = worksheet(session, dialog);
    }
    openTask();
  }, { testid: "task-open" });
  const shell = make("code", { data: { testid: "command-line" } });
  const python = make("code", { data: { testid: "python-lines" } });
  const refresh = () => {
    // Nobody copies from under the hand, and each text moves what stands below it.
    if (session.dragging) return;
    link.href = location.href;
    link.textContent = texts.take.link;
    // Lines are broken between options, not behind their hyphens.
    shell.replaceChildren(...commandLines(session.state).split(/(\s+)/).map((part) => (part.trim() ? make("span", {}, part) : part)));
    python.textContent = pythonLines(session.state);
  };
  session.on(["body", "point", "atlas", "theme", "address"], refresh);
  const json = button(texts.take.json, texts.take.jsonHelp, () => void files().then(({ save }) => save(`${nameOf(session)}.json`, session.text, "application/json")), { testid: "export-json" });
  const choice = make("select", { attributes: { "aria-label": texts.take.panel } }, ...PANELS.map((name) => make("option", { value: name }, texts.panels[name])));
  const svg = button("SVG", texts.take.svgHelp, async () => { const { save, svgOf } = await files(); save(`${choice.value}.svg`, await svgOf(sheets[choice.value as Panel]), "image/svg+xml"); }, { testid: "export-svg" });
  const png = button("PNG", texts.take.pngHelp, async () => { const { save, pictureOf } = await files(); save(`${choice.value}.png`, await pictureOf(sheets[choice.value as Panel])); }, { testid: "export-png" });
  let finish: (() => void) | null = null;
  const video = button(texts.take.record, texts.take.recordHelp, async () => {
    const { record } = await import("../export/video");
    try {
      if (finish) finish();
      finish = finish ? null : record(sheets[choice.value as Panel], choice.value);
    } catch (error) {
      session.fail(error instanceof Error ? error.message : String(error));
    }
    video.textContent = finish ? texts.take.recording : texts.take.record;
    choice.disabled = finish !== null;
  }, { testid: "export-video" });
  const csv = button(texts.take.csv, texts.take.csvHelp, () => void files().then(({ save, crossingsCsv }) => save("section.csv", crossingsCsv(session.orbits.rows), "text/csv")), { testid: "export-csv" });
  const npz = button(texts.take.npz, texts.take.npzHelp, async () => { const { save, crossingsNpz } = await files(); save("section.npz", await crossingsNpz(session)); }, { testid: "export-npz" });
  return panel(
    texts.take.title,
    texts.take.help,
    make("div", { className: "take" },
      make("div", {}, make("div", { className: "row" }, link, task, json), make("h3", {}, texts.take.picture), make("div", { className: "row" }, choice, svg, png, video), make("h3", {}, texts.take.section), make("div", { className: "row" }, csv, npz)),
      make("div", {}, make("h3", {}, texts.take.shell), copied(shell)),
      make("div", {}, make("h3", {}, texts.take.python), copied(python)),
    ),
  );
}

const nameOf = ({ state }: Session): string => `atlas-${[...state.A, ...state.r].map((text) => valueOf(text)).join("_")}`;
