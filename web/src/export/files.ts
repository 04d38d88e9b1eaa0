/** Files made in the browser. What is large is loaded when first asked for. */
import type { Sheet, Pen } from "../draw/canvas";
import { AT, ROW } from "../state/orbits";
import type { Session } from "../state/session";
import { texts } from "../texts";

export function save(name: string, content: string | Blob, type = "application/octet-stream"): void {
  const url = URL.createObjectURL(typeof content === "string" ? new Blob([content], { type }) : content);
  const link = document.createElement("a");
  Object.assign(link, { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

export const pictureOf = (sheet: Sheet): Promise<Blob> =>
  new Promise((resolve, reject) => sheet.painted().element.toBlob((blob) => (blob ? resolve(blob) : reject(new Error(texts.failure.picture))), "image/png"));

/** A panel as SVG: what is drawn with lines stays lines. */
export async function svgOf(sheet: Sheet): Promise<string> {
  const { Context } = await import("svgcanvas");
  const pen = new Context({ width: sheet.size.width, height: sheet.size.height });
  sheet.onto(pen as unknown as Pen);
  return pen.getSerializedSvg(true);
}

const COLUMNS = ["orbit", "index", "time", "gamma1", "gamma2", "gamma3", "l1", "l2", "l3", "sheet", "s_dot", "theta", "psi"];

export function crossingsCsv(orbits: Float64Array[]): string {
  const lines = [COLUMNS.join(",")];
  for (const rows of orbits) for (let at = 0; at < rows.length; at += ROW) lines.push(rows.subarray(at, at + ROW).join(","));
  return `${lines.join("\n")}\n`;
}

/** One array as NumPy's NPY. */
export function npy(kind: string, shape: string, data: Uint8Array): Uint8Array {
  const text = `{'descr': '${kind}', 'fortran_order': False, 'shape': ${shape}, }`;
  const size = Math.ceil((11 + text.length) / 64) * 64 - 10;
  const out = new Uint8Array(10 + size + data.length);
  out.set([0x93, ...new TextEncoder().encode("NUMPY"), 1, 0, size & 255, size >> 8]);
  out.set(new TextEncoder().encode(`${text.padEnd(size - 1)}\n`), 10);
  out.set(data, 10 + size);
  return out;
}

/** The crossings with the names and kinds of the command line's `--data FILE.npz`. */
export async function crossingsNpz(session: Session): Promise<Blob> {
  const { zipSync } = await import("fflate");
  const rows = Float64Array.from(session.orbits.rows.flatMap((part) => [...part]));
  const count = rows.length / ROW;
  const column = (at: number, width = 1) => Float64Array.from({ length: count * width }, (_, i) => rows[Math.floor(i / width) * ROW + at + (i % width)]!);
  const bytes = (array: { buffer: ArrayBufferLike }) => new Uint8Array(array.buffer);
  const files: Record<string, Uint8Array> = {};
  const flat = `(${count},)`;
  for (const name of ["orbit", "index"] as const) files[`${name}.npy`] = npy("<i4", flat, bytes(Int32Array.from(column(AT[name]))));
  for (const [name, at] of [["time", AT.time], ["s_dot", AT.rate], ["theta", AT.theta], ["psi", AT.psi]] as const) files[`${name}.npy`] = npy("<f8", flat, bytes(column(at)));
  for (const [name, at] of [["gamma", AT.gamma], ["l", AT.l]] as const) files[`${name}.npy`] = npy("<f8", `(${count}, 3)`, bytes(column(at, 3)));
  files["sheet.npy"] = npy("|i1", flat, bytes(Int8Array.from(column(AT.sheet))));
  const { A, r, point, crossings, seed } = session.state;
  const orbits = session.orbits.judged.filter((orbit) => orbit !== undefined);
  const meta = JSON.stringify({ A, r, ...point, signature: session.known.signature || null, crossings, seed, orbits, computed_by: "the explorer, without fused multiply-add" });
  files["meta.npy"] = npy(`<U${[...meta].length}`, "()", bytes(Uint32Array.from(meta, (letter) => letter.codePointAt(0)!)));
  return new Blob([zipSync(files, { level: 0 }) as BlobPart]);
}
