// Prints what a visitor of the built site waits for: `node site/measure.mjs`, after `npm run site`. CHROMIUM names another program.
import path from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { preview } from "vite";

const web = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "..");
const ROUNDS = 5;

const server = await preview({ root: web, build: { outDir: "dist-site" }, preview: { port: 0, host: "127.0.0.1" }, logLevel: "error" });
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
const median = (list) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];

console.log("| page, window | requests | kB | first paint | largest paint | shift |\n| --- | ---: | ---: | ---: | ---: | ---: |");
for (const [file, width, height] of [["index.html", 1280, 720], ["index.html", 390, 844], ["mathematics.html", 390, 844], ["gallery.html", 390, 844], ["classes.html", 390, 844]]) {
  const rounds = [];
  for (let round = 0; round < ROUNDS; round++) {
    const context = await browser.newContext({ viewport: { width, height } });
    const page = await context.newPage();
    let requests = 0;
    page.on("response", () => (requests += 1));
    await page.addInitScript(() => {
      window.seen = { largest: 0, shift: 0 };
      new PerformanceObserver((list) => (window.seen.largest = list.getEntries().at(-1).startTime)).observe({ type: "largest-contentful-paint", buffered: true });
      new PerformanceObserver((list) => list.getEntries().forEach((entry) => (window.seen.shift += entry.value))).observe({ type: "layout-shift", buffered: true });
    });
    await page.goto(`${server.resolvedUrls.local[0]}${file}`, { waitUntil: "load" });
    await page.waitForTimeout(1500);
    const seen = await page.evaluate(() => {
      const parts = [...performance.getEntriesByType("navigation"), ...performance.getEntriesByType("resource")];
      const bytes = parts.reduce((sum, part) => sum + part.decodedBodySize, 0);
      return { ...window.seen, bytes, first: performance.getEntriesByName("first-contentful-paint")[0].startTime };
    });
    rounds.push({ ...seen, requests });
    await context.close();
  }
  const of = (name) => median(rounds.map((round) => round[name]));
  console.log(`| ${file.replace(".html", "")}, ${width}×${height} | ${of("requests")} | ${Math.round(of("bytes") / 1000)} | ${Math.round(of("first"))} ms | ${Math.round(of("largest"))} ms | ${of("shift").toFixed(3)} |`);
}
await browser.close();
await server.close();
