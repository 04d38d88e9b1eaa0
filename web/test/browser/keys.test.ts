/** Every key of every canvas, field and guide, and a voice. */
import { expect, test } from "vitest";
import type { Page } from "playwright-core";
import { bifdiag } from "../program";
import { data, go, open, picture, ready, serve } from "./open";

serve();

const PAPER = "A=2,1.1,1&r=0.94868,0,0.61623";
const POINT = `${PAPER}&h=3.8&l=3.25`;
const ARROWS = ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown"] as const;

const numbers = (page: Page, ...names: string[]): Promise<number[]> => Promise.all(names.map((name) => page.getByTestId(`input-${name}`).inputValue().then(Number)));
const crossings = (page: Page): Promise<number> => page.getByTestId("crossing-count").textContent().then(Number);

/** Presses a key on a panel, and waits until the address has followed it. */
async function press(page: Page, id: string, key: string): Promise<void> {
  const before = page.url();
  await page.getByTestId(id).focus();
  await page.keyboard.press(key);
  await expect.poll(() => page.url(), { message: `${id}: ${key}` }).not.toBe(before);
  await ready(page);
}

test.each(["", "&view=straight"])("on the diagram%s arrows move the point, with shift farther", async (view) => {
  const page = await open(POINT + view);
  const far: number[] = [];
  for (const shift of ["", "Shift+"]) {
    for (const [key, axis, sign] of [["ArrowLeft", 0, -1], ["ArrowRight", 0, 1], ["ArrowUp", 1, 1], ["ArrowDown", 1, -1]] as const) {
      const place = () => page.evaluate(([h, l]) => window.bifdiag.place(h!, l!)!, [...places]);
      let places = await numbers(page, "h", "l");
      const [x, y] = await place();
      await press(page, "diagram", shift + key);
      places = await numbers(page, "h", "l");
      const [u, v] = await place();
      // Upwards is up on the screen, where y falls.
      const moved = [u - x, y - v];
      expect(moved[axis]! * sign, shift + key).toBeGreaterThan(1);
      expect(Math.abs(moved[1 - axis]!), shift + key).toBeLessThan(1);
      if (key === "ArrowLeft") far.push(Math.abs(moved[0]!));
    }
  }
  expect(far[1]! / far[0]!).toBeGreaterThan(5);
  await page.close();
});

test("on the diagram + and − zoom about the point, 0 shows all, Escape removes the point", async () => {
  const page = await open(POINT);
  const view = () => page.evaluate(() => window.bifdiag.window()!);
  const width = async () => (await view()).h[1] - (await view()).h[0];
  const whole = await width();
  for (const [key, factor] of [["+", 0.7], ["=", 0.49], ["-", 0.7]] as const) {
    await press(page, "diagram", key);
    await expect.poll(width, { message: key }).toBeCloseTo(factor * whole, 3);
  }
  const { h, l } = await view();
  expect(h[0] < 3.8 && 3.8 < h[1] && l[0] < 3.25 && 3.25 < l[1]).toBe(true);
  await press(page, "diagram", "0");
  expect(page.url()).not.toContain("view=");
  await expect.poll(width).toBe(whole);
  await press(page, "diagram", "Escape");
  expect(page.url()).not.toContain("h=");
  await page.close();
});

test("Escape ends one thing: the large panel, then the tour, then the point", async () => {
  const page = await open(`${POINT}&present=diagram`);
  await press(page, "diagram", "Escape");
  expect(page.url().split("#")[1]).toBe(POINT);
  await go(page, `${POINT}&tour=4`);
  await press(page, "diagram", "Escape");
  expect(page.url()).not.toContain("tour=");
  expect(page.url()).toContain("h=");
  await press(page, "diagram", "Escape");
  expect(page.url()).not.toContain("h=");
  await page.close();
});

test("on the triangle and the octant arrows change the body, there and back", async () => {
  const page = await open(POINT);
  // In the triangle A1 is at the left, A2 at the right, A3 above; on the octant r turns.
  for (const [key, back, name, sign] of [["ArrowLeft", "ArrowRight", "A1", 1], ["ArrowRight", "ArrowLeft", "A2", 1], ["ArrowUp", "ArrowDown", "A3", 1], ["ArrowDown", "ArrowUp", "A3", -1]] as const) {
    const [before] = await numbers(page, name);
    await press(page, "triangle", key);
    const [after] = await numbers(page, name);
    expect((after! - before!) * sign, key).toBeGreaterThan(0);
    await press(page, "triangle", back);
    expect((await numbers(page, name))[0], back).toBeCloseTo(before!, 3);
  }
  for (const [key, back] of [["ArrowLeft", "ArrowRight"], ["ArrowUp", "ArrowDown"]] as const) {
    const before = await numbers(page, "r1", "r2", "r3");
    await press(page, "octant", key);
    const there = await numbers(page, "r1", "r2", "r3");
    expect(Math.hypot(...there), key).toBeCloseTo(Math.hypot(...before), 3);
    expect(there.join(), key).not.toBe(before.join());
    await press(page, "octant", back);
    (await numbers(page, "r1", "r2", "r3")).forEach((value, axis) => expect(Math.abs(value - before[axis]!), back).toBeLessThan(0.02));
  }
  await page.close();
});

test("on the map of bodies arrows change the body, with shift farther, and stop at its edge", async () => {
  const page = await open("A=1,0.8,0.6&r=1,0,0");
  const place = async () => {
    const [a, b, c] = await numbers(page, "A1", "A2", "A3");
    return [b! / a!, c! / a!] as const;
  };
  for (const [shift, far] of [["", 0.01], ["Shift+", 0.1]] as const) {
    for (const [key, axis, sign] of [["ArrowLeft", 0, -1], ["ArrowRight", 0, 1], ["ArrowUp", 1, 1], ["ArrowDown", 1, -1]] as const) {
      const before = await place();
      await press(page, "bodies-map", shift + key);
      const after = await place();
      expect(after[axis] - before[axis], shift + key).toBeCloseTo(far * sign, 3);
      expect(after[1 - axis], shift + key).toBeCloseTo(before[1 - axis]!, 3);
    }
  }
  await page.getByTestId("bodies-map").focus();
  for (let k = 0; k < 10; k++) await page.keyboard.press("Shift+ArrowDown");
  await ready(page);
  expect((await place())[1]).toBeGreaterThan(0);
  expect(await page.getByTestId("error").count()).toBe(0);
  await page.close();
});

/** Bodies of real parts: in kg m² their moments are far below a thousandth. */
test("hands move small and large bodies as they do those of size 1", async () => {
  const ratios = async (page: Page) => {
    const [a, b, c] = await numbers(page, "A1", "A2", "A3");
    return [b! / a!, c! / a!];
  };
  const moved: number[][] = [];
  for (const scale of ["e-5", "", "e5"]) {
    const page = await open(`A=2${scale},1.1${scale},1${scale}&r=0.9${scale},0.2${scale},0.6${scale}`);
    await press(page, "triangle", "ArrowUp");
    await press(page, "octant", "ArrowUp");
    const [r1, , r3] = await numbers(page, "r1", "r2", "r3");
    moved.push([...(await ratios(page)), r3! / r1!]);
    await page.getByLabel("plane").selectOption("moments");
    await press(page, "bodies-map", "ArrowRight");
    moved.at(-1)!.push(...(await ratios(page)));
    await press(page, "slider-r2", "ArrowRight");
    expect(await page.getByTestId("error").count()).toBe(0);
    await page.close();
  }
  for (const found of moved) found.forEach((value, i) => expect(value).toBeCloseTo(moved[1]![i]!, 2));
});

test.each(["sphere", "motion"])("on the %s arrows turn the view, there and back", async (id) => {
  const page = await open(POINT);
  await page.getByTestId("motion").focus();
  await page.keyboard.press(" ");
  await expect.poll(() => page.getByTestId("play").textContent()).toBe("▶");
  const still = async () => {
    let last = "";
    await expect.poll(async () => last === (last = await picture(page, id))).toBe(true);
    return last;
  };
  await page.getByTestId(id).focus();
  const seen = [await still()];
  for (const key of ARROWS) {
    await page.keyboard.press(key);
    await expect.poll(() => picture(page, id), { message: key }).not.toBe(seen.at(-1));
    seen.push(await still());
  }
  // Left, back, up, back: two views besides the first.
  expect(new Set(seen).size).toBeGreaterThan(2);
  await page.getByTestId("motion").focus();
  await page.keyboard.press(" ");
  await expect.poll(() => page.getByTestId("play").textContent()).toBe("❚❚");
  await page.close();
});

test("on the section arrows move a cross, and Enter starts an orbit there, with shift on the other half", async () => {
  const page = await open(POINT);
  await page.getByTestId("section").focus();
  const start = async (key: string) => {
    const before = await crossings(page);
    await page.keyboard.press(key);
    await expect.poll(() => crossings(page)).toBe(before + 501);
    const { theta, psi, sheet } = await page.evaluate(() => window.bifdiag.crossings());
    return [theta[before]!, psi[before]!, sheet[before]!];
  };
  const [ONE, TAU] = [Math.PI / 60, 2 * Math.PI];
  for (let k = 0; k < 17; k++) await page.keyboard.press("ArrowUp");
  expect(await start("Enter")).toEqual([expect.closeTo(13 * ONE, 9), expect.closeTo(TAU / 2, 9), 1]);
  for (const key of ["ArrowLeft", "ArrowLeft", "ArrowRight", "ArrowDown"]) await page.keyboard.press(key);
  expect(await start("Shift+Enter")).toEqual([expect.closeTo(14 * ONE, 9), expect.closeTo(29 * (TAU / 60), 9), -1]);
  await page.close();
});

test("fields and sliders step with keys, and a region's row is gone to with Enter", async () => {
  const page = await open(POINT);
  await press(page, "input-A2", "ArrowUp");
  expect(await page.getByTestId("input-A2").inputValue()).toBe("1.11");
  await press(page, "input-A2", "Shift+ArrowDown");
  expect(await page.getByTestId("input-A2").inputValue()).toBe("1.01");
  // A number that was typed and not taken yet is stepped from; h and l step as well.
  await page.getByTestId("input-h").fill("3,9");
  await press(page, "input-h", "ArrowDown");
  expect(page.url()).toContain("h=3.89&l=3.25");
  await press(page, "input-l", "Shift+ArrowUp");
  expect(page.url()).toContain("h=3.89&l=3.35");
  await go(page, POINT);
  await press(page, "slider-r2", "ArrowRight");
  expect(page.url()).toContain("r=0.94868,0.01,0.61623");
  expect(await page.getByTestId("input-r2").inputValue()).toBe("0.01");
  expect(await page.evaluate(() => window.bifdiag.atlas())).toBe(bifdiag("--A=2,1.1,1", "--r=0.94868,0.01,0.61623", "--json"));
  await press(page, "slider-r2", "ArrowLeft");
  expect(await page.getByTestId("input-r2").inputValue()).toBe("0");
  const row = page.getByTestId("region-row").nth(3);
  await row.focus();
  await page.keyboard.press("Enter");
  await expect.poll(() => data(page, "point-region", "region")).toBe(await row.getAttribute("data-region"));
  await page.close();
});

test("every canvas is reached with Tab, has a name, and shows that it has the focus", async () => {
  const page = await open(POINT);
  const seen = new Map<string, [name: string | null, outline: string]>();
  for (let k = 0; k < 150; k++) {
    await page.keyboard.press("Tab");
    const found = await page.evaluate(() => {
      const { activeElement: element } = document;
      return element instanceof HTMLCanvasElement ? [element.dataset.testid!, element.ariaLabel, getComputedStyle(element).outlineStyle] as const : null;
    });
    if (found) seen.set(found[0], [found[1], found[2]]);
  }
  expect([...seen.keys()].sort()).toEqual(["bodies-map", "diagram", "motion", "octant", "section", "sphere", "triangle"]);
  for (const [id, [name, outline]] of seen) expect([id, (name ?? "").length > 10, outline === "none"]).toEqual([id, true, false]);
  await page.close();
});

test("a voice says region and type", async () => {
  const page = await open(POINT);
  expect(await page.getByTestId("told").textContent()).toBe("Region R5. Section: sphere and torus. Accessible: disc and disc.");
  await press(page, "diagram", "Escape");
  expect(await page.getByTestId("told").textContent()).toBe("");
  await go(page, POINT);
  const line = page.locator(".components div").nth(1);
  await line.focus();
  await expect.poll(() => line.getAttribute("class")).toBe("lit");
  await page.close();
});
