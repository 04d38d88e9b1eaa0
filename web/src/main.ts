/** Puts the page together. */
import "./style.css";
import { make } from "./draw/dom";
import { guides } from "./guide/guides";
import { bodiesPanel } from "./panels/bodies";
import { bodyPanel, presetsOf } from "./panels/body";
import { Clock } from "./panels/clock";
import { diagramPanel } from "./panels/diagram";
import { headPanel } from "./panels/head";
import { messagePanel } from "./panels/message";
import { motionPanel } from "./panels/motion";
import { pointPanel } from "./panels/point";
import { regionsPanel } from "./panels/regions";
import { sectionPanel } from "./panels/section";
import { spherePanel } from "./panels/sphere";
import { takePanel } from "./panels/take";
import { api } from "./api";
import { parse } from "./state/hash";
import { Session } from "./state/session";
import { bodyText, FIRST } from "./state/state";

async function begin(): Promise<void> {
  const root = document.querySelector("main")!;
  const session = new Session();
  const clock = new Clock();
  const presets = presetsOf(await session.presets());
  const diagram = diagramPanel(session);
  const sphere = spherePanel(session);
  const section = sectionPanel(session, clock);
  const motion = motionPanel(session, clock);
  const bodies = bodiesPanel(session);
  const guide = guides(session);
  const sheets = { diagram: diagram.sheet, sphere: sphere.sheet, section: section.sheet, motion: motion.sheet, bodies: bodies.sheet };
  const column = (name: string, ...panels: HTMLElement[]) => make("div", { className: `column ${name}` }, ...panels);
  root.replaceChildren(
    column("left", bodyPanel(session, presets), regionsPanel(session)),
    column("middle", diagram.element, pointPanel(session), guide.card),
    column("right", make("div", { className: "beside" }, sphere.element, motion.element), section.element),
    column("below", bodies.element, takePanel(session, sheets)),
  );
  document.body.prepend(headPanel(session, guide.buttons));
  document.body.append(messagePanel(session));
  api(session);
  for (const [name, panel] of Object.entries({ diagram, sphere, section, motion })) panel.element.dataset.panel = name;

  const named = (name: string) => presets.find((preset) => preset.name === name);
  const read = () => {
    try {
      session.set(parse(location.hash, named));
    } catch (error) {
      // What is wrong stays in the address and is told over the paper's body.
      const wrong = location.hash;
      if (!session.drawn) session.set({ ...FIRST });
      history.replaceState(null, "", wrong);
      session.fail(error instanceof Error ? error.message : String(error));
      document.documentElement.dataset.ready = "true";
    }
  };
  addEventListener("hashchange", () => {
    document.documentElement.dataset.ready = "false";
    read();
  });
  read();
  // Where the address is no secure one there is no such thing, and the page needs its server when it is opened again.
  if (import.meta.env.PROD) void navigator.serviceWorker?.register("./offline.js").catch(() => undefined);
  document.title = `bifdiag: ${bodyText(session.state)}`;
}

begin().catch((error: Error) => {
  document.querySelector("main")!.replaceChildren(make("p", { className: "error", data: { testid: "error" } }, `The explorer could not start: ${error.message}`));
  document.documentElement.dataset.ready = "true";
});
