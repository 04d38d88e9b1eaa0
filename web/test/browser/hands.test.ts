/** Fingers, keys, voices: a phone, the keyboard, the address and its history. */
import { expect, test } from "vitest";
import type { Page } from "playwright-core";
import { STORY } from "../../src/guide/scenes";
import words from "../../src/texts/en/guide";
import { data, open, picture, ready, serve } from "./open";

serve();

const PAPER = "A=2,1.1,1&r=0.94868,0,0.61623";
const POINT = `${PAPER}&h=3.8&l=3.25`;
const PHONES = [{ width: 390, height: 844 }, { width: 360, height: 640 }];
const phone = (viewport: { width: number; height: number }) => ({ viewport, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });

/** A finger: down, along places, up. */
async function swipe(page: Page, places: [number, number][], hold = 0): Promise<void> {
  const devtools = await page.context().newCDPSession(page);
  const send = (type: "touchStart" | "touchMove" | "touchEnd", place?: [number, number]) => devtools.send("Input.dispatchTouchEvent", { type, touchPoints: place ? [{ x: place[0], y: place[1] }] : [] });
  await send("touchStart", places[0]!);
  if (hold > 0) await page.waitForTimeout(hold);
  for (const place of places.slice(1)) await send("touchMove", place);
  await send("touchEnd");
}

const upwards = (x: number, y: number, far: number): [number, number][] => Array.from({ length: 11 }, (_, k) => [x, y - (far * k) / 10]);
const scrolled = (page: Page) => page.evaluate(() => scrollY);
const middle = async (page: Page, id: string) => {
  const box = (await page.getByTestId(id).boundingBox())!;
  return [box.x + box.width / 2, box.y + box.height / 2, box.width, box.height] as const;
};

test.each(PHONES)("a phone of $width × $height: swipes scroll over every canvas, and change nothing", async (viewport) => {
  const page = await open(POINT, phone(viewport));
  const before = page.url();
  for (const id of ["diagram", "sphere", "motion", "section", "triangle", "octant"]) {
    await page.getByTestId(id).evaluate((element) => element.scrollIntoView({ block: "center" }));
    const [from, [x, y]] = [await scrolled(page), await middle(page, id)];
    await swipe(page, upwards(x + 30, y + 60, 200));
    await expect.poll(() => scrolled(page), { message: id }).toBeGreaterThan(from + 100);
  }
  expect(page.url()).toBe(before);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(viewport.width);
  await page.close();
});

test("a phone: a tap chooses a point, a long press drags it, and so does its handle", async () => {
  const page = await open(POINT, phone(PHONES[0]!));
  const [x, y, width, height] = await middle(page, "diagram");
  await page.touchscreen.tap(x + 0.2 * width, y + 0.2 * height);
  await ready(page);
  expect(await data(page, "point-region", "region")).toBe("R4");
  const tapped = page.url();
  await swipe(page, upwards(x, y, 120), 600);
  await page.waitForFunction((before) => location.href !== before, tapped);
  await ready(page);
  expect(await scrolled(page)).toBe(0);
  const pressed = page.url();
  const at = async (name: string) => Number(await page.getByTestId(`input-${name}`).inputValue());
  const l = await at("l");
  // The finger of before lifted where the point is now: it goes on from there without a pause.
  await swipe(page, upwards(x, y - 120, 60));
  await page.waitForFunction((before) => location.href !== before, pressed);
  await ready(page);
  expect(await at("l")).toBeGreaterThan(l);
  expect(await scrolled(page)).toBe(0);
  await page.close();
});

test("a phone: targets are 44 pixels high, buttons as wide, and the bar leads to each panel", async () => {
  const page = await open(POINT, phone(PHONES[0]!));
  const small = await page.evaluate(() => [...document.querySelectorAll("button, select, input, summary, tbody tr")].filter((element) => element.getClientRects().length > 0 && (element as HTMLInputElement).type !== "file" && (element.getBoundingClientRect().height < 44 || (element instanceof HTMLButtonElement && element.getBoundingClientRect().width < 44))).map((element) => element.outerHTML.slice(0, 80)));
  expect(small).toEqual([]);
  for (const [name, id] of [["Section", "section"], ["Body", "triangle"], ["Motion", "motion"], ["Diagram", "diagram"]]) {
    await page.getByTestId("stack-bar").getByRole("button", { name: name! }).click();
    await expect.poll(async () => (await page.getByTestId(id!).boundingBox())!.y, { message: name! }).toBeLessThan(420);
  }
  await page.close();
});

test("a phone: the line of a component lights it when it is tapped, and the head has no button alone in a row", async () => {
  const page = await open(POINT, phone(PHONES[0]!));
  const line = page.locator(".components div").first();
  await line.tap();
  await expect.poll(() => line.getAttribute("class")).toBe("lit");
  await page.getByTestId("input-h").tap();
  await expect.poll(() => line.getAttribute("class")).toBe("");
  const rows = await page.locator(".head button, .head select").evaluateAll((list) => list.map((element) => element.getBoundingClientRect().y));
  for (const row of rows) expect(rows.filter((other) => other === row).length).toBeGreaterThan(1);
  await page.close();
});

test("a phone: a large panel is all to be seen, and its button stands at the right also below others", async () => {
  const page = await open(`${POINT}&present=section`, phone(PHONES[0]!));
  expect(await page.getByTestId("stack-bar").isVisible()).toBe(false);
  const { y, height } = (await page.locator(".reason").boundingBox())!;
  expect(y + height).toBeLessThanOrEqual(844);
  await page.goto(`${page.url().split(/[?#]/)[0]}?lang=de#${POINT}`);
  await page.setViewportSize(PHONES[1]!);
  await ready(page);
  const large = (await page.getByTestId("present-diagram").boundingBox())!;
  expect(large.x + large.width).toBeGreaterThan(330);
  await page.close();
});

test("a phone: the bar shows one panel as the present one, also where two meet", async () => {
  const page = await open(POINT, phone(PHONES[0]!));
  await page.locator("[data-panel=motion]").evaluate((panel) => scrollBy({ top: panel.getBoundingClientRect().top - 0.425 * innerHeight, behavior: "instant" }));
  await expect.poll(() => page.locator(".stack-bar [aria-pressed=true]").allTextContents()).toEqual(["U"]);
  await page.locator("[data-panel=motion]").evaluate((panel) => scrollBy({ top: panel.getBoundingClientRect().top - 0.3 * innerHeight, behavior: "instant" }));
  await expect.poll(() => page.locator(".stack-bar [aria-pressed=true]").allTextContents()).toEqual(["Motion"]);
  await page.close();
});

test("the first view moves by itself, and its story ends at a touch", async () => {
  const page = await open("");
  expect(await data(page, "point-region", "region")).toBe("R5");
  const before = await picture(page, "motion");
  await expect.poll(() => picture(page, "motion")).not.toBe(before);
  await expect.poll(() => page.getByTestId("story").isVisible(), { timeout: 15_000 }).toBe(true);
  await expect.poll(() => page.getByTestId("story").textContent()).toContain(words.story[0]!);
  await page.keyboard.press("Shift");
  expect(await page.getByTestId("story").isVisible()).toBe(false);
  await page.close();
});

test("the story shows what it says", async () => {
  const page = await open(POINT);
  await page.getByTestId("play-story").click();
  const regions: (string | null)[] = [];
  for (const [i, { point, r }] of STORY.entries()) {
    await expect.poll(() => page.getByTestId("story").textContent(), { timeout: 30_000 }).toContain(words.story[i]!);
    // The hand has let go towards the end of a scene.
    await page.waitForTimeout(point || r ? 7500 : 2500);
    await ready(page);
    regions.push(await data(page, "point-signature", "signature"));
  }
  expect([regions[0], regions[4]]).toEqual(["S2+T2", "M2"]);
  await expect.poll(() => page.getByTestId("story").isVisible(), { timeout: 15_000 }).toBe(false);
  await ready(page);
  expect(page.url()).toContain("A=2,2,1&r=1,0,0&h=2&l=1");
  await page.close();
}, 180_000);

test("where no point is given, the page chooses one that has a section", async () => {
  for (const hash of ["body=kovalevskaya", "body=lagrange", "A=3,2.2,1.1&r=0.3,0.2,0.9", `${PAPER}&embed=section`]) {
    const page = await open(hash);
    expect(await data(page, "point-status", "status"), hash).toBe("regular");
    expect(Number(await page.getByTestId("crossing-count").textContent()), hash).toBeGreaterThan(100);
    await page.close();
  }
});

test("axes hold while the body is dragged, ease to the new view, and the old curves stay for a second", async () => {
  const page = await open(PAPER);
  const axes = () => page.evaluate(() => window.bifdiag.window());
  const [x, y] = await middle(page, "octant");
  const before = await axes();
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 1; k <= 6; k++) {
    await page.mouse.move(x + 2 * k, y - 3 * k);
    await page.evaluate(() => new Promise(requestAnimationFrame));
    expect(await axes()).toEqual(before);
  }
  expect(await page.evaluate(() => window.bifdiag.shadow())).toBe(true);
  await page.mouse.up();
  await ready(page);
  expect(await axes()).not.toEqual(before);
  expect(await axes()).toEqual(await page.evaluate(() => window.bifdiag.suited()));
  await expect.poll(() => page.evaluate(() => window.bifdiag.shadow())).toBe(false);
  await page.close();
});

test("the diagram keeps its size while the point is dragged through all regions", async () => {
  for (const viewport of [{ width: 1280, height: 720 }, { width: 1440, height: 900 }]) {
    const page = await open(POINT, { viewport });
    const size = () => page.getByTestId("diagram").evaluate((element) => [element.clientWidth, element.clientHeight]);
    const before = await size();
    const [x, y, width] = await middle(page, "diagram");
    const seen = new Set<string>();
    await page.mouse.move(x - 0.38 * width, y + 0.2 * width);
    await page.mouse.down();
    for (let k = 0; k <= 60; k++) {
      // Through the narrow regions, and over the curve below which there is no motion.
      await page.mouse.move(x - 0.38 * width + (0.8 * width * k) / 60, y + (0.2 - 0.65 * (k / 60) ** 0.6) * width);
      await page.evaluate(() => new Promise(requestAnimationFrame));
      seen.add(`${await data(page, "point-region", "region")} ${(await page.getByTestId("surgery").textContent())!.length > 0}`);
      expect(await size()).toEqual(before);
    }
    await page.mouse.up();
    await ready(page);
    expect(await size()).toEqual(before);
    expect(seen.size).toBeGreaterThan(4);
    await page.close();
  }
});

test("while the body is dragged U has no edge and no marks of the body before", async () => {
  const page = await open(POINT);
  const black = () => page.getByTestId("sphere").evaluate((element) => {
    const { width, height } = element as HTMLCanvasElement;
    return new Uint32Array((element as HTMLCanvasElement).getContext("2d")!.getImageData(0, 0, width, height).data.buffer).filter((pixel) => pixel === 0xff1d1610).length;
  });
  const before = await black();
  expect(before).toBeGreaterThan(100);
  const [x, y] = await middle(page, "octant");
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 4, y - 6);
  await expect.poll(black).toBeLessThan(before / 3);
  await page.mouse.up();
  await ready(page);
  await expect.poll(black).toBeGreaterThan(100);
  await page.close();
});

test("numbers as people type them are read; what is none is marked, told and kept out of the address", async () => {
  const page = await open(POINT);
  const type = async (id: string, text: string) => {
    await page.getByTestId(id).fill(text);
    await page.getByTestId(id).press("Enter");
  };
  await type("input-h", "3,9");
  await page.waitForFunction(() => location.hash.includes("h=3.9&"));
  await type("input-r3", "−0.6");
  await page.waitForFunction(() => location.hash.includes("r=0.94868,0,-0.6&"));
  await ready(page);
  const good = page.url();
  await type("input-A1", "two");
  expect(await page.getByTestId("input-A1").getAttribute("aria-invalid")).toBe("true");
  expect(page.url()).toBe(good);
  await type("input-A1", "0");
  await expect.poll(() => page.getByTestId("error").textContent()).toContain("A1 = 0");
  expect(await page.getByTestId("input-A1").getAttribute("aria-invalid")).toBe("true");
  expect(page.url()).toBe(good);
  await type("input-A1", "2");
  await ready(page);
  expect(await page.getByTestId("input-A1").getAttribute("aria-invalid")).toBe(null);
  expect(await page.getByTestId("error").count()).toBe(0);
  await page.close();
});

test("an address takes numbers as people type them, and has them as they are read", async () => {
  for (const [hash, read] of [[`${PAPER}&h=3,8&l=3,25`, POINT], [`A=2,1.1,1&r=0.94868,0,−0.61623&h=3.8&l=–3,25`, "A=2,1.1,1&r=0.94868,0,-0.61623&h=3.8&l=-3.25"]] as const) {
    const page = await open(hash);
    expect(await page.getByTestId("error").count()).toBe(0);
    expect(await data(page, "point-region", "region")).toBe("R5");
    expect(await page.evaluate(() => location.hash)).toBe(`#${read}`);
    await page.close();
  }
});

test("unknown keys of the address are told", async () => {
  const page = await open(`${POINT}&colour=verdict`);
  expect(await page.getByTestId("notice").textContent()).toContain("colour");
  await page.getByTestId("region-row").nth(3).click();
  await ready(page);
  expect(await page.getByTestId("notice").count()).toBe(0);
  await page.close();
});

test("back and forward step through settled states", async () => {
  const page = await open(POINT);
  await page.getByTestId("region-row").nth(3).click();
  await page.waitForFunction(() => !location.hash.includes("h=3.8&"));
  await ready(page);
  await page.waitForTimeout(800);
  await page.getByTestId("presets").selectOption("lagrange");
  await page.waitForFunction(() => !location.hash.includes("A=2,1.1,1"));
  await ready(page);
  const regions = async (step: () => Promise<unknown>) => {
    await step();
    await page.waitForTimeout(100);
    await ready(page);
    return data(page, "point-region", "region");
  };
  expect(await regions(() => page.goBack())).toBe("R4");
  expect(await regions(() => page.goBack())).toBe("R5");
  expect(await regions(() => page.goForward())).toBe("R4");
  await page.close();
});

test("the wheel over the numbers of an axis keeps what stands beside them", async () => {
  const page = await open(`${POINT}&view=0,8,1,5`);
  const box = (await page.getByTestId("diagram").boundingBox())!;
  const shown = () => page.evaluate(() => window.bifdiag.window()!);
  const turn = async (x: number, y: number) => {
    const before = await shown();
    await page.mouse.move(box.x + x, box.y + y);
    await page.mouse.wheel(0, -200);
    await expect.poll(shown).not.toEqual(before);
    return shown();
  };
  // Below the frame, in its middle; then left of it, at its upper end.
  const frame = { x: 46, y: 8, width: box.width - 56, height: box.height - 44 };
  const below = await turn(frame.x + frame.width / 2, box.height - 10);
  expect([(below.h[0] + below.h[1]) / 2, below.l[0]]).toEqual([expect.closeTo(4, 1), expect.closeTo(1, 3)]);
  const beside = await turn(10, frame.y);
  expect([beside.h[0], beside.l[1]]).toEqual([expect.closeTo(below.h[0], 3), expect.closeTo(below.l[1], 3)]);
  await page.close();
});

test("after a change of theme nothing keeps the old colours", async () => {
  const ids = ["triangle", "octant", "diagram", "sphere"];
  const pictures = async (page: Page) => Promise.all(ids.map((id) => picture(page, id)));
  const swatch = (page: Page) => page.locator(".swatch").first().evaluate((element) => (element as HTMLElement).style.background);
  const dark = await open(`${POINT}&theme=dark`);
  const changed = await open(`${POINT}&theme=light`);
  await changed.getByTestId("theme").click();
  await changed.mouse.move(1, 1);
  await expect.poll(() => pictures(changed)).toEqual(await pictures(dark));
  expect(await swatch(changed)).toBe(await swatch(dark));
  await dark.close();
  await changed.close();
});

/** How many pixels of a canvas have a colour, such as "rgb(1, 2, 3)". */
const pixelsOf = (page: Page, id: string, color: string): Promise<number> =>
  page.getByTestId(id).evaluate((element, color) => {
    const canvas = element as HTMLCanvasElement;
    const { data } = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
    const wanted = color.match(/\d+/g)!.map(Number);
    let found = 0;
    for (let at = 0; at < data.length; at += 4) if (wanted.every((value, i) => data[at + i] === value)) found++;
    return found;
  }, color);

test("U has the very colour of its region", async () => {
  for (const [theme, h, l, name] of [["light", "3.8", "3.25", "R5"], ["dark", "3.8", "3.25", "R5"], ["light", "12", "2", "R4"], ["dark", "12", "2", "R4"]] as const) {
    const page = await open(`A=2,1.1,1&r=0.94868,0,0.61623&h=${h}&l=${l}&theme=${theme}`);
    await page.mouse.move(1, 1);
    const swatch = (region: string) => page.locator(`[data-region="${region}"] .swatch`).evaluate((element) => getComputedStyle(element).backgroundColor);
    const [own, other] = [await swatch(name), await swatch("R6")];
    // A tenth of the ball at least, the rest being in shade, under lines, or forbidden.
    const ball = await page.getByTestId("sphere").evaluate((element) => Math.PI * (0.45 * Math.min((element as HTMLCanvasElement).width, (element as HTMLCanvasElement).height)) ** 2);
    expect(await pixelsOf(page, "sphere", own), `${name} ${theme}`).toBeGreaterThan(ball / 10);
    expect(await pixelsOf(page, "diagram", own), `${name} ${theme}`).toBeGreaterThan(100);
    expect(await pixelsOf(page, "sphere", other), `${name} ${theme}`).toBeLessThan(ball / 1000);
    await page.close();
  }
});

test("no choice box or button is cut", async () => {
  for (const width of [360, 390, 768, 1024, 1280, 1440]) {
    for (const coloring of ["lyapunov", "verdict"]) {
      const page = await open(`${POINT}&coloring=${coloring}`, { viewport: { width, height: 900 }, hasTouch: width < 500, isMobile: width < 500 });
      const cut = await page.evaluate(() => {
        const boxes = [...document.querySelectorAll<HTMLElement>("button, select, input")].filter((element) => element.checkVisibility() && element.getBoundingClientRect().width > 0);
        const outside = boxes.filter((element) => {
          const { left, right } = element.getBoundingClientRect();
          for (let around = element.parentElement; around; around = around.parentElement) {
            const frame = around.getBoundingClientRect();
            if (getComputedStyle(around).overflowX !== "visible" && (left < frame.left - 0.5 || right > frame.right + 0.5)) return true;
          }
          return left < 0 || right > innerWidth;
        });
        // As wide as its text, but for the list of bodies, whose notes end in "…".
        const narrow = boxes.filter((element) => {
          if (element instanceof HTMLButtonElement) return element.scrollWidth > element.clientWidth + 1;
          if (!(element instanceof HTMLSelectElement) || element.dataset.testid === "presets") return false;
          const wide = element.getBoundingClientRect().width;
          element.style.minWidth = "max-content";
          const whole = element.getBoundingClientRect().width;
          element.style.minWidth = "";
          return whole > wide + 0.5;
        });
        return [...outside, ...narrow].map((element) => element.dataset.testid ?? element.ariaLabel ?? element.textContent);
      });
      expect(cut, `${width}, ${coloring}`).toEqual([]);
      await page.close();
    }
  }
});

test("the first printed page is full: numbers at the left, the diagram, the point and the balls at the right", async () => {
  // A4 with the margins of the browser, in its pixels.
  const page = await open(POINT, { viewport: { width: 718, height: 1047 } });
  await page.emulateMedia({ media: "print" });
  const box = async (id: string) => (await page.getByTestId(id).boundingBox())!;
  const [triangle, diagram, sphere, section] = await Promise.all(["triangle", "diagram", "sphere", "section"].map(box));
  expect(triangle!.x + triangle!.width).toBeLessThan(diagram!.x);
  expect(sphere!.y + sphere!.height).toBeLessThan(1047);
  expect(sphere!.y + sphere!.height).toBeGreaterThan(0.75 * 1047);
  expect(sphere!.x).toBeGreaterThan(triangle!.x + triangle!.width);
  expect(section!.y).toBeGreaterThan(sphere!.y + sphere!.height);
  const rows = (await page.getByTestId("region-row").last().boundingBox())!;
  expect(rows.x + rows.width).toBeLessThan(diagram!.x);
  await page.close();
});

test("on paper canvases keep their shape, and there are no buttons", async () => {
  const page = await open(POINT);
  await page.emulateMedia({ media: "print" });
  expect(await page.locator("button:visible, select:visible").count()).toBe(0);
  expect(await page.getByTestId("sphere").evaluate((element) => getComputedStyle(element).objectFit)).toBe("contain");
  expect(await page.getByTestId("bodies-map").isVisible()).toBe(false);
  expect(await page.locator(".swatch").first().evaluate((element) => getComputedStyle(element).printColorAdjust)).toBe("exact");
  await page.close();
});

test("what is dark on the screen is light on paper", async () => {
  const ids = ["triangle", "octant", "diagram", "sphere", "section"];
  const pictures = async (page: Page) => Promise.all(ids.map((id) => picture(page, id)));
  const told = (page: Page, event: string) => page.evaluate((event) => dispatchEvent(new Event(event)), event);
  const still = async (page: Page) => {
    await page.getByTestId("play").evaluate((button) => button.textContent === "❚❚" && (button as HTMLElement).click());
    await page.getByLabel("time").fill("0");
    await page.waitForTimeout(300);
  };
  const light = await open(`${POINT}&theme=light`);
  const dark = await open(`${POINT}&theme=dark`);
  await Promise.all([still(light), still(dark)]);
  const before = await pictures(dark);
  await told(dark, "beforeprint");
  expect(await pictures(dark)).toEqual(await pictures(light));
  await told(dark, "afterprint");
  await expect.poll(() => pictures(dark)).toEqual(before);
  expect(dark.url()).toContain("theme=dark");
  await light.close();
  await dark.close();
});

test("steady rotations at the point's momentum are listed with their verdicts", async () => {
  const page = await open(POINT);
  const rows = await page.getByTestId("steady-row").allTextContents();
  expect(rows.length).toBe(6);
  expect(rows.at(0)).toBe("G2.11.64stablestable");
  expect(rows.at(-1)).toContain("stableunstable");
  expect(await page.getByTestId("verdict-changes").textContent()).toContain("1:2 on G0.1 at l = 2.237 (unstable)");
  await page.close();
});

test("for a lecture one panel fills the screen, and keys go on", async () => {
  const page = await open(POINT);
  await page.getByTestId("present-diagram").click();
  const { width, height } = (await page.locator("[data-panel=diagram]").boundingBox())!;
  expect([Math.round(width), Math.round(height)]).toEqual([1280, 720]);
  expect(page.url()).toContain("present=diagram");
  // A press is where it is seen, though the panel is magnified.
  const box = (await page.getByTestId("diagram").boundingBox())!;
  await page.mouse.click(box.x + 0.8 * box.width, box.y + 0.7 * box.height);
  await ready(page);
  expect(await data(page, "point-region", "region")).toBe("R4");
  await page.keyboard.press("PageDown");
  expect((await page.locator("[data-panel=sphere]").boundingBox())!.width).toBeGreaterThan(1270);
  await page.keyboard.press("Escape");
  await expect.poll(async () => (await page.locator("[data-panel=sphere]").boundingBox())!.width).toBeLessThan(600);
  expect(page.url()).not.toContain("present");
  await page.close();
});

test("a sweep of one number tells what the diagram goes through, and comes back", async () => {
  const page = await open(POINT);
  await page.getByTestId("sweep").click();
  await expect.poll(() => page.getByTestId("passed").textContent(), { timeout: 20_000 }).toMatch(/^r2 = 0\.\d+: \S/);
  await expect.poll(() => page.getByTestId("sweep").textContent(), { timeout: 30_000 }).toContain("Sweep");
  await ready(page);
  expect(page.url()).toContain(PAPER);
  await page.close();
});
