/** The built site: every link leads somewhere, formulas are set, and a phone shows it. Needs `npm run site`. */
import { existsSync, readFileSync, readdirSync, statSync } from "node:fs";
import path from "node:path";
import { chromium, type Browser } from "playwright-core";
import { preview, type PreviewServer } from "vite";
import { afterAll, beforeAll, expect, test } from "vitest";

const SITE = path.resolve(import.meta.dirname, "../../dist-site");
/** Parts of the site that others make. */
const GUESTS = ["explorer", "python", "files"];

const pages = (readdirSync(SITE, { recursive: true }) as string[]).filter((file) => file.endsWith(".html") && !GUESTS.includes(file.split("/")[0]!));
const read = (file: string): string => readFileSync(path.join(SITE, file), "utf8");
const ids = new Map<string, Set<string>>();
const idsOf = (file: string): Set<string> => {
  const known = ids.get(file) ?? new Set([...read(file).matchAll(/ id="([^"]*)"/g)].map((match) => match[1]!));
  ids.set(file, known);
  return known;
};

test("each class of bodies that exist has a page", () => {
  const { classes } = JSON.parse(readFileSync(path.resolve(SITE, "../../data/classes.json"), "utf8")) as { classes: { name: string; physical: boolean }[] };
  for (const { name } of classes.filter(({ physical }) => physical)) expect(pages, name).toContain(`classes/${name}.html`);
});

test("every link and picture of every page leads somewhere", () => {
  const broken: string[] = [];
  for (const page of pages) {
    for (const [, , address] of read(page).matchAll(/ (href|src)="([^"]*)"/g)) {
      if (/^(https?:|mailto:|data:)/.test(address!)) continue;
      const [file, anchor] = address!.split("#") as [string, string?];
      const target = path.posix.normalize(path.posix.join(path.posix.dirname(page), file || path.posix.basename(page)));
      const place = path.join(SITE, decodeURI(target));
      if (!existsSync(place) || !statSync(place).isFile()) broken.push(`${page}: ${address}`);
      else if (anchor && !GUESTS.includes(target.split("/")[0]!) && !idsOf(target).has(decodeURI(anchor))) broken.push(`${page}: no ${address}`);
    }
  }
  expect(broken).toEqual([]);
});

test("no address of another host is fetched, and none is a place holder", () => {
  for (const page of pages) {
    expect(read(page), page).not.toMatch(/<(script|link|img|iframe)[^>]*(src|href)="https?:/);
    expect(read(page), page).not.toMatch(/href="https?:\/\/[^"]*(example\.(com|org)|localhost)/);
  }
});

test("pictures have a text and a size", () => {
  for (const page of pages) {
    for (const [picture] of read(page).matchAll(/<img [^>]*>/g)) {
      expect(picture, page).toMatch(/ alt="[^"]+"/);
      expect(picture, page).toMatch(/ width="/);
    }
  }
});

test("formulas are set, with their alphabets", () => {
  for (const page of ["mathematics.html", "algorithms.html"]) {
    const text = read(page).replace(/<annotation[\s\S]*?<\/annotation>/g, "").replace(/<code>[\s\S]*?<\/code>/g, "");
    expect(text.split("<math").length, page).toBeGreaterThan(1000);
    expect(text, page).not.toContain("$");
    expect(text, page).not.toContain("\\");
  }
  expect(read("mathematics.html")).toMatch(/𝐥[\s\S]*𝒱[\s\S]*ℝ/);
});

let server: PreviewServer;
let browser: Browser;
beforeAll(async () => {
  server = await preview({ build: { outDir: "dist-site" }, preview: { port: 0, host: "127.0.0.1" }, logLevel: "error" });
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
});
afterAll(async () => {
  await browser?.close();
  await server?.close();
});

test("a phone shows every kind of page without moving it sideways", async () => {
  const phone = await browser.newPage({ viewport: { width: 390, height: 844 } });
  for (const page of ["index.html", "mathematics.html", "algorithms.html", "gallery.html", "formats.html", "classes.html", "classes/01036ac4a504.html", "pages.html", "tutorial.html"]) {
    await phone.goto(`${server.resolvedUrls!.local[0]}${page}`);
    expect(await phone.evaluate(() => document.documentElement.scrollWidth), page).toBeLessThanOrEqual(390);
  }
  await phone.close();
});

test("the front page has the explorer above the fold, and it runs", async () => {
  const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
  await page.goto(server.resolvedUrls!.local[0]!);
  const live = page.locator("iframe.live");
  expect((await live.boundingBox())!.y).toBeLessThan(300);
  const frame = page.frameLocator("iframe.live");
  await frame.getByTestId("diagram").waitFor({ timeout: 90_000 });
  await frame.getByTestId("region-row").first().waitFor({ timeout: 90_000 });
  await page.close();
});
