/** The built page in Debian's Chromium. */
import { chromium, type Browser, type BrowserContextOptions, type Page } from "playwright-core";
import { preview, type PreviewServer } from "vite";
import { afterAll, beforeAll, expect } from "vitest";

export const SIZE = { width: 1280, height: 720 };

let server: PreviewServer;
let browser: Browser;
export let address: string;

/** Serves and starts before the tests of a file, and ends after them. */
export function serve(): void {
  beforeAll(async () => {
    server = await preview({ preview: { port: 0, host: "127.0.0.1" }, logLevel: "error" });
    address = server.resolvedUrls!.local[0]!;
    browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
  });
  afterAll(async () => {
    await browser?.close();
    await server?.close();
  });
}

/** A page at a hash, ready; the console must have stayed free of errors when it is closed. */
export async function open(hash: string, options: BrowserContextOptions = {}): Promise<Page> {
  const page = await load(hash, options);
  await ready(page);
  return page;
}

/** A page that begins to load. */
export async function load(hash: string, options: BrowserContextOptions = {}, prepare: (page: Page) => Promise<void> = async () => undefined): Promise<Page> {
  const context = await browser.newContext({ viewport: SIZE, acceptDownloads: true, ...options });
  const page = await context.newPage();
  const errors: string[] = [];
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  page.on("pageerror", (error) => errors.push(String(error)));
  page.on("close", () => expect(errors).toEqual([]));
  await prepare(page);
  await page.goto(`${address}${hash ? `#${hash}` : ""}`);
  return page;
}

export const ready = (page: Page): Promise<unknown> => page.waitForFunction(() => document.documentElement.dataset.ready === "true", null, { timeout: 90_000 });

/** Sets the hash and waits for what it asks for. */
export async function go(page: Page, hash: string): Promise<void> {
  await page.evaluate((hash) => {
    if (location.hash === `#${hash}`) return;
    document.documentElement.dataset.ready = "false";
    location.hash = hash;
  }, hash);
  await ready(page);
}

export const data = (page: Page, id: string, name: string): Promise<string | null> => page.getByTestId(id).getAttribute(`data-${name}`);

/** How many different colours a canvas holds. */
export const colors = (page: Page, id: string): Promise<number> =>
  page.getByTestId(id).evaluate((element) => {
    const canvas = element as HTMLCanvasElement;
    const { data } = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
    return new Set(new Uint32Array(data.buffer)).size;
  });

/** A picture of a canvas as text, to see whether it changes. */
export const picture = (page: Page, id: string): Promise<string> => page.getByTestId(id).evaluate((element) => (element as HTMLCanvasElement).toDataURL());
