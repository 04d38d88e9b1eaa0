/** What went wrong, and what else is to be told: in the page only while it is so. */
import { make } from "../draw/dom";
import type { Session } from "../state/session";

export function messagePanel(session: Session): HTMLElement {
  const place = make("div", { className: "messages", attributes: { role: "alert" } });
  session.on(["message"], () => {
    place.replaceChildren();
    if (session.notice) place.append(make("p", { className: "notice", data: { testid: "notice" } }, session.notice));
    if (session.message) place.append(make("p", { className: "error", data: { testid: "error" } }, session.message));
  });
  return place;
}
