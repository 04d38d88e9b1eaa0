/** The page says what the command line says. */
import { expect, test } from "vitest";
import type { Atlas, Classification } from "../../src/bindings/documents";
import { signatureOf } from "../../src/state/signature";
import { bifdiag, bodies, hashOf, optionsOf } from "../program";
import { data, go, open, ready, serve } from "./open";

serve();

const BODIES = Number(process.env.BODIES ?? 100);

test(`atlases of ${BODIES} bodies are the command line's, byte for byte, and so are the rows of the table`, async () => {
  const page = await open("");
  for (const body of bodies(BODIES)) {
    // One orbit: the page chooses a point, and its section is not asked for here.
    await go(page, `${hashOf(body)}&orbits=1`);
    const text = bifdiag(...optionsOf(body), "--json");
    expect(await page.evaluate(() => window.bifdiag.atlas()), hashOf(body)).toBe(text);
    const rows = await page.getByTestId("region-row").evaluateAll((rows) => rows.map((row) => [row.dataset.region, row.dataset.signature]));
    expect(rows).toEqual((JSON.parse(text) as Atlas).regions.map(({ id, signature }) => [id, signature ?? ""]));
  }
  await page.close();
}, 600_000);

test.each([
  ["2,1.1,1", "0.94868,0,0.61623", "3.8", "3.25", "regular"],
  ["2,1.1,1", "0.94868,0,0.61623", "-5", "1", "forbidden"],
  ["2,1,1", "1,0,0", "2", "2", "critical"],
  ["2,1.5,1", "0,0,0", "0.6", "1", "regular"],
])("A = %s, r = %s at h = %s, l = %s is %s", async (A, r, h, l, status) => {
  const page = await open(`${hashOf({ A, r })}&h=${h}&l=${l}`);
  const found = JSON.parse(bifdiag("classify", ...optionsOf({ A, r }), `--h=${h}`, `--l=${l}`, "--json")) as Classification;
  expect(found.status).toBe(status);
  expect(await data(page, "point-status", "status")).toBe(status);
  expect(await data(page, "point-signature", "signature")).toBe(signatureOf(found.components));
  if (status === "regular") expect(await data(page, "point-region", "region")).toMatch(/^R\d+$/);
  else expect(await data(page, "point-region", "region")).toBe("");
  await page.close();
});

test("a row of the table goes to the region's sample, which lies in the region", async () => {
  const page = await open("A=2,1.1,1&r=0.94868,0,0.61623");
  await page.getByTestId("region-row").nth(6).click();
  await page.waitForFunction(() => document.documentElement.dataset.ready === "false" || location.hash.includes("h="));
  await ready(page);
  expect(await data(page, "point-region", "region")).toBe("R7");
  await page.close();
});
