// Files of the repository that pages of the site show or link.
import { copyFileSync, existsSync, mkdirSync, readFileSync, statSync } from "node:fs";
import path from "node:path";

/** Larger files are named and not linked. */
const LARGEST = 1 << 20;

export class Files {
  constructor(root, out, pages) {
    Object.assign(this, { root, out, pages });
  }

  /** Where a link in a source leads on the site; nothing where the site has nothing. `depth`: folders above the page. */
  address(source, link, depth = 0) {
    if (/^(https?:|mailto:|#)/.test(link)) return link;
    const [file, anchor] = link.split("#");
    const target = path.posix.normalize(path.posix.join(path.posix.dirname(source), file));
    const page = this.pages.get(target);
    const place = page ?? this.copy(target);
    return place && "../".repeat(depth) + place + (anchor ? `#${anchor}` : "");
  }

  copy(file) {
    const from = path.join(this.root, file);
    if (file.startsWith("..") || !existsSync(from) || !statSync(from).isFile() || statSync(from).size > LARGEST) return undefined;
    const to = path.posix.join("files", file);
    mkdirSync(path.join(this.out, path.dirname(to)), { recursive: true });
    copyFileSync(from, path.join(this.out, to));
    return to;
  }
}

/** The size of an SVG or PNG file in pixels, so that a page does not jump when it comes. */
export function sizeOf(file) {
  const bytes = readFileSync(file);
  if (file.endsWith(".png")) return [bytes.readUInt32BE(16), bytes.readUInt32BE(20)];
  const box = /viewBox="\S+ \S+ (\S+) (\S+)"/.exec(bytes.toString("utf8", 0, 2000));
  return box && [Number(box[1]), Number(box[2])].map(Math.round);
}

/** The command that a picture says it was made by. */
export const commandOf = (file) => /command: (bifdiag [^<]*?)(?: --json)?<\/metadata>/.exec(readFileSync(file, "utf8").slice(0, 4000))?.[1];
