/** What goes wrong, what is slow, what is not there. */
import { expect, test } from "vitest";
import { data, go, load, open, picture, ready, serve } from "./open";

serve();

const PAPER = "A=2,1.1,1&r=0.94868,0,0.61623";

test.each([
  ["A=2,0,1&r=1,0,0", "A2 = 0"],
  ["A=2,cow,1&r=1,0,0", "cow"],
  ["A=2,1&r=1,0,0", "three numbers"],
  [`${PAPER}&h=3&l=x`, "x"],
  [`${PAPER}&h=3`, "l is missing"],
])("%s is told, and mended", async (hash, words) => {
  const page = await open(hash);
  expect(await page.getByTestId("error").textContent()).toContain(words);
  await go(page, PAPER);
  expect(await page.getByTestId("error").count()).toBe(0);
  expect(await page.getByTestId("region-row").count()).toBe(9);
  await page.close();
});

test("beside what is wrong with a point stands the body's diagram", async () => {
  const page = await open(`${PAPER}&h=1,000.8&l=3.25`);
  expect(await page.getByTestId("error").textContent()).toContain("1,000.8");
  expect(await page.getByTestId("region-row").count()).toBe(9);
  expect(await page.evaluate(() => location.hash)).toContain("h=1,000.8");
  expect([await page.getByTestId("input-h").getAttribute("aria-invalid"), await page.getByTestId("input-l").getAttribute("aria-invalid")]).toEqual(["true", null]);
  await page.close();
});

test("where there is no section, a sentence says why, and that is no error", async () => {
  for (const hash of ["A=2,1.5,1&r=0,0,0&h=0.6&l=1", `${PAPER}&h=-9&l=1`]) {
    const page = await open(hash);
    expect(await page.getByTestId("error").count()).toBe(0);
    expect(await page.getByTestId("crossing-count").textContent()).toBe("0");
    expect(await page.locator("[data-panel=section] .note").textContent()).toMatch(/section|forbidden/);
    await page.close();
  }
});

test.each([
  ["A=2,1.5,1&r=0,0,0", "Euler's case"],
  ["body=lagrange", "form circles"],
  ["A=5,1,1&r=1,0.2,0.1", "No physical body"],
  ["A=1,1,1&r=1,0,0", "on a principal axis"],
])("%s: a sentence tells what is special", async (hash, words) => {
  const page = await open(hash);
  await expect.poll(() => page.locator(".body-controls .note").textContent()).toContain(words);
  await page.close();
});

test("without a network the page opens again and goes on working, exports too", async () => {
  const page = await open(`${PAPER}&h=3.8&l=3.25`);
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
  await page.context().setOffline(true);
  await go(page, "body=kovalevskaya&h=2&l=1");
  expect(await data(page, "point-region", "region")).toBe("R2");
  await page.reload();
  await ready(page);
  expect(await data(page, "point-region", "region")).toBe("R2");
  for (const id of ["export-svg", "export-npz"]) {
    const [file] = await Promise.all([page.waitForEvent("download"), page.getByTestId(id).click()]);
    expect(await file.path()).not.toBeNull();
  }
  await page.close();
});

test("nothing is fetched from anywhere else", async () => {
  const page = await open("");
  const elsewhere = await page.evaluate(() => performance.getEntriesByType("resource").map(({ name }) => new URL(name)).filter(({ origin, protocol }) => protocol !== "data:" && origin !== location.origin).map(String));
  expect(elsewhere).toEqual([]);
  await page.close();
});

test("a new question while an old one runs wins", async () => {
  const page = await open(PAPER);
  await page.evaluate(() => {
    location.hash = "A=1,0.7,0.5&r=1,0,0&h=4&l=1.3&orbits=400&crossings=5000";
  });
  await page.waitForTimeout(300);
  await go(page, `${PAPER}&h=3.8&l=3.25`);
  expect(await data(page, "point-region", "region")).toBe("R5");
  expect(Number(await page.getByTestId("crossing-count").textContent())).toBe(12024);
  await page.close();
});

test("an address is answered although the page wrote its own in that moment", async () => {
  const page = await open(`${PAPER}&h=3.8&l=3.25`);
  await page.evaluate(() => {
    const own = location.hash;
    document.documentElement.dataset.ready = "false";
    location.hash = "body=kovalevskaya&h=2&l=1";
    history.replaceState(null, "", own);
  });
  await ready(page);
  expect([await data(page, "point-region", "region"), await page.evaluate(() => location.hash)]).toEqual(["R2", "#A=2,2,1&r=1,0,0&h=2&l=1"]);
  await page.close();
});

test("frames while a hand drags r", async () => {
  const page = await open("A=2,1.5,1.2&r=0.5,0.6,0.7&view=-1.2,6,0,4");
  const box = (await page.getByTestId("octant").boundingBox())!;
  const at = (turn: number) => [box.x + box.width * (0.5 + 0.2 * Math.cos(turn)), box.y + box.height * (0.5 + 0.2 * Math.sin(turn))] as const;
  const before = await picture(page, "diagram");
  await page.mouse.move(...at(0));
  await page.mouse.down();
  for (let k = 1; k <= 150; k++) {
    await page.mouse.move(...at(k / 20));
    await page.evaluate(() => new Promise(requestAnimationFrame));
  }
  const frames = (await page.evaluate(() => window.bifdiag.frames())).sort((a, b) => a - b);
  // The picture follows within the event, so that it is part of the same frame.
  const followed = await page.evaluate(([x, y]) => {
    const [octant, diagram] = ["octant", "diagram"].map((id) => document.querySelector<HTMLCanvasElement>(`[data-testid=${id}]`)!);
    const before = diagram!.toDataURL();
    octant!.dispatchEvent(new PointerEvent("pointermove", { pointerId: 1, pointerType: "mouse", clientX: x!, clientY: y! }));
    return before !== diagram!.toDataURL();
  }, at(3));
  expect(followed).toBe(true);
  // What is told of the way does not move the octant from under the hand.
  expect((await page.getByTestId("octant").boundingBox())!.y).toBe(box.y);
  await page.mouse.up();
  await ready(page);
  expect(await picture(page, "diagram")).not.toBe(before);
  const [median, late] = [frames[Math.floor(frames.length / 2)]!, frames[Math.floor(frames.length * 0.95)]!];
  console.log(`frames while dragging r: ${frames.length} drawn, median ${median.toFixed(1)} ms, 95 % within ${late.toFixed(1)} ms`);
  // Figures are printed, not asserted: a test must not depend on what else the machine does.
  expect(frames.length).toBeGreaterThan(10);
  await page.close();
});

test("over a slow line the page is there before its module, and the last body that was chosen meanwhile is drawn", async () => {
  let arrive = () => undefined as void;
  const held = new Promise<void>((release) => (arrive = release));
  const page = await load("", { serviceWorkers: "block" }, async (page) => {
    await page.addInitScript(() => new MutationObserver(() => (((window as { stages?: string[] }).stages ??= []).push(document.documentElement.dataset.ready ?? ""))).observe(document, { subtree: true, attributeFilter: ["data-ready"] }));
    await page.route(/bifdiag_web_bg-.*\.wasm$/, async (route) => (await held, route.continue()));
  });
  const names = page.getByTestId("presets");
  await names.waitFor();
  expect(await names.locator("option").count()).toBeGreaterThan(10);
  expect(await page.getByTestId("region-row").count()).toBe(0);
  await names.selectOption("kovalevskaya");
  await names.selectOption("lagrange");
  arrive();
  await ready(page);
  expect(await page.locator(".body-controls .note").textContent()).toContain("form circles");
  expect(await page.evaluate(() => location.hash)).toContain("A=3/2,1,1&r=1,0,0");
  const stages = await page.evaluate(() => (window as { stages?: string[] }).stages!);
  expect([stages.indexOf("moving") >= 0, stages.indexOf("moving") < stages.lastIndexOf("true")]).toEqual([true, true]);
  await page.close();
});

test("first paint, and what it loads", async () => {
  const page = await open("");
  const paint = await page.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0]?.startTime ?? Infinity);
  console.log(`first paint after ${paint.toFixed(0)} ms`);
  expect(paint).toBeLessThan(Infinity);
  await page.close();
});
