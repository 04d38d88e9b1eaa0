// What all pages have around their text.
import { NAVIGATION } from "./pages.mjs";

export const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");

const ICON = "data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 16 16'%3E%3Cellipse cx='8' cy='8' rx='7' ry='4.5' fill='%231250a8'/%3E%3Ccircle cx='11' cy='7' r='1.6' fill='white'/%3E%3C/svg%3E";

/** A whole page; `depth`: folders above it. */
export function page({ title, description, body, file, depth = 0, sections = [] }) {
  const up = "../".repeat(depth);
  const links = NAVIGATION.map(([name, to]) => `<a href="${up}${to}"${to === file ? ' aria-current="page"' : ""}>${name}</a>`).join("\n");
  const contents = sections.map(({ id, text }) => `<li><a href="#${id}">${escaped(text)}</a></li>`).join("\n");
  const aside = sections.length > 3 ? `<details class="contents"><summary>On this page</summary><ul>${contents}</ul></details>\n` : "";
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="description" content="${escaped(description ?? title)}">
<title>${escaped(title)}</title>
<link rel="icon" href="${ICON}">
<link rel="stylesheet" href="${up}style.css">
</head>
<body>
<a class="skip" href="#text">To the text</a>
<header><a class="name" href="${up}index.html">bifdiag</a><nav aria-label="Site">
${links}
</nav></header>
<main id="text">
${aside}${body}
</main>
</body>
</html>
`;
}
