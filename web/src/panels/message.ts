/** What went wrong: in the page only while it is so. */
import { make } from "../draw/dom";
import type { Session } from "../state/session";

export function messagePanel(session: Session): HTMLElement {
  const place = make("div", { className: "messages", attributes: { role: "alert" } });
  session.on(["message"], () => {
    place.replaceChildren();
    if (session.message) place.append(make("p", { className: "error", data: { testid: "error" } }, session.message));
  });
  return place;
}
