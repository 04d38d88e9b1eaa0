/** Take it away: the address, the documents, pictures, data, and the lines that give the same. */
import type { Sheet } from "../draw/canvas";
import { button, copied, make, panel } from "../draw/dom";
import { valueOf } from "../state/numbers";
import type { Session } from "../state/session";
import { FIRST, type State } from "../state/state";

export type Sheets = Record<string, Sheet>;

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
  const link = make("a", { href: "#", data: { testid: "permalink" } }, "Link to this view");
  link.addEventListener("click", (event) => {
    event.preventDefault();
    void navigator.clipboard?.writeText(location.href).then(() => (link.textContent = "Copied to the clipboard"));
  });
  const task = button("Link to a task …", "A link that opens this view with a question or a task of yours", () => void import("../guide/worksheet").then(({ openWorksheet }) => openWorksheet(session)), { testid: "task-open" });
  const shell = make("code", { data: { testid: "command-line" } });
  const python = make("code", { data: { testid: "python-lines" } });
  const refresh = () => {
    // Nobody copies from under the hand, and each text moves what stands below it.
    if (session.dragging) return;
    link.href = location.href;
    link.textContent = "Link to this view";
    shell.textContent = commandLines(session.state);
    python.textContent = pythonLines(session.state);
  };
  session.on(["body", "point", "atlas", "theme", "address"], refresh);
  const json = button("Atlas as JSON", "The document that bifdiag --json prints, byte for byte", () => void files().then(({ save }) => save(`${nameOf(session)}.json`, session.text, "application/json")), { testid: "export-json" });
  const choice = make("select", { attributes: { "aria-label": "panel" } }, ...Object.keys(sheets).map((name) => make("option", { value: name }, name)));
  const svg = button("SVG", "The selected panel as SVG", async () => { const { save, svgOf } = await files(); save(`${choice.value}.svg`, await svgOf(sheets[choice.value]!), "image/svg+xml"); }, { testid: "export-svg" });
  const png = button("PNG", "The selected panel as PNG", async () => { const { save, pictureOf } = await files(); save(`${choice.value}.png`, await pictureOf(sheets[choice.value]!)); }, { testid: "export-png" });
  let finish: (() => void) | null = null;
  const video = button("Record", "Record a video of the selected panel; press again to stop", async () => {
    const { record } = await import("../export/video");
    try {
      if (finish) finish();
      finish = finish ? null : record(sheets[choice.value]!, choice.value);
    } catch (error) {
      session.fail(error instanceof Error ? error.message : String(error));
    }
    video.textContent = finish ? "Stop and save" : "Record";
    choice.disabled = finish !== null;
  }, { testid: "export-video" });
  const csv = button("Crossings as CSV", "One line per crossing", () => void files().then(({ save, crossingsCsv }) => save("section.csv", crossingsCsv(session.orbits.rows), "text/csv")), { testid: "export-csv" });
  const npz = button("Crossings as NPZ", "Arrays for numpy.load", async () => { const { save, crossingsNpz } = await files(); save("section.npz", await crossingsNpz(session)); }, { testid: "export-npz" });
  return panel(
    "Export",
    "Links, documents, pictures and data",
    make("div", { className: "take" },
      make("div", {}, make("div", { className: "row" }, link, task, json), make("h3", {}, "Picture of"), make("div", { className: "row" }, choice, svg, png, video), make("h3", {}, "Section"), make("div", { className: "row" }, csv, npz)),
      make("div", {}, make("h3", {}, "On the command line"), copied(shell)),
      make("div", {}, make("h3", {}, "In Python"), copied(python)),
    ),
  );
}

const nameOf = ({ state }: Session): string => `atlas-${[...state.A, ...state.r].map((text) => valueOf(text)).join("_")}`;
