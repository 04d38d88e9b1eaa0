/** A video of what is seen: the chosen panel's canvas, as the browser records it. */
import type { Sheet } from "../draw/canvas";
import { save } from "./files";
import { texts } from "../texts";

const KINDS = ["video/webm;codecs=vp9", "video/webm", "video/mp4"];
const FRAMES_A_SECOND = 30;

/** Begins to record; the function that is returned ends it and saves the file. */
export function record(sheet: Sheet, name: string): () => void {
  const kind = KINDS.find((kind) => typeof MediaRecorder !== "undefined" && MediaRecorder.isTypeSupported(kind));
  if (!kind) throw new Error(texts.failure.video);
  const recorder = new MediaRecorder(sheet.element.captureStream(FRAMES_A_SECOND), { mimeType: kind });
  const parts: Blob[] = [];
  recorder.ondataavailable = ({ data }) => parts.push(data);
  recorder.onstop = () => save(`${name}.${kind.startsWith("video/mp4") ? "mp4" : "webm"}`, new Blob(parts, { type: kind }));
  recorder.start(500);
  sheet.ask();
  return () => recorder.stop();
}
