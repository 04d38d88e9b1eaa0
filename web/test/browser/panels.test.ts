/** Each panel under a hand. */
import { mkdtemp, readFile, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { expect, test } from "vitest";
import type { Page } from "playwright-core";
import { TOUR } from "../../src/guide/tour";
import words from "../../src/texts/en/guide";
import { bifdiag } from "../program";
import { colors, data, go, open, picture, ready, serve, SIZE } from "./open";

serve();

const POINT = "A=2,1.1,1&r=0.94868,0,0.61623&h=3.8&l=3.25";
const PANELS = ["diagram", "region-row", "point-status", "point-signature", "point-region", "sphere", "section", "motion", "bodies-map", "crossing-count", "export-json", "export-svg", "permalink"];

const crossings = (page: Page): Promise<number> => page.getByTestId("crossing-count").textContent().then(Number);

test("all panels are there, and diagram, sphere and section stand inside the window", async () => {
  const page = await open(POINT);
  for (const id of PANELS) expect(await page.getByTestId(id).count(), id).toBeGreaterThan(0);
  for (const id of ["diagram", "sphere", "section"]) {
    const box = (await page.getByTestId(id).boundingBox())!;
    expect(box.y >= 0 && box.y + box.height <= SIZE.height && box.x >= 0 && box.x + box.width <= SIZE.width, id).toBe(true);
    expect(Math.min(box.width, box.height), id).toBeGreaterThan(150);
    expect(await colors(page, id), id).toBeGreaterThan(20);
  }
  expect(await page.getByTestId("error").count()).toBe(0);
  await page.close();
});

test("the section: orbits of the command line's starts, and one more where it is clicked", async () => {
  const page = await open(POINT);
  const before = await crossings(page);
  const native = JSON.parse(bifdiag("section", "--body=paper", "--h=3.8", "--l=3.25", "--json", "--no-plot")) as { summary: { crossings: number }; orbits: { theta: number; psi: number }[] };
  // The starts lie on the section: each is the orbit's crossing 0.
  expect(before).toBe(native.summary.crossings + native.orbits.length);
  const found = await page.evaluate(() => window.bifdiag.crossings());
  expect(Object.values(found).map((list) => list.length)).toEqual([before, before, before, before, before]);
  native.orbits.forEach(({ theta, psi }, orbit) => {
    const first = found.orbit.indexOf(orbit);
    expect([found.theta[first], found.psi[first], found.index[first]]).toEqual([expect.closeTo(theta, 12), expect.closeTo(psi, 12), 0]);
  });
  const box = (await page.getByTestId("section").boundingBox())!;
  await page.mouse.click(box.x + 0.25 * box.width, box.y + 0.25 * box.height);
  await expect.poll(() => crossings(page)).toBe(before + 501);
  await page.close();
});

test("verdicts are the command line's, in its words", async () => {
  // Orbits differ in their last bits, so that a chaotic one ends elsewhere and the numbers of a reason differ with it.
  const words = (reason: string) => reason.replace(/[-\d.e]+/g, "#");
  for (const [h, l] of [["3.8", "3.25"], ["6", "2"]] as const) {
    const page = await open(`A=2,1.1,1&r=0.94868,0,0.61623&h=${h}&l=${l}&coloring=verdict`);
    const native = JSON.parse(bifdiag("section", "--body=paper", `--h=${h}`, `--l=${l}`, "--json", "--no-plot")) as { orbits: { verdict: string; reason: string }[] };
    const here = async (verdict: string) => Number(await data(page, "verdicts", verdict));
    const there = (verdict: string) => native.orbits.filter((orbit) => orbit.verdict === verdict).length;
    // Open orbits are followed further within a budget: there all orbits share one, here those of a batch do, and more stay open.
    const [regular, chaotic, undecided] = [await here("regular"), await here("chaotic"), await here("open")];
    expect(regular + chaotic + undecided).toBe(native.orbits.length);
    expect(regular).toBeLessThanOrEqual(there("regular"));
    expect(regular + undecided).toBeGreaterThanOrEqual(there("regular"));
    expect(chaotic).toBeLessThanOrEqual(there("chaotic") + there("open"));
    expect(chaotic > 0).toBe(there("chaotic") > 0);
    for (const orbit of [0, 5, 23]) {
      await page.getByTestId("orbit").selectOption(String(orbit));
      const told = page.getByTestId("verdict");
      const { verdict, reason } = native.orbits[orbit]!;
      await expect.poll(() => told.textContent()).toMatch(new RegExp(`Orbit ${orbit} is (${verdict}|open)`));
      const text = (await told.textContent())!;
      if (text.includes(`is ${verdict}`)) expect(words(text)).toContain(words(reason));
    }
    await page.close();
  }
});

test("the verdict of the orbit under the pointer is told beside it", async () => {
  const page = await open(`${POINT}&orbits=1`);
  const box = (await page.getByTestId("section").boundingBox())!;
  const at = await page.evaluate(() => {
    const { theta, psi, sheet } = window.bifdiag.crossings();
    return { theta: theta[9]!, psi: psi[9]!, sheet: sheet[9]! };
  });
  const each = (box.width - 68) / 2;
  await page.mouse.move(box.x + 30 + (at.sheet > 0 ? 0 : each + 26) + (at.psi / (2 * Math.PI)) * each, box.y + 22 + (at.theta / Math.PI) * (box.height - 52));
  await expect.poll(() => page.getByTestId("orbit-tip").textContent()).toMatch(/^orbit 0: (regular|chaotic|open)/);
  // It is of no other section.
  await page.getByTestId("input-l").fill("3.2");
  await page.getByTestId("input-l").press("Enter");
  await ready(page);
  expect(await page.getByTestId("orbit-tip").isVisible()).toBe(false);
  await page.close();
});

test("after a stop the section goes on where it is clicked", async () => {
  const page = await open(POINT);
  await go(page, `${POINT}&theme=dark`);
  await page.evaluate(() => (location.hash = "A=2,1.1,1&r=0.94868,0,0.61623&h=6&l=2&orbits=400&crossings=20000"));
  await page.getByRole("button", { name: "Stop" }).click();
  await expect.poll(() => page.getByRole("button", { name: "Stop" }).isVisible()).toBe(false);
  const before = await crossings(page);
  const box = (await page.getByTestId("section").boundingBox())!;
  await page.mouse.click(box.x + 0.25 * box.width, box.y + 0.5 * box.height);
  await expect.poll(() => crossings(page)).toBe(before + 20001);
  await expect.poll(() => page.getByTestId("verdict").textContent()).toMatch(/^Orbit \d+ is (regular|chaotic|open)/);
  await page.close();
});

test("the sphere turns under the hand, and its components are told", async () => {
  const page = await open(POINT);
  const before = await picture(page, "sphere");
  const box = (await page.getByTestId("sphere").boundingBox())!;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 70, y + 20, { steps: 4 });
  await page.mouse.up();
  await expect.poll(() => picture(page, "sphere")).not.toBe(before);
  const lit = page.locator(".components .lit");
  await page.mouse.move(x + 70, y + 19);
  await expect.poll(() => lit.count()).toBe(1);
  expect(await lit.textContent()).toMatch(/^U = D²/);
  await page.mouse.move(2, 2);
  await expect.poll(() => lit.count()).toBe(0);
  await page.close();
});

test("the body moves, and pauses", async () => {
  const page = await open(POINT);
  const before = await picture(page, "motion");
  await expect.poll(() => picture(page, "motion")).not.toBe(before);
  await page.getByTestId("play").click();
  const later = () => page.waitForTimeout(300).then(() => picture(page, "motion"));
  await expect.poll(async () => (await picture(page, "motion")) === (await later())).toBe(true);
  await page.close();
});

test("a click into the diagram chooses a point; the address holds it and gives it back", async () => {
  const page = await open("A=2,1.1,1&r=0.94868,0,0.61623");
  const box = (await page.getByTestId("diagram").boundingBox())!;
  await page.mouse.click(box.x + 0.6 * box.width, box.y + 0.6 * box.height);
  await page.waitForFunction(() => location.hash.includes("&h="));
  await ready(page);
  expect(await data(page, "point-region", "region")).toBe("R4");
  const link = (await page.getByTestId("permalink").getAttribute("href"))!;
  expect(link).toBe(page.url());
  const again = await open(link.split("#")[1]!);
  expect(await data(again, "point-region", "region")).toBe("R4");
  expect(await again.getByTestId("input-h").inputValue()).toBe(await page.getByTestId("input-h").inputValue());
  expect(await crossings(again)).toBe(await crossings(page));
  await page.close();
  await again.close();
});

test("after a click the point is decided exactly, and what was told of the way there goes when a number is typed", async () => {
  const page = await open(POINT);
  const box = (await page.getByTestId("diagram").boundingBox())!;
  for (const [x, y] of [[0.5, 0.55], [0.8, 0.7], [0.75, 0.2]] as const) {
    await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
    await ready(page);
    // What comes late must not take its place.
    await page.waitForTimeout(500);
    expect(await page.getByTestId("point-status").textContent()).toBe("decided exactly");
  }
  await expect.poll(() => page.getByTestId("surgery").textContent()).not.toBe("");
  await page.getByTestId("input-h").fill("-8");
  await page.getByTestId("input-h").press("Enter");
  await ready(page);
  expect(await page.getByTestId("surgery").textContent()).toBe("");
  // The field still has the focus: an address that is opened is shown in it nevertheless.
  await go(page, POINT);
  expect(await page.getByTestId("input-h").inputValue()).toBe("3.8");
  await page.close();
});

test("axes of small bodies are in units of a power of ten, with short numbers beside them", async () => {
  const page = await open("A=2e-5,1.1e-5,1e-5&r=9e-6,2e-6,6e-6");
  const [file] = await Promise.all([page.waitForEvent("download"), page.getByTestId("export-svg").click()]);
  const texts = [...(await readFile((await file.path())!, "utf8")).matchAll(/<text[^>]*>([^<]*)</g)].map(([, text]) => text!);
  expect(texts).toContain("momentum l / 10⁻⁵");
  expect(texts).toContain("energy h / 10⁻⁴");
  expect(texts.filter((text) => /^0\.000/.test(text))).toEqual([]);
  expect(await page.getByTestId("input-l").inputValue()).toMatch(/^\d\.\d+e-5$/);
  await page.close();
});

test("the name of a region stands beside the point, not under it", async () => {
  for (const [hash, id] of [["body=kovalevskaya", "R2"], ["A=2,1.1,1&r=0.94868,0,0.61623&h=3.8&l=3.25&view=straight", "R5"]] as const) {
    const page = await open(hash, { viewport: { width: 390, height: 844 } });
    expect(await data(page, "point-region", "region")).toBe(id);
    const [h, l] = await Promise.all(["input-h", "input-l"].map((field) => page.getByTestId(field).inputValue().then(Number)));
    const [x, y] = (await page.evaluate(([h, l]) => window.bifdiag.place(h!, l!), [h, l]))!;
    const [file] = await Promise.all([page.waitForEvent("download"), page.getByTestId("export-svg").click()]);
    const svg = await readFile((await file.path())!, "utf8");
    const name = new RegExp(`<text[^>]*>${id}</text>`).exec(svg)![0];
    const [tx, ty] = ["x", "y"].map((axis) => Number(new RegExp(` ${axis}="([^"]*)"`).exec(name)![1]));
    // Eight pixels of letters and six of the point.
    expect(Math.abs(tx! - x) > 14 || Math.abs(ty! - 4 - y) > 12, `${hash}: ${name} at ${x}, ${y}`).toBe(true);
    await page.close();
  }
});

test("lines to copy are broken between their options, and copied whole", async () => {
  const page = await open(POINT);
  const shell = page.getByTestId("command-line");
  expect(await shell.textContent()).toContain("bifdiag classify --A=2,1.1,1 --r=0.94868,0,0.61623 --h=3.8 --l=3.25\nbifdiag section --A=2,1.1,1");
  const heights = await shell.locator("span").evaluateAll((words) => words.map((word) => word.getBoundingClientRect().height));
  expect(heights.length).toBeGreaterThan(10);
  expect(new Set(heights).size).toBe(1);
  await page.close();
});

test("dragging the point over a curve tells the surgery", async () => {
  const page = await open("A=2,1.1,1&r=0.94868,0,0.61623&h=3.2&l=2.4&view=1.8,3.8,2,3.1");
  const box = (await page.getByTestId("diagram").boundingBox())!;
  const place = (h: number, l: number) => [box.x + 46 + ((h - 1.8) / 2) * (box.width - 56), box.y + 8 + (1 - (l - 2) / 1.1) * (box.height - 44)] as const;
  await page.mouse.move(...place(3.2, 2.4));
  await page.mouse.down();
  await page.mouse.move(...place(2.25, 2.4), { steps: 3 });
  await expect.poll(() => page.getByTestId("surgery").textContent()).toBe("R2 → R5 across G1.2: at a saddle components of U part, and those of E with them (D2 to D2 + D2).");
  await page.mouse.up();
  await ready(page);
  expect(await data(page, "point-region", "region")).toBe("R5");
  await page.close();
});

const TETRAHEDRON = "v 0 0 0\nv 3 0 0\nv 0 2 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

test("a real part becomes the body, as the command line understands it", async () => {
  const page = await open("");
  await page.getByTestId("part").locator("summary").click();
  await page.getByTestId("part-units").selectOption("g,mm,s");
  const mesh = { name: "part.obj", mimeType: "model/obj", buffer: Buffer.from(TETRAHEDRON) };
  await page.getByTestId("part-file").setInputFiles(mesh);
  await expect.poll(() => page.getByTestId("error").textContent()).toContain("density");
  await page.getByTestId("part-density").fill("0.5");
  await page.getByTestId("part-file").setInputFiles(mesh);
  await expect.poll(() => page.getByTestId("part-note").textContent()).toContain("g mm s");
  await ready(page);
  const folder = await mkdtemp(join(tmpdir(), "bifdiag-"));
  await writeFile(join(folder, mesh.name), mesh.buffer);
  const native = JSON.parse(bifdiag("body", `--part=${join(folder, mesh.name)}`, "--density=0.5", "--units=g,mm,s", "--json")) as { A: string[]; r: string[] };
  expect(await page.getByTestId("input-A1").inputValue()).toBe(native.A[0]);
  expect(await page.getByTestId("input-r3").inputValue()).toBe(native.r[2]);
  expect(await page.getByTestId("error").count()).toBe(0);

  await page.getByTestId("part-units").selectOption("kg,m,s");
  await page.getByTestId("part-tensor").fill("2.1 1.8 1.2 0.3 -0.1 0.2");
  await page.getByTestId("part-mass").fill("0.5");
  await page.getByTestId("part-point").fill("0, 0.1, 0.2");
  await page.getByTestId("part-take").click();
  await expect.poll(() => page.getByTestId("error").textContent()).toContain("choose which one");
  await page.getByTestId("part-products").selectOption("integral");
  await page.getByTestId("part-take").click();
  await expect.poll(() => page.getByTestId("part-note").textContent()).toContain("kg m s");
  await ready(page);
  const tensor = JSON.parse(bifdiag("body", "--inertia-com=2.1,1.8,1.2,0.3,-0.1,0.2", "--products=integral", "--com=0,0.1,0.2", "--mass=0.5", "--json")) as { A: string[] };
  expect(await page.getByTestId("input-A1").inputValue()).toBe(tensor.A[0]);
  // The address holds the part's body with all its digits.
  const again = await open((await page.getByTestId("permalink").getAttribute("href"))!.split("#")[1]!);
  expect(await again.getByTestId("input-A1").inputValue()).toBe(tensor.A[0]);
  expect(await again.evaluate(() => window.bifdiag.atlas())).toBe(await page.evaluate(() => window.bifdiag.atlas()));
  await again.close();
  await page.close();
});

test("a tablet: taps choose points and start orbits, two fingers zoom", async () => {
  const page = await open(POINT, { viewport: { width: 1024, height: 768 }, hasTouch: true });
  const box = (await page.getByTestId("diagram").boundingBox())!;
  await page.touchscreen.tap(box.x + 0.8 * box.width, box.y + 0.7 * box.height);
  await page.waitForFunction(() => !location.hash.includes("h=3.8&"));
  await ready(page);
  expect(await data(page, "point-region", "region")).toBe("R4");
  const devtools = await page.context().newCDPSession(page);
  const touch = (type: "touchStart" | "touchMove" | "touchEnd", apart: number) => {
    const y = box.y + box.height / 2;
    const touchPoints = type === "touchEnd" ? [] : [-1, 1].map((side, id) => ({ x: box.x + box.width / 2 + side * apart, y, id }));
    return devtools.send("Input.dispatchTouchEvent", { type, touchPoints });
  };
  const hl = page.url().match(/h=[^&]*&l=[^&]*/)![0];
  await touch("touchStart", 30);
  for (let apart = 40; apart <= 120; apart += 20) await touch("touchMove", apart);
  await touch("touchEnd", 0);
  await page.waitForFunction(() => location.hash.includes("view="));
  // Two fingers leave the point where it is.
  expect(page.url()).toContain(hl);
  await ready(page);
  const before = await crossings(page);
  await page.getByTestId("section").scrollIntoViewIfNeeded();
  const section = (await page.getByTestId("section").boundingBox())!;
  await page.touchscreen.tap(section.x + 0.25 * section.width, section.y + 0.5 * section.height);
  await expect.poll(() => crossings(page)).toBe(before + 501);
  await page.close();
});

test("a view 1e-6 wide still shows curves, refined, and regions", async () => {
  const critical = (JSON.parse(bifdiag("critical", "--body=paper", "--l=3.25", "--json")) as { critical: { h: number }[] }).critical[1]!.h;
  const page = await open(`A=2,1.1,1&r=0.94868,0,0.61623&view=${critical - 5e-7},${critical + 5e-7},3.2499999,3.2500001`);
  const seen = await page.getByTestId("diagram").evaluate((element) => {
    const canvas = element as HTMLCanvasElement;
    const row = canvas.getContext("2d")!.getImageData(0, Math.floor(canvas.height / 2), canvas.width, 1);
    return new Set(new Uint32Array(row.data.buffer)).size;
  });
  // Two grounds, the curve and its soft edges.
  expect(seen).toBeGreaterThan(3);
  await page.close();
});

test("files: atlas, SVG, PNG, CSV, NPZ, video", async () => {
  const page = await open(POINT);
  const download = async (id: string): Promise<Buffer> => {
    const [file] = await Promise.all([page.waitForEvent("download"), page.getByTestId(id).click()]);
    return readFile((await file.path())!);
  };
  expect((await download("export-json")).toString()).toBe(bifdiag("--body=paper", "--json"));
  const svg = (await download("export-svg")).toString();
  expect(svg).toMatch(/^<svg/);
  expect(svg).toContain("energy h");
  expect((await download("export-png")).subarray(1, 4).toString()).toBe("PNG");
  const csv = (await download("export-csv")).toString().trim().split("\n");
  expect(csv.length).toBe((await crossings(page)) + 1);
  const npz = await download("export-npz");
  expect(npz.subarray(0, 2).toString()).toBe("PK");
  expect(npz.includes("s_dot.npy")).toBe(true);
  await page.getByTestId("export-video").click();
  await page.waitForTimeout(1500);
  expect((await download("export-video")).length).toBeGreaterThan(1000);
  await page.close();
});

test("each step of the tour shows what it promises", async () => {
  const page = await open("tour=1");
  for (const [number, state] of TOUR.entries()) {
    await expect.poll(() => page.getByTestId("guide").textContent()).toContain(words.tour[number]!.title);
    expect(await page.getByTestId("error").count()).toBe(0);
    if (state.point) expect(await data(page, "point-status", "status")).toBe("regular");
    if (state.point) expect(await crossings(page)).toBeGreaterThan(1000);
    if (process.env.PICTURES) await page.screenshot({ path: `${process.env.PICTURES}/tour-${number + 1}.png` });
    await page.getByTestId("tour-next").click();
    if (number + 1 < TOUR.length) await page.waitForFunction((step) => location.hash.includes(`tour=${step}`), number + 2);
    await ready(page);
  }
  expect(await page.getByTestId("guide").isVisible()).toBe(false);
  await page.close();
});

test("lessons ask first and show then", async () => {
  const page = await open("");
  await page.getByTestId("lessons").click();
  await page.getByRole("button", { name: /sleeping top/ }).click();
  await page.getByRole("button", { name: "The whole sphere" }).click();
  await ready(page);
  expect(await page.getByTestId("guide").textContent()).toContain("As you predicted");
  expect(await page.getByTestId("guide").isVisible()).toBe(true);
  expect(page.url()).toContain("lesson=sleeping-top");
  await page.getByRole("button", { name: "Next question" }).click();
  await page.getByRole("button", { name: "The whole sphere again" }).click();
  await ready(page);
  expect(await page.getByTestId("guide").textContent()).toContain("Not as predicted: only a small cap");
  const [sheet] = await Promise.all([page.waitForEvent("download"), page.getByTestId("worksheet").click()]);
  const paper = await readFile((await sheet.path())!, "utf8");
  expect(paper).toContain("Predict, then observe");
  expect(paper).toContain(`${page.url().split("#")[0]}?lang=en#lesson=sleeping-top`);
  expect(await page.getByTestId("input-l").inputValue()).toBe("2.1");
  await page.close();
  // The link of the worksheet shows the body that is asked about, and no point yet.
  const linked = await open("lesson=sleeping-top");
  await expect.poll(() => linked.getByTestId("input-A2").inputValue()).toBe("1");
  expect(await linked.getByTestId("input-h").inputValue()).toBe("");
  await linked.close();
});

test("one panel alone for lecture pages", async () => {
  for (const name of ["diagram", "section", "motion"]) {
    const page = await open(`${POINT}&embed=${name}`, { viewport: { width: 600, height: 420 } });
    for (const id of ["diagram", "sphere", "section", "motion"]) expect(await page.getByTestId(id).isVisible(), `${id} in ${name}`).toBe(id === name);
    for (const id of ["stack-bar", "beside"]) expect(await page.getByTestId(id).isVisible(), name).toBe(false);
    // All of it is inside the frame.
    if (name === "section") expect((await page.getByTestId("crossing-count").boundingBox())!.y).toBeLessThan(400);
    const box = (await page.getByTestId(name).boundingBox())!;
    expect(box.y + box.height, name).toBeLessThanOrEqual(420);
    expect(await colors(page, name)).toBeGreaterThan(20);
    await page.close();
  }
});

test("a second body stands beside the first, in the same window and at the same point", async () => {
  const page = await open("A=2,1.1,1&r=0.94868,0,0.61623&h=3.8&l=3.25");
  const twin = page.getByTestId("twin");
  await page.getByTestId("beside").click();
  await expect.poll(() => page.evaluate(() => location.hash)).toContain("beside=2,1.1,1,0.94868,0,0.61623");
  await go(page, "A=2,2,1&r=1,0,0&h=2.5&l=1&beside=2,1.1,1,0.94868,0,0.61623");
  const inside = async () => (await (await twin.elementHandle())!.contentFrame())!;
  const shown = async () => (await inside()).evaluate(() => (document.documentElement.dataset.ready === "true" ? location.hash : ""));
  await expect.poll(shown).toContain("A=2,1.1,1&r=0.94868,0,0.61623&h=2.5&l=1&view=");
  // All of it is in its frame, with buttons as small as those of the first.
  expect(await (await inside()).evaluate(() => document.querySelector("[data-testid=diagram]")!.getBoundingClientRect().bottom <= innerHeight)).toBe(true);
  const tall = (root: { locator: Page["locator"] }) => root.locator("[data-testid=straight]").evaluate((button) => button.getBoundingClientRect().height);
  expect(await tall(await inside())).toBe(await tall(page));
  const { h, l } = await page.evaluate(() => window.bifdiag.window()!);
  expect(await shown()).toContain(`view=${[...h, ...l].join(",")}&embed=diagram`);
  await page.getByTestId("swap").click();
  await expect.poll(() => page.evaluate(() => location.hash)).toContain("A=2,1.1,1&r=0.94868,0,0.61623&h=2.5&l=1&beside=2,2,1,1,0,0");
  await expect.poll(shown).toContain("A=2,2,1&r=1,0,0&h=2.5&l=1&view=");
  await page.getByTestId("beside").click();
  await expect.poll(() => twin.count()).toBe(0);
  expect(await page.evaluate(() => location.hash)).not.toContain("beside");
  await page.close();
});

test("dark and light", async () => {
  const page = await open(POINT, { colorScheme: "dark" });
  const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const dark = await ground();
  await page.getByTestId("theme").click();
  await expect.poll(ground).not.toBe(dark);
  expect(page.url()).toContain("theme=light");
  await go(page, `${POINT}&theme=dark`);
  expect(await ground()).toBe(dark);
  await page.close();
});

test("the map of bodies fills when it is looked at", async () => {
  const page = await open("body=katok:6");
  const files = () => page.evaluate(() => performance.getEntriesByType("resource").map(({ name }) => name).filter((name) => /classes-[^/]*\.js$/.test(name)).length);
  expect(await files()).toBe(0);
  await page.getByTestId("bodies-map").scrollIntoViewIfNeeded();
  await expect.poll(() => page.getByText(/Here: \d+ regions, class [0-9a-f]{12} \(katok:6/).count(), { timeout: 60_000 }).toBe(1);
  expect(await files()).toBe(1);
  expect(await colors(page, "bodies-map")).toBeGreaterThan(8);
  await page.getByLabel("plane").selectOption("moments");
  // At once: a quick machine would be done before a pointer is there.
  await page.waitForFunction(() => {
    const stop = document.querySelector<HTMLButtonElement>("[data-testid=stop-map]")!;
    if (stop.hidden) return false;
    stop.click();
    return true;
  });
  const seen = await page.getByText(/classes seen, \d+ %/).textContent();
  await page.waitForTimeout(700);
  expect(await page.getByText(/classes seen, \d+ %/).textContent()).toBe(seen);
  expect(await page.getByTestId("stop-map").isVisible()).toBe(false);
  await page.close();
});
