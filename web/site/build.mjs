// Builds the site: `npm run site`, after `npm run build`. Every page comes from the repository; nothing is loaded from elsewhere.
//
// Classes are drawn by the program (`CLASSES=FOLDER` takes drawings that were made before). The Python reference and the manuscript
// are taken along if they have been built.
import { execFileSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import os from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { Files, commandOf, sizeOf } from "./files.mjs";
import { escaped, page } from "./frame.mjs";
import { front } from "./front.mjs";
import { outline, reader } from "./markdown.mjs";
import { FILES, GALLERY, GROUPS, MATHEMATICAL } from "./pages.mjs";

const web = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "..");
const root = path.join(web, "..");
const target = process.env.CARGO_TARGET_DIR ?? path.join(root, "target");
const out = path.join(web, "dist-site");

const write = (file, text) => {
  mkdirSync(path.dirname(path.join(out, file)), { recursive: true });
  writeFileSync(path.join(out, file), text);
};

/** Pictures get their size, and those of the gallery the commands that make them. */
function pictured(html, depth, gallery) {
  return html.replace(/<img ([^>]*?)src="([^"]*)"([^>]*)>/g, (whole, before, src, after) => {
    const file = path.join(out, src.replace(/^(\.\.\/)+/, depth ? "" : "../"));
    if (/^https?:/.test(src) || !existsSync(file)) return whole;
    const size = /width=/.test(before + after) ? undefined : sizeOf(file);
    const shown = `<img ${before}src="${src}"${after.replace(/\/$/, "")}${size ? ` width="${size[0]}" height="${size[1]}"` : ""} loading="lazy">`;
    if (!gallery) return shown;
    const command = commandOf(file);
    const lines = [...(command ? [command] : []), `cargo run --release --example figures -- --only ${path.basename(src, ".svg")}`];
    return `${shown}</p>\n<p class="command">${lines.map((line) => `<code>${escaped(line)}</code>`).join("<br>")}`;
  });
}

function pageOf(files, source, text, file, depth = 0) {
  const move = (link) => files.address(source, link, depth);
  const md = reader({ mathematical: MATHEMATICAL.has(source), move });
  const html = md.render(text).replace(/(<img [^>]*?src=")([^"]*)"/g, (whole, before, src) => (src.includes("files/") || /^(https?:|data:)/.test(src) || existsSync(path.join(out, path.dirname(file), src)) ? whole : `${before}${move(src)}"`));
  const { title, sections } = outline(html);
  write(file, page({ title: `${title} – bifdiag`, body: pictured(html, depth, source === GALLERY), file, depth, sections }));
  return title;
}

/** The catalogue: one page for each class, and one of all. */
function classes(files) {
  const folder = process.env.CLASSES ?? mkdtempSync(path.join(os.tmpdir(), "bifdiag-classes-"));
  if (!process.env.CLASSES) {
    const words = ["run", "--release", "--quiet", "--example", "classes", "--", "pages", "data/classes.json", folder];
    execFileSync("cargo", words, { cwd: root, stdio: "inherit" });
  }
  mkdirSync(path.join(out, "classes"), { recursive: true });
  for (const name of readdirSync(folder)) {
    if (name.endsWith(".svg")) cpSync(path.join(folder, name), path.join(out, "classes", name));
  }
  for (const name of readdirSync(folder).filter((name) => name.endsWith(".md"))) {
    const text = readFileSync(path.join(folder, name), "utf8").replace(/\]\(README\.md\)/g, "](../classes.html)");
    if (name === "README.md") {
      const inside = text.replace(/\]\((\w+)\.(md|svg)\)/g, (_, file, kind) => `](classes/${file}.${kind === "md" ? "html" : "svg"})`);
      catalogued(inside.replace("`docs/survey.md`", "[the survey](survey.html)"), "classes.html", 0);
    } else {
      catalogued(text.replace(/\]\((\w+)\.md\)/g, "]($1.html)"), `classes/${name.replace(/\.md$/, ".html")}`, 1);
    }
  }
}

function catalogued(text, file, depth) {
  const html = reader({ mathematical: false, move: (link) => link }).render(text);
  const shown = html.replace(/<img src="([^"]*)"/g, (whole, src) => {
    const size = sizeOf(path.join(out, path.dirname(file), src));
    return `${whole}${size ? ` width="${size[0]}" height="${size[1]}"` : ""} loading="lazy"`;
  });
  const { title, sections } = outline(shown);
  write(file, page({ title: `${title} – bifdiag`, body: shown, file, depth, sections }));
}

rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
const files = new Files(root, out, FILES);
const reference = path.join(target, "python/docs");
const manuscript = path.join(root, "paper/manuscript.pdf");
const has = { reference: existsSync(path.join(reference, "index.html")), manuscript: existsSync(manuscript) };

cpSync(path.join(web, "site/style.css"), path.join(out, "style.css"));
cpSync(path.join(web, "dist"), path.join(out, "explorer"), { recursive: true });
if (has.reference) cpSync(reference, path.join(out, "python"), { recursive: true });
if (has.manuscript) cpSync(manuscript, path.join(out, "manuscript.pdf"));

const titles = new Map();
for (const [source, file] of FILES) titles.set(source, pageOf(files, source, readFileSync(path.join(root, source), "utf8"), file));
const groups = GROUPS.map(([name, sources]) => {
  const list = sources.map((source) => `<li><a href="${FILES.get(source)}">${escaped(titles.get(source))}</a></li>`).join("\n");
  return `<section><h2 id="${name.toLowerCase().replaceAll(" ", "-")}">${name}</h2><ul>\n${list}\n</ul></section>`;
});
write("pages.html", page({ title: "All pages – bifdiag", body: `<h1>All pages</h1>\n<div class="columns">${groups.join("\n")}</div>`, file: "pages.html" }));
classes(files);
const description = "Bifurcation diagrams, topology and Poincaré sections of any heavy rigid body, computed exactly and live in the browser";
write("index.html", page({ title: "bifdiag", description, body: front(files, has), file: "index.html" }).replace('<main id="text">', '<main id="text" class="front">'));
console.log(`${out}: ${readdirSync(out).length} entries${has.reference ? "" : "; without the Python reference"}${has.manuscript ? "" : "; without the manuscript"}`);
