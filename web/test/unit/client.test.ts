/** Questions to a worker: the latest wins, and what hangs or breaks ends in a message and a new worker. */
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { Question, Reply } from "../../src/bindings/calls";
import { Channel, Superseded } from "../../src/bindings/client";

/** What the worker does with a question: a reply, or nothing at all. */
let answer: (question: Question) => Reply | undefined;
let started = 0;
let ended = 0;

class FakeWorker {
  onmessage: ((event: { data: Reply }) => void) | undefined;
  onerror: unknown;
  private over = false;
  constructor() {
    started++;
  }
  postMessage(message: Question | { module: unknown }): void {
    if ("module" in message) return;
    const reply = answer(message);
    if (reply) setTimeout(() => this.over || this.onmessage?.({ data: reply }), 1);
  }
  terminate(): void {
    this.over = true;
    ended++;
  }
}

const EMPTY = new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0]);

beforeEach(() => {
  started = ended = 0;
  vi.stubGlobal("Worker", FakeWorker);
  vi.stubGlobal("fetch", async () => new Response(EMPTY));
});
afterEach(() => vi.unstubAllGlobals());

const echo = ({ id, values }: Question): Reply => ({ id, value: values[0] });

test("answers come in the order of the questions, from one worker", async () => {
  answer = echo;
  const channel = new Channel(5);
  expect(await Promise.all([channel.ask("atlas", "a"), channel.ask("atlas", "b")])).toEqual(["a", "b"]);
  expect(started).toBe(1);
});

test("of those that wait the latest of a kind is answered", async () => {
  answer = echo;
  const channel = new Channel(5);
  await channel.ask("atlas", "0");
  const [first, second, third] = ["1", "2", "3"].map((body) => channel.latest("atlas", body));
  await expect(second).rejects.toBeInstanceOf(Superseded);
  expect([await first, await third]).toEqual(["1", "3"]);
});

test("while the module loads nothing is asked, and then only the latest of a kind", async () => {
  const asked: unknown[] = [];
  answer = (question) => (asked.push(question.values[0]), echo(question));
  const channel = new Channel(5);
  channel.begin();
  const [first, second] = ["1", "2"].map((body) => channel.latest("atlas", body));
  await expect(first).rejects.toBeInstanceOf(Superseded);
  expect([await second, asked, started]).toEqual(["2", ["2"], 1]);
});

test("a module that could not be loaded is told, and asked for again with the next question", async () => {
  answer = echo;
  vi.resetModules();
  await (await import("../../src/texts")).speak("en");
  const { Channel } = await import("../../src/bindings/client");
  vi.stubGlobal("fetch", async () => new Response(null, { status: 503, statusText: "Busy" }));
  const channel = new Channel(5);
  await expect(channel.ask("atlas", "a")).rejects.toThrow("the program could not be loaded: 503 Busy");
  vi.stubGlobal("fetch", async () => new Response(EMPTY));
  expect(await channel.ask("atlas", "b")).toBe("b");
});

test("what takes too long ends in a message, and the next question has a new worker", async () => {
  answer = (question) => (question.values[0] === "long" ? undefined : echo(question));
  const channel = new Channel(0.05);
  const [long, next] = [channel.ask("atlas", "long"), channel.ask("atlas", "next")];
  await expect(long).rejects.toThrow("no answer within 0.05 seconds");
  expect(await next).toBe("next");
  expect([started, ended]).toEqual([2, 1]);
});

test("after a trap a new worker answers; after a wrong question the old one", async () => {
  answer = ({ id, values }) => ({ id, error: "unreachable", trapped: values[0] === "trap" });
  const channel = new Channel(5);
  await expect(channel.ask("atlas", "wrong")).rejects.toThrow(/^unreachable$/);
  expect(ended).toBe(0);
  await expect(channel.ask("atlas", "trap")).rejects.toThrow("failed on this question (unreachable) and was restarted");
  expect(ended).toBe(1);
  answer = echo;
  expect(await channel.ask("atlas", "after")).toBe("after");
  expect(started).toBe(2);
});

test("what is no longer needed ends at once", async () => {
  answer = () => undefined;
  const channel = new Channel(5);
  const [running, waiting] = [channel.ask("atlas", "a"), channel.ask("atlas", "b")];
  await new Promise((after) => setTimeout(after, 20));
  channel.reset();
  await expect(running).rejects.toBeInstanceOf(Superseded);
  await expect(waiting).rejects.toBeInstanceOf(Superseded);
  expect(ended).toBe(1);
});
