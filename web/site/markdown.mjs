// Markdown as it is read on the pages of a repository, with formulas set as MathML: no script and no font is needed.
import MarkdownIt from "markdown-it";
import { formula } from "./mathml.mjs";

/** The anchor of a heading. */
export const slug = (heading) =>
  heading
    .trim()
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\p{M}_ -]/gu, "")
    .replaceAll(" ", "-");

/** A line may have to be moved sideways on a phone if it has a formula longer than this. */
const LONG = 36;

/** `$…$` in a line, with no space inside its ends, and `$$` blocks. */
function mathematics(md) {
  md.inline.ruler.before("escape", "formula", (state, silent) => {
    const { src, pos } = state;
    if (src[pos] !== "$") return false;
    const marks = src[pos + 1] === "$" ? "$$" : "$";
    const end = src.indexOf(marks, pos + marks.length);
    if (end < 0 || end === pos + marks.length) return false;
    if (!silent) {
      const token = state.push("formula", "math", 0);
      token.content = src.slice(pos + marks.length, end);
      token.block = marks === "$$";
    }
    state.pos = end + marks.length;
    return true;
  });
  md.renderer.rules.formula = (tokens, at) => {
    const { content, block } = tokens[at];
    if (block) return `<span class="display">${formula(content, true)}</span>`;
    return content.length > LONG ? `<span class="long">${formula(content, false)}</span>` : formula(content, false);
  };
}

/** Anchors of headings; two of one name are told by a number. */
function anchors(md) {
  md.core.ruler.push("anchors", (state) => {
    const seen = new Map();
    state.tokens.forEach((token, at) => {
      if (token.type !== "heading_open") return;
      const text = state.tokens[at + 1].children.filter((part) => ["text", "code_inline", "formula"].includes(part.type)).map((part) => part.content);
      const name = slug(text.join(""));
      const count = seen.get(name) ?? 0;
      seen.set(name, count + 1);
      token.attrSet("id", count ? `${name}-${count}` : name);
    });
  });
}

/** `move` says where a link or a picture of the source leads on the site: an address, or nothing where there is none. */
export function reader({ mathematical, move }) {
  const md = new MarkdownIt({ html: true });
  if (mathematical) md.use(mathematics);
  md.use(anchors);
  md.core.ruler.push("links", (state) => {
    for (const { children } of state.tokens) {
      const open = [];
      for (const part of children ?? []) {
        if (part.type === "link_open") {
          const address = move(part.attrGet("href"));
          if (address) part.attrSet("href", address);
          else part.hidden = true;
          open.push(part);
        } else if (part.type === "link_close") {
          part.hidden = open.pop().hidden;
        } else if (part.type === "image") {
          part.attrSet("src", move(part.attrGet("src")));
        }
      }
    }
  });
  for (const rule of ["link_open", "link_close"]) {
    md.renderer.rules[rule] = (tokens, at, options, _env, self) => (tokens[at].hidden ? "" : self.renderToken(tokens, at, options));
  }
  // A table may be wider than a phone.
  md.renderer.rules.table_open = () => '<div class="wide"><table>\n';
  md.renderer.rules.table_close = () => "</table></div>\n";
  return md;
}

/** The first heading as text, and the headings below it that a table of contents has. */
export function outline(html) {
  const text = (part) => part.replace(/<annotation[\s\S]*?<\/annotation>/g, "").replace(/<[^>]*>/g, "");
  const headings = [...html.matchAll(/<h([1-6]) id="([^"]*)">([\s\S]*?)<\/h\1>/g)].map(([, level, id, inner]) => ({ level: Number(level), id, text: text(inner) }));
  return { title: headings[0]?.text ?? "bifdiag", sections: headings.filter(({ level }) => level === 2) };
}
