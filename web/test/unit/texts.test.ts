/** Three languages: each has every text, and no text stands anywhere else. */
import { readFileSync, readdirSync } from "node:fs";
import path from "node:path";
import { parseSync } from "vite";
import { expect, test } from "vitest";
import { LESSONS } from "../../src/guide/lessons";
import { STORY } from "../../src/guide/scenes";
import { TOUR } from "../../src/guide/tour";
import { LANGUAGES, wanted } from "../../src/texts";

const SRC = path.resolve(import.meta.dirname, "../../src");
const NAMES = Object.keys(LANGUAGES);

/** Paths of all texts, with how many each list has; of texts that are made, how many parts they take. */
function shape(value: unknown, at = ""): string[] {
  if (typeof value === "function") return [`${at}(${value.length})`];
  if (typeof value === "object" && value) return [...(Array.isArray(value) ? [`${at}[${value.length}]`] : []), ...Object.entries(value).flatMap(([name, inner]) => shape(inner, `${at}.${name}`))];
  return [at];
}

const strings = (value: unknown): string[] => (typeof value === "string" ? [value] : typeof value === "object" && value ? Object.values(value).flatMap(strings) : []);

test.each(["page", "guide"])("each language has all texts of the %s", async (file) => {
  const [english, ...others] = await Promise.all(NAMES.map(async (name) => (await import(`../../src/texts/${name}/${file}.ts`)).default as unknown));
  for (const [i, other] of others.entries()) {
    expect(shape(other), NAMES[i + 1]).toEqual(shape(english));
    // Sentences are translated: none is the English one.
    const same = strings(other).filter((text, k) => text === strings(english)[k] && /[a-z]+ [a-z]+ [a-z]+/.test(text));
    expect(same, NAMES[i + 1]).toEqual([]);
    expect(strings(other).filter((text, k) => text === "" && strings(english)[k] !== "")).toEqual([]);
  }
});

test("what the guides show has its words", async () => {
  const { default: words } = await import("../../src/texts/en/guide");
  expect([words.tour.length, words.story.length]).toEqual([TOUR.length, STORY.length]);
  expect(words.lessons.map(({ tasks }) => tasks.length)).toEqual(LESSONS.map(({ tasks }) => tasks.length));
});

test("the language of the address comes before the browser's", () => {
  expect([wanted("?lang=fr", ["de"]), wanted("", ["pt-BR", "de-CH", "fr"]), wanted("?lang=it", []), wanted("?lang=", ["en-GB"])]).toEqual(["fr", "de", "en", "en"]);
});

/** What is no text for a reader: fonts, names of classes and keys of style, media, and what is written into files. */
const NO_TEXT = [/\d+px /, /^[a-z0-9+-]+( [a-z0-9-]+)*:? ?$/, /prefers-/, /^(Superseded|import bifdiag|bifdiag )/, /fused multiply-add/, /^"?>?<[a-z!]/, /^Ixy = /];
/** On the worker's side there are no texts. */
const WORKER = new Set(["bindings/worker.ts"]);

type Node = { type: string; [key: string]: unknown };

/** All texts of a program, but not what it imports. */
function literals(node: unknown): string[] {
  if (Array.isArray(node)) return node.flatMap(literals);
  if (typeof node !== "object" || !node) return [];
  const { type, value, source, ...rest } = node as Node;
  if (type === "Literal") return typeof value === "string" ? [value] : [];
  if (type === "TemplateElement") return [(value as { cooked: string }).cooked];
  if (type.startsWith("Import") || type.startsWith("TS")) return [];
  return [value, type.startsWith("Export") ? null : source, ...Object.values(rest)].flatMap(literals);
}

test("no text stands outside of the files of texts", () => {
  const found: string[] = [];
  let seen = 0;
  for (const file of readdirSync(SRC, { recursive: true, encoding: "utf8" })) {
    if (!file.endsWith(".ts") || file.startsWith("texts") || file.includes("generated") || file.endsWith("schema.ts") || WORKER.has(file)) continue;
    const texts = literals(parseSync(file, readFileSync(path.join(SRC, file), "utf8")).program.body);
    seen += texts.length;
    for (const text of texts) if (/[A-Za-z]{2,} [a-z]{2,}/.test(text) && !NO_TEXT.some((sign) => sign.test(text))) found.push(`${file}: ${text}`);
  }
  expect(seen).toBeGreaterThan(1000);
  expect(found).toEqual([]);
});
