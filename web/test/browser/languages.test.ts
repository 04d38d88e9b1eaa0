/** The page in each language. */
import { expect, test } from "vitest";
import type { Page } from "playwright-core";
import { address, data, load, open, ready, serve } from "./open";

serve();

const POINT = "A=2,1.1,1&r=0.94868,0,0.61623&h=3.8&l=3.25";

/** What each language calls a few things, and a word that is English alone. */
const WORDS = {
  en: { locale: "en-GB", region: "Region R5. Section: sphere and torus. Accessible: disc and disc.", section: "Poincaré section", tour: "One body, nine regions", terms: "Steady rotation" },
  de: { locale: "de-AT", region: "Gebiet R5. Schnitt: Sphäre und Torus. Zugänglich: Scheibe und Scheibe.", section: "Poincaré-Schnitt", tour: "Ein Körper, neun Gebiete", terms: "Staude-Drehung" },
  fr: { locale: "fr-CA", region: "Région R5. Section : sphère et tore. Accessible : disque et disque.", section: "Section de Poincaré", tour: "Un corps, neuf régions", terms: "Rotation permanente" },
};
type Name = keyof typeof WORDS;

/** What was loaded, in bytes as it is served packed. */
const loaded = (page: Page) => page.evaluate(() => performance.getEntriesByType("resource").map(({ name }) => name.split("/").at(-1)!));

test.each(Object.keys(WORDS) as Name[])("%s: a browser that asks for it gets it, whole", async (name) => {
  const { locale, region, section, tour, terms } = WORDS[name];
  const page = await open(POINT, { locale });
  expect(await page.evaluate(() => document.documentElement.lang)).toBe(name);
  expect(await page.getByTestId("told").textContent()).toBe(region);
  expect(await page.locator("[data-panel=section] h2").textContent()).toBe(section);
  expect(await page.getByTestId("language").inputValue()).toBe(name);
  // One file of texts is loaded, and those of the guides with the tour.
  const texts = async () => (await loaded(page)).filter((file) => /^(page|guide)-.*\.js$/.test(file)).length;
  expect(await texts()).toBe(1);
  await page.getByTestId("tour").click();
  await expect.poll(() => page.getByTestId("guide").textContent()).toContain(tour);
  expect(await texts()).toBe(2);
  await page.getByTestId("glossary").click();
  await expect.poll(() => page.locator("dialog dl").textContent()).toContain(terms);
  await page.keyboard.press("Escape");
  // Numbers are read with a decimal comma, and written with a point.
  await page.getByTestId("input-h").fill("3,9");
  await page.getByTestId("input-h").press("Enter");
  await page.waitForFunction(() => location.hash.includes("h=3.9"));
  expect(await page.getByTestId("input-h").inputValue()).toBe("3.9");
  await ready(page);
  await page.close();
});

test("another language is chosen by hand, at the same state; the address keeps it", async () => {
  const page = await open(POINT);
  await page.getByTestId("language").selectOption("de");
  await page.waitForURL(/\?lang=de#/);
  await ready(page);
  expect(page.url()).toBe(`${address}?lang=de#${POINT}`);
  expect(await data(page, "point-region", "region")).toBe("R5");
  expect(await page.getByTestId("told").textContent()).toBe(WORDS.de.region);
  // What is wrong is told in it, too, and so is a link to a task made in it.
  await page.getByTestId("task-open").click();
  await page.getByTestId("task-question").fill("Was ist U?");
  expect(await page.getByTestId("task-link").textContent()).toContain("?lang=de#A=2,1.1,1");
  await page.close();
  const wrong = await load("h=1", { locale: "de" });
  await ready(wrong);
  expect(await wrong.getByTestId("error").textContent()).toContain("l fehlt");
  await wrong.close();
});

test.each([["de", 390], ["fr", 390], ["de", 360], ["fr", 360], ["de", 1280], ["fr", 1280]] as const)("%s fits a width of %d", async (locale, width) => {
  const page = await open(POINT, { locale, viewport: { width, height: width < 1000 ? 700 : 720 }, ...(width < 1000 ? { hasTouch: true, isMobile: true } : {}) });
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(width);
  const cut = await page.evaluate(() => [...document.querySelectorAll<HTMLElement>("button, h2, .stack-bar button")].filter((element) => element.getClientRects().length > 0 && element.scrollWidth > element.clientWidth + 1).map((element) => element.textContent));
  expect(cut).toEqual([]);
  // Nor does a panel cut off what stands in its head, or the columns of its tables.
  const beyond = await page.evaluate(() => [...document.querySelectorAll<HTMLElement>(".panel > header button, .panel th")].filter((element) => element.getClientRects().length > 0 && element.getBoundingClientRect().right > element.closest(".panel")!.getBoundingClientRect().right).map((element) => element.outerHTML));
  expect(beyond).toEqual([]);
  if (width === 1280) for (const id of ["diagram", "sphere", "section"]) expect((await page.getByTestId(id).boundingBox())!.height, id).toBeGreaterThan(150);
  await page.close();
});
