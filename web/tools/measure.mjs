// Prints the figures that docs/explorer.md states: `npm run measure`, on a machine as quiet as it gets, after `npm run build`
// and `cargo build --release`. CHROMIUM and BIFDIAG name other programs, as in the tests.
import { execFileSync, spawn } from "node:child_process";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import os from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { brotliCompressSync } from "node:zlib";
import { chromium } from "playwright-core";
import { preview } from "vite";
import init, * as guest from "../src/bindings/generated/bifdiag_web.js";

const web = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "..");
const program = process.env.BIFDIAG ?? path.join(process.env.CARGO_TARGET_DIR ?? path.join(web, "../target"), "release/bifdiag");
const ROUNDS = 5;
const BODIES = 1000;

const sorted = (list) => [...list].sort((a, b) => a - b);
const part = (list, share) => sorted(list)[Math.floor(share * (list.length - 1))];
const say = (what, value) => console.log(`${what.padEnd(62)} ${value}`);

say("machine", `${os.cpus()[0].model}, ${os.cpus().length} processors, load ${os.loadavg()[0].toFixed(1)}`);

// The same points of the same bodies, each with its atlas, in one thread and on one line of JSON: what differs is the machine code.
let seed = 7;
const next = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
const asked = Array.from({ length: BODIES }, () => {
  const [x, y, z] = [next() + 0.05, next() + 0.05, next() + 0.05];
  return { A: [y + z, z + x, x + y].map((a) => a.toFixed(4)), r: [next(), next(), next()].map((v) => (2 * v - 1).toFixed(4)), h: (3 * next()).toFixed(3), l: (2 * next()).toFixed(3) };
});
const batch = path.join(mkdtempSync(path.join(os.tmpdir(), "bifdiag-")), "points.jsonl");
const native = (lines) => {
  writeFileSync(batch, lines.map((line) => JSON.stringify(line)).join("\n"));
  const from = process.hrtime.bigint();
  execFileSync(program, ["classify", "--batch", batch, "--threads=1"], { maxBuffer: 1 << 28 });
  return Number(process.hrtime.bigint() - from) / 1e6;
};
await init({ module_or_path: readFileSync(path.join(web, "src/bindings/generated/bifdiag_web_bg.wasm")) });
const wasm = () => {
  const from = performance.now();
  for (const { A, r, h, l } of asked) guest.classify(`A=${A}&r=${r}`, h, l);
  return performance.now() - from;
};
const times = Array.from({ length: ROUNDS }, () => [native(asked) - native(asked.slice(0, 1)), wasm()].map((ms) => (1000 * ms) / BODIES));
const [here, there] = [0, 1].map((side) => Math.min(...times.map((pair) => pair[side])));
say("an atlas with a point of it, native", `${here.toFixed(0)} µs`);
say("an atlas with a point of it, WebAssembly", `${there.toFixed(0)} µs, ${(there / here).toFixed(2)} times native (goal 2)`);

// By the clock of the processor, which other work on the machine does not stop.
const section = new guest.Section("body=paper", "4.45", "3.25");
const starts = section.starts(64, 0);
const followed = Array.from({ length: ROUNDS }, () => {
  const from = process.cpuUsage();
  const count = section.follow(starts, 0, 2000).length / 13;
  return (1e6 * count) / process.cpuUsage(from).user;
});
say("crossings a second of the processor, best", `${Math.round(Math.max(...followed) / 1000)} k (goal 300 k)`);

const server = await preview({ root: web, preview: { port: 0, host: "127.0.0.1" }, logLevel: "error" });
const address = server.resolvedUrls.local[0];
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
async function open(hash, told = () => undefined) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, serviceWorkers: "block" });
  const page = await context.newPage();
  page.on("request", told);
  await page.goto(`${address}${hash}`);
  await page.waitForFunction(() => document.documentElement.dataset.ready === "true");
  return page;
}

const paints = [];
let files = new Set();
for (let round = 0; round < ROUNDS; round++) {
  files = new Set();
  const page = await open("", (request) => request.url().startsWith(address) && files.add(new URL(request.url()).pathname.slice(1) || "index.html"));
  paints.push(await page.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0].startTime));
  await page.context().close();
}
say("first paint, median", `${part(paints, 0.5).toFixed(0)} ms (goal 1500)`);
const sizes = [...files].map((file) => brotliCompressSync(readFileSync(path.join(web, "dist", file))).length);
say(`what it loads, ${files.size} files, brotli`, `${Math.round(sizes.reduce((sum, size) => sum + size, 0) / 1000)} kB (goal 700)`);

const rates = [];
for (let round = 0; round < ROUNDS; round++) {
  const page = await open("#A=2,1.1,1&r=0.94868,0,0.61623&h=4.45&l=3.25&orbits=64&crossings=2000");
  rates.push(await page.evaluate(() => window.bifdiag.rate()));
  await page.context().close();
}
say("crossings a second in one worker by its clock, median, best", `${[part(rates, 0.5), Math.max(...rates)].map((rate) => `${Math.round(rate / 1000)} k`).join(", ")} (goal 300 k)`);

// As `bifdiag explore` serves it, over a slow line: until the point is decided and the body turns, and until all verdicts are there.
const served = spawn(program, ["explore", "--no-open", "--page", path.join(web, "dist")]);
const own = await new Promise((resolve) => served.stdout.once("data", (line) => resolve(String(line).trim())));
const waits = { moving: [], true: [] };
let bytes = 0;
for (let round = 0; round < ROUNDS; round++) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, serviceWorkers: "block" });
  const page = await context.newPage();
  const devtools = await context.newCDPSession(page);
  await devtools.send("Network.enable");
  await devtools.send("Network.emulateNetworkConditions", { offline: false, latency: 40, downloadThroughput: 200_000, uploadThroughput: 100_000 });
  const from = performance.now();
  await page.goto(own);
  for (const stage of ["moving", "true"]) {
    await page.waitForFunction((stage) => [stage, "true"].includes(document.documentElement.dataset.ready), stage);
    waits[stage].push(performance.now() - from);
  }
  bytes = await page.evaluate(() => performance.getEntriesByType("resource").concat(performance.getEntriesByType("navigation")).reduce((sum, { transferSize }) => sum + transferSize, 0));
  await context.close();
}
served.kill();
const [moving, settled] = Object.values(waits).map((times) => `${part(times, 0.5).toFixed(0)} ms`);
say("over 1.6 Mbit/s, median: the body turns, all verdicts; bytes", `${moving} (goal 5000), ${settled}, ${Math.round(bytes / 1000)} kB`);

const frames = [];
const gaps = [];
for (let round = 0; round < ROUNDS; round++) {
  const page = await open("#A=2,1.5,1.2&r=0.5,0.6,0.7&view=-1.2,6,0,4");
  const box = await page.getByTestId("octant").boundingBox();
  const at = (turn) => [box.x + box.width * (0.5 + 0.2 * Math.cos(turn)), box.y + box.height * (0.5 + 0.2 * Math.sin(turn))];
  await page.mouse.move(...at(0));
  await page.mouse.down();
  await page.evaluate(() => {
    window.paints = [];
    const next = (time) => (window.paints.push(time), requestAnimationFrame(next));
    requestAnimationFrame(next);
  });
  for (let k = 1; k <= 150; k++) {
    await page.mouse.move(...at(k / 20));
    await page.evaluate(() => new Promise(requestAnimationFrame));
  }
  frames.push(...(await page.evaluate(() => window.bifdiag.frames())));
  const times = await page.evaluate(() => window.paints);
  gaps.push(...times.slice(1).map((time, i) => time - times[i]));
  await page.context().close();
}
say("between two frames of the browser meanwhile: median, 95 %", `${part(gaps, 0.5).toFixed(1)} ms, ${part(gaps, 0.95).toFixed(1)} ms (goals 17, 33)`);
say(`from the hand to the picture of r, ${frames.length} pictures: median, 95 %`, `${part(frames, 0.5).toFixed(1)} ms, ${part(frames, 0.95).toFixed(1)} ms (goals 16, 33)`);
await browser.close();
await server.close();
