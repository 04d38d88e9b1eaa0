/** The straightened diagram under a hand: true numbers, the same point, link, keys, files, lecture. */
import { readFile } from "node:fs/promises";
import { expect, test } from "vitest";
import type { Page } from "playwright-core";
import { bifdiag } from "../program";
import { colors, data, go, open, picture, ready, serve } from "./open";

serve();

const PAPER = "A=2,1.1,1&r=0.94868,0,0.61623";
const STRAIGHT = `${PAPER}&h=3.8&l=3.25&view=straight`;
/** Where the frame begins in the panel. */
const [LEFT, TOP] = [46, 24];

const box = async (page: Page) => (await page.getByTestId("diagram").boundingBox())!;
/** Where a point is on the screen. */
async function spot(page: Page, h: number, l: number): Promise<[number, number]> {
  const { x, y } = await box(page);
  const [px, py] = (await page.evaluate(([h, l]) => window.bifdiag.place(h!, l!), [h, l]))!;
  return [x + LEFT + px, y + TOP + py];
}
/** How far down the frame it is: more lines below make the panel lower. */
const share = async (page: Page, at: number) => (at - (await box(page)).y - TOP) / ((await box(page)).height - 60);
const point = async (page: Page) => [Number(await page.getByTestId("input-h").inputValue()), Number(await page.getByTestId("input-l").inputValue())] as const;
const shot = (page: Page, name: string) => process.env.PICTURES && page.screenshot({ path: `${process.env.PICTURES}/${name}.png` });

test("a switch straightens the plane, the address has it, and another press ends it", async () => {
  const page = await open(`${PAPER}&h=3.8&l=3.25`);
  const plane = await picture(page, "diagram");
  await page.getByTestId("straight").click();
  await expect.poll(() => page.evaluate(() => window.bifdiag.straight() !== null)).toBe(true);
  expect(page.url()).toContain("view=straight");
  expect(await page.getByTestId("command-line").textContent()).toContain("--view=straight");
  expect(await colors(page, "diagram")).toBeGreaterThan(20);
  expect(await data(page, "point-region", "region")).toBe("R5");
  await shot(page, "straight");
  await page.getByTestId("straight").click();
  await expect.poll(() => picture(page, "diagram")).toBe(plane);
  expect(page.url()).not.toContain("view=");
  await page.close();
});

test("each region can be clicked where it is seen, and has the command line's answer there", async () => {
  const page = await open(STRAIGHT);
  // The samples of all nine regions are seen, and in each a place somewhat beside is clicked.
  const { regions } = JSON.parse(bifdiag("--body=paper", "--json")) as { regions: { id: string; sample: { h: number; l: number } }[] };
  expect(regions.length).toBe(9);
  for (const { id, sample } of regions) {
    const [x, y] = await spot(page, sample.h, sample.l);
    const up = await share(page, y);
    const before = page.url();
    await page.mouse.click(x + 1, y);
    await page.waitForFunction((before) => location.href !== before, before);
    await ready(page);
    expect(await data(page, "point-region", "region"), id).toBe(id);
    const now = await spot(page, ...(await point(page)));
    expect([now[0] - x - 1, (await share(page, now[1])) - up], id).toEqual([expect.closeTo(0, -0.3), expect.closeTo(0, 1.7)]);
  }
  await page.close();
});

test("what is told beside the pointer is true: energy, momentum, region, curve", async () => {
  const page = await open(STRAIGHT);
  await page.mouse.move(...(await spot(page, 3.8, 3.25)));
  const tip = page.locator("[data-panel=diagram] .tip");
  await expect.poll(() => tip.textContent()).toMatch(/h = 3\.\d+, l = 3\.2/);
  expect(await tip.textContent()).toContain("R5: P = S² + T²");
  const lowest = (JSON.parse(bifdiag("critical", "--body=paper", "--l=3.25", "--json")) as { critical: { h: number; branch: string }[] }).critical.reduce((low, one) => (one.h < low.h ? one : low));
  const [x, y] = await spot(page, lowest.h, 3.25);
  await page.mouse.move(x, y - 2);
  await expect.poll(() => tip.textContent()).toContain(`from ${lowest.branch}`);
  await expect.poll(() => tip.textContent()).toContain("steady rotation");
  await page.close();
});

test("dragging the point tells each curve that it goes over; keys move it by pixels", async () => {
  const page = await open(`${PAPER}&h=3.2&l=2.4&view=straight`);
  await page.mouse.move(...(await spot(page, 3.2, 2.4)));
  await page.mouse.down();
  await page.mouse.move(...(await spot(page, 2.25, 2.4)), { steps: 4 });
  await expect.poll(() => page.getByTestId("surgery").textContent()).toContain("R2 → R5 across G1.2");
  await page.mouse.up();
  await ready(page);
  expect(await data(page, "point-region", "region")).toBe("R5");
  const [h, l] = await point(page);
  const [x, y] = await spot(page, h, l);
  await page.getByTestId("diagram").focus();
  await page.keyboard.press("ArrowUp");
  await page.waitForTimeout(400);
  await ready(page);
  const [higher, same] = await point(page);
  expect([higher > h, same]).toEqual([true, l]);
  await page.keyboard.press("ArrowRight");
  await page.waitForTimeout(400);
  await ready(page);
  const [px, py] = await spot(page, ...(await point(page)));
  expect([px - x, py - y]).toEqual([expect.closeTo(2, -0.3), expect.closeTo(-2, -0.3)]);
  // There is nothing to zoom, and the wheel is the page's.
  await page.keyboard.press("+");
  expect(page.url()).toContain("view=straight");
  await page.close();
});

test("the plane follows the body under the hand, and is fitted anew when that rests", async () => {
  const page = await open(`${PAPER}&view=straight&h=3.8&l=3.25`);
  const octant = (await page.getByTestId("octant").boundingBox())!;
  const [x, y] = [octant.x + octant.width / 2, octant.y + octant.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  const before = await picture(page, "diagram");
  for (let k = 1; k <= 6; k++) {
    await page.mouse.move(x + 2 * k, y - 3 * k);
    await page.evaluate(() => new Promise(requestAnimationFrame));
  }
  await expect.poll(() => picture(page, "diagram")).not.toBe(before);
  await page.mouse.up();
  await ready(page);
  const body = page.url().match(/#A=([^&]*)&r=([^&]*)/)!;
  expect(await page.evaluate(() => window.bifdiag.atlas())).toBe(bifdiag(`--A=${body[1]}`, `--r=${body[2]}`, "--json"));
  const end = () => page.evaluate(() => window.bifdiag.straight()!.columns.length);
  expect(await end()).toBeGreaterThan(1000);
  await page.close();
});

test("as SVG, for a lecture, in the dark, alone and beside another", async () => {
  const page = await open(`${STRAIGHT}&theme=dark`);
  const [file] = await Promise.all([page.waitForEvent("download"), page.getByTestId("export-svg").click()]);
  const svg = await readFile((await file.path())!, "utf8");
  for (const text of ["energy h at l = 0", "momentum l", "R5"]) expect(svg).toContain(text);
  await page.getByTestId("present-diagram").click();
  await page.waitForTimeout(300);
  // A press is where it is seen, though the panel is magnified.
  const { x, y, width } = await box(page);
  const scale = width / (await page.getByTestId("diagram").evaluate((canvas) => canvas.clientWidth));
  const [px, py] = (await page.evaluate(() => window.bifdiag.place(6, 2)))!;
  await page.mouse.click(x + scale * (LEFT + px), y + scale * (TOP + py));
  await ready(page);
  const [h, l] = await point(page);
  expect([h, l]).toEqual([expect.closeTo(6, 0), expect.closeTo(2, 1)]);
  await shot(page, "straight-lecture");
  await page.keyboard.press("Escape");
  await go(page, `A=2,2,1&r=1,0,0&h=2.5&l=1&view=straight&beside=2,1.1,1,0.94868,0,0.61623`);
  const frame = async () => (await (await page.getByTestId("twin").elementHandle())!.contentFrame())!.evaluate(() => location.hash);
  await expect.poll(frame).toContain("view=straight");
  await page.close();
  const alone = await open(`${STRAIGHT}&embed=diagram`, { viewport: { width: 600, height: 420 } });
  expect(await colors(alone, "diagram")).toBeGreaterThan(20);
  await alone.close();
});

test("a phone: a tap chooses, a finger that moves up scrolls", async () => {
  const page = await open(STRAIGHT, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
  await shot(page, "straight-phone");
  await page.touchscreen.tap(...(await spot(page, 6, 1.5)));
  await page.waitForFunction(() => !location.hash.includes("h=3.8&"));
  await ready(page);
  const [h, l] = await point(page);
  expect([h, l]).toEqual([expect.closeTo(6, -0.5), expect.closeTo(1.5, 0.5)]);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  await page.close();
});
