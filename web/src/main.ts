/** Puts the page together. */
import "./style.css";
import { make } from "./draw/dom";
import { guides } from "./guide/guides";
import { story } from "./guide/story";
import { bodiesPanel } from "./panels/bodies";
import presets from "virtual:presets";
import { bodyPanel } from "./panels/body";
import { Clock } from "./panels/clock";
import { diagramPanel } from "./panels/diagram";
import { applyTheme, headPanel } from "./panels/head";
import { messagePanel } from "./panels/message";
import { motionPanel } from "./panels/motion";
import { phoneBar } from "./panels/phone";
import { presenter } from "./panels/presenter";
import { pointPanel } from "./panels/point";
import { regionsPanel } from "./panels/regions";
import { sectionPanel } from "./panels/section";
import { spherePanel } from "./panels/sphere";
import { takePanel } from "./panels/take";
import { api } from "./api";
import { parse, unknownKeys } from "./state/hash";
import { Session } from "./state/session";
import { bodyText, FIRST, START } from "./state/state";
import { language, speak, texts, wanted } from "./texts";

function begin(): void {
  const root = document.querySelector("main")!;
  const session = new Session();
  const clock = new Clock();
  // Before all panels, which draw in its colours.
  session.on(["theme"], () => applyTheme(session));
  const diagram = diagramPanel(session);
  const sphere = spherePanel(session);
  const section = sectionPanel(session, clock);
  const motion = motionPanel(session, clock);
  const bodies = bodiesPanel(session);
  const guide = guides(session);
  const sheets = { diagram: diagram.sheet, sphere: sphere.sheet, section: section.sheet, motion: motion.sheet, bodies: bodies.sheet };
  const column = (name: string, ...panels: HTMLElement[]) => make("div", { className: `column ${name}` }, ...panels);
  const body = bodyPanel(session);
  root.replaceChildren(
    column("left", body, regionsPanel(session)),
    column("middle", diagram.element, pointPanel(session), guide.card),
    column("right", make("div", { className: "beside" }, sphere.element, motion.element), section.element),
    column("below", bodies.element, takePanel(session, sheets)),
  );
  const { stack } = texts.head;
  const told = story(session);
  document.body.prepend(headPanel(session, [told.play, ...guide.buttons]));
  document.body.append(told.card, messagePanel(session), phoneBar([[stack.diagram, diagram.element], [stack.sphere, sphere.element], [stack.motion, motion.element], [stack.section, section.element], [stack.body, body], [stack.bodies, bodies.element]]));
  api(session);
  const panels = { diagram: diagram.element, sphere: sphere.element, motion: motion.element, section: section.element, bodies: bodies.element };
  for (const [name, panel] of Object.entries(panels)) panel.dataset.panel = name;
  presenter(session, panels, guide.step);

  const named = (name: string) => presets.find((preset) => preset.name === name);
  const read = (hash: string) => {
    try {
      session.set(hash.length > 1 ? parse(hash, named) : START, true);
      const unknown = unknownKeys(hash);
      session.notice = unknown.length > 0 ? texts.address.unknown(unknown.join(", ")) : "";
    } catch (error) {
      // What is wrong stays in the address and is told over the paper's body.
      if (!session.drawn) session.set({ ...FIRST }, "wrong");
      session.fail(error instanceof Error ? error.message : String(error));
      document.documentElement.dataset.ready = "true";
    }
  };
  // What settles just now may write its own address before this is told.
  addEventListener("hashchange", ({ newURL }) => {
    document.documentElement.dataset.ready = "false";
    read(new URL(newURL).hash);
  });
  read(location.hash);
  // What is kept for later is not loaded before the page is there. Where the address is no secure one there is no such thing, and
  // the page needs its server when it is opened again.
  let kept = !import.meta.env.PROD;
  session.on(["ready"], () => {
    if (kept || document.documentElement.dataset.ready !== "true") return;
    kept = true;
    void navigator.serviceWorker?.register("./offline.js").catch(() => undefined);
  });
  document.title = `bifdiag: ${bodyText(session.state)}`;
}

/** Not by `await` at the top: parts that are loaded later share this file's modules. */
speak(wanted(location.search, navigator.languages))
  .then(() => {
    document.documentElement.lang = language;
    begin();
  })
  .catch((error: unknown) => {
    const why = error instanceof Error ? error.message : String(error);
    document.querySelector("main")!.replaceChildren(make("p", { className: "error", data: { testid: "error" } }, texts?.failure.start(why) ?? why));
    document.documentElement.dataset.ready = "true";
  });
