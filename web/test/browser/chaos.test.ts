/** The chaotic share over the diagram: coarse first, finer while one looks, and only of the body that is there. */
import { readFile } from "node:fs/promises";
import { expect, test } from "vitest";
import type { Page } from "playwright-core";
import { go, open, picture, ready, serve } from "./open";

serve();

const PAPER = "A=2,1.1,1&r=0.94868,0,0.61623&h=3.8&l=3.25";
const note = (page: Page) => page.getByTestId("chaos-note").textContent();
const shot = (page: Page, name: string) => process.env.PICTURES && page.screenshot({ path: `${process.env.PICTURES}/${name}.png` });
const cells = (page: Page) => page.evaluate(() => window.bifdiag.chaos().cells);
const share = (page: Page, h: number, l: number, region: number, component = 0) =>
  page.evaluate(([h, l, region, component]) => window.bifdiag.chaos().at(h!, l!, region!, component!) ?? null, [h, l, region, component] as const);
const WAIT = { timeout: 150_000 };

test("the layer is measured in cells that become finer; its share, error and open part are told", async () => {
  const page = await open(`${PAPER}&view=1,7,0,5`);
  expect(await page.getByTestId("chaos-note").isVisible()).toBe(false);
  const plane = await picture(page, "diagram");
  await page.getByTestId("chaos").click();
  expect(page.url()).toContain("layer=chaos");
  await expect.poll(() => note(page), WAIT).toMatch(/^16 × 16 cells, standard deviations up to 0\.\d\d, \d+\.\d % without a verdict/);
  expect(await picture(page, "diagram")).not.toBe(plane);
  await expect.poll(() => note(page), WAIT).toMatch(/32 × 32 cells: \d+ % done/);
  await shot(page, "chaos-coarse");
  // In R3 the paper's body is chaotic, in R2 at low energy regular.
  const [chaotic, regular] = [(await share(page, 3, 2.4, 2))!, (await share(page, 1.2, 2.2, 1))!];
  expect(chaotic.fraction).toBeGreaterThan(0.3);
  expect(regular.fraction).toBeLessThan(0.1);
  expect(chaotic.orbits).toBeGreaterThanOrEqual(8);
  await page.mouse.move(2, 2);
  const [px, py] = (await page.evaluate(() => window.bifdiag.place(3, 2.4)))!;
  const box = (await page.getByTestId("diagram").boundingBox())!;
  await page.mouse.move(box.x + 46 + px, box.y + 24 + py);
  await expect.poll(() => page.locator("[data-panel=diagram] .tip").textContent()).toMatch(/chaotic 0\.\d\d ± 0\.\d\d, open 0\.\d\d: \d+ orbits/);
  const [file] = await Promise.all([page.waitForEvent("download"), page.getByTestId("export-svg").click()]);
  expect(await readFile((await file.path())!, "utf8")).toContain("chaotic 0");
  await page.getByTestId("chaos").click();
  await expect.poll(() => picture(page, "diagram")).toBe(plane);
  await page.close();
}, 240_000);

test("another body, or another window, begins anew; a component is chosen", async () => {
  const page = await open(`${PAPER}&view=3,4.4,2.9,3.6&layer=chaos&component=1`);
  await expect.poll(() => cells(page), WAIT).toBe(16);
  await expect.poll(() => page.getByTestId("chaos-component").inputValue()).toBe("1");
  // Only R5 and what has several components has a second one.
  await expect.poll(() => share(page, 3.8, 3.25, 4, 1), WAIT).not.toBe(null);
  expect(await share(page, 3.05, 3.55, 1, 1)).toBe(null);
  await page.getByTestId("chaos-component").selectOption("0");
  expect(page.url()).not.toContain("component=");
  await shot(page, "chaos-component");
  await go(page, "A=2,2,1&r=1,0,0&h=2.5&l=1&view=0,4,0,2&layer=chaos");
  expect(await share(page, 3.8, 3.25, 4)).toBe(null);
  await expect.poll(() => note(page), WAIT).toMatch(/^16 × 16 cells.*32 × 32 cells/);
  // Kovalevskaya's top is integrable: no orbit of it is chaotic.
  const found = await page.evaluate(() => Array.from({ length: 100 }, (_, k) => [0, 1, 2, 3].map((region) => window.bifdiag.chaos().at(0.2 + (k % 10) * 0.38, 0.1 + Math.floor(k / 10) * 0.19, region, 0)?.fraction ?? 0)).flat());
  expect(Math.max(...found)).toBe(0);
  await page.close();
}, 300_000);

test("over the straightened plane, on a phone, in the dark", async () => {
  const page = await open(`${PAPER}&view=straight&layer=chaos&theme=dark`, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
  await expect.poll(() => cells(page), WAIT).toBe(16);
  await expect.poll(() => note(page), WAIT).toMatch(/32 × 32 cells: \d+ % done/);
  await shot(page, "chaos-phone");
  // Dragging the body ends the work at once.
  await page.getByTestId("slider-r2").focus();
  await page.keyboard.press("ArrowRight");
  await ready(page);
  await expect.poll(() => page.evaluate(() => window.bifdiag.chaos().running)).toBe(true);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  await page.close();
}, 240_000);
