/** A lecturer makes a link to a task; a student opens it. */
import { expect, test } from "vitest";
import type { Page } from "playwright-core";
import { data, go, open, ready, serve } from "./open";

serve();

const POINT = "A=2,1.1,1&r=0.94868,0,0.61623&h=3.8&l=3.25";

/** Fills the dialog, field by field. */
async function write(page: Page, texts: Record<string, string>): Promise<void> {
  for (const [field, text] of Object.entries(texts)) await page.getByTestId(`task-${field}`).fill(text);
}
const hint = (page: Page) => page.getByTestId("task-hint").textContent();
const made = async (page: Page, id = "task-link") => (await page.getByTestId(id).textContent())!;

test("a question with answers: what is missing is told, the link shows it, the point waits for the answer", async () => {
  const page = await open(POINT);
  await page.getByTestId("task-open").click();
  expect(await hint(page)).toContain("Write the task");
  expect(await page.getByTestId("task-question").getAttribute("aria-invalid")).toBe("true");
  expect(await page.getByTestId("task-link").isVisible()).toBe(false);
  await write(page, { heading: "Übung 1", question: "How many pieces has U at (3,8 | 3,25)?", because: "Each disc is a\npiece of its own." });
  expect(await page.getByTestId("task-question").getAttribute("aria-invalid")).toBe(null);
  await page.getByTestId("task-later").check();
  expect(await hint(page)).toContain("only if there are answers");
  await write(page, { choices: "One\nTwo" });
  expect(await hint(page)).toContain("No answer is marked as right");
  expect(await page.getByTestId("task-link").isVisible()).toBe(false);
  await write(page, { choices: "One\n* Two" });
  expect(await hint(page)).toMatch(/^\d+ characters$/);
  const link = await made(page);
  expect(await page.getByTestId("task-try").getAttribute("href")).toBe(link);
  await page.close();

  const student = await open(link.split("#")[1]!);
  const card = student.getByTestId("guide");
  expect(await card.textContent()).toContain("Übung 1");
  expect(await card.textContent()).toContain("How many pieces has U at (3,8 | 3,25)?");
  expect(await card.textContent()).not.toContain("piece of its own");
  expect(await student.getByTestId("input-h").inputValue()).toBe("");
  await card.getByRole("button", { name: "One" }).click();
  await ready(student);
  expect(await card.textContent()).toContain("Not as predicted: two.");
  expect(await card.textContent()).toContain("piece of its own");
  expect(await data(student, "point-region", "region")).toBe("R5");
  // The address goes on with the student, and still opens the task.
  await student.reload();
  await ready(student);
  expect(await card.textContent()).toContain("How many pieces");
  expect(await data(student, "point-region", "region")).toBe("R5");
  await student.close();
});

test("a task with one panel alone, on a page of the lecturer's own; without a section there is none", async () => {
  const page = await open("A=2,1.1,1&r=0.94868,0,0.61623&h=-5&l=1");
  await page.getByTestId("task-open").click();
  await write(page, { question: "Start three orbits." });
  await page.getByTestId("task-view").selectOption("embed=section");
  expect(await hint(page)).toContain("There is no section at this point");
  expect(await page.getByTestId("task-link").isVisible()).toBe(false);
  await page.keyboard.press("Escape");
  await page.getByTestId("region-row").nth(4).click();
  await page.waitForFunction(() => !location.hash.includes("h=-5"));
  await ready(page);
  await page.getByTestId("task-open").click();
  expect(await hint(page)).toMatch(/^\d+ characters$/);
  const frame = await made(page, "task-frame");
  const link = await made(page);
  expect(frame).toContain(`<iframe src="${link.replace(/&/g, "&amp;")}"`);
  expect(link).toContain("embed=section&task=");
  await page.close();
  const alone = await open(link.split("#")[1]!, { viewport: { width: 600, height: 600 } });
  expect(await alone.getByTestId("guide").textContent()).toContain("Start three orbits.");
  expect(await alone.getByTestId("diagram").isVisible()).toBe(false);
  const [card, section] = [(await alone.getByTestId("guide").boundingBox())!, (await alone.getByTestId("section").boundingBox())!];
  expect(card.y + card.height).toBeLessThanOrEqual(section.y);
  expect(section.height).toBeGreaterThan(200);
  await alone.close();
});

test("the dialog says what holds now: when it is opened again, and when an answer comes while it is open", async () => {
  const page = await open("A=2,1.1,1&r=0.94868,0,0.61623&h=-5&l=1");
  await page.getByTestId("task-open").click();
  await write(page, { question: "Start three orbits." });
  await page.getByTestId("task-view").selectOption("embed=section");
  expect(await hint(page)).toContain("There is no section at this point");
  await page.keyboard.press("Escape");
  await go(page, POINT);
  // In the same moment, not when something was loaded again.
  const again = await page.getByTestId("task-open").evaluate((button) => {
    (button as HTMLElement).click();
    return document.querySelector("[data-testid=task-hint]")!.textContent;
  });
  expect(again).toMatch(/^\d+ characters$/);
  await go(page, "A=2,1.1,1&r=0.94868,0,0.61623&h=-5&l=1");
  expect(await page.getByTestId("task-dialog").isVisible()).toBe(true);
  expect(await hint(page)).toContain("There is no section at this point");
  expect(await page.getByTestId("task-link").isVisible()).toBe(false);
  await page.close();
});

test("a student can start again; a link that came over broken is told to be so", async () => {
  const page = await open(POINT);
  await page.getByTestId("task-open").click();
  await write(page, { question: "Find a torus." });
  const link = (await made(page)).split("#")[1]!;
  await page.close();
  const student = await open(link);
  await student.getByTestId("region-row").nth(2).click();
  await student.waitForFunction(() => !location.hash.includes("h=3.8&"));
  await ready(student);
  expect(await student.getByTestId("guide").textContent()).toContain("Find a torus.");
  await student.getByTestId("task-again").click();
  await student.waitForFunction(() => location.hash.includes("h=3.8&"));
  await ready(student);
  expect(await data(student, "point-region", "region")).toBe("R5");
  await student.close();
  const broken = await open(link.slice(0, -4));
  expect(await broken.getByTestId("error").textContent()).toContain("did not come over whole");
  await broken.close();
});
