/** Workers as functions: one of them answers one question after the other, and a newer question of a kind replaces an older. */
import type { Answer, Arguments, Name, Question, Reply } from "./calls";
import moduleUrl from "./generated/bifdiag_web_bg.wasm?url";
import { texts } from "../texts";

/** Somebody asked again before this was answered. */
export class Superseded extends Error {}

/** The module is compiled once and shared by all workers: while it arrives where the server knows its type, and else afterwards. */
let compiled: Promise<WebAssembly.Module> | undefined;
const load = async () => {
  const response = await fetch(moduleUrl);
  if (!response.ok) throw new Error(texts.failure.load(`${response.status} ${response.statusText}`));
  const known = response.headers.get("Content-Type")?.startsWith("application/wasm");
  return known ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
};
export const compile = (): Promise<WebAssembly.Module> =>
  (compiled ??= load().catch((error: unknown) => {
    compiled = undefined;
    throw error;
  }));

interface Waiting {
  question: Question;
  resolve: (value: unknown) => void;
  reject: (error: Error) => void;
}

export class Channel {
  private worker: Worker | undefined;
  /** Whether the worker has the module. */
  private able = false;
  private current: Waiting | undefined;
  private queue: Waiting[] = [];
  private clock: ReturnType<typeof setTimeout> | undefined;
  private next = 0;

  /** `budget`: seconds after which an answer is given up, with a message. */
  constructor(private readonly budget: number) {}

  /** Asks; waits behind other questions. */
  ask<N extends Name>(name: N, ...values: Arguments<N>): Promise<Answer<N>> {
    return new Promise((resolve, reject) => {
      const question = { id: this.next++, name, values };
      this.queue.push({ question, resolve: resolve as (value: unknown) => void, reject });
      this.advance();
    });
  }

  /** Asks; questions of this kind that still wait are dropped. */
  latest<N extends Name>(name: N, ...values: Arguments<N>): Promise<Answer<N>> {
    this.drop((waiting) => waiting.question.name === name);
    return this.ask(name, ...values);
  }

  /** Ends what runs and drops what waits. */
  reset(): void {
    this.drop(() => true);
    if (!this.current) return;
    const { reject } = this.current;
    this.stop();
    reject(new Superseded("no longer needed"));
  }

  private drop(which: (waiting: Waiting) => boolean): void {
    for (const waiting of this.queue.filter(which)) waiting.reject(new Superseded("asked again"));
    this.queue = this.queue.filter((waiting) => !which(waiting));
  }

  private stop(): void {
    clearTimeout(this.clock);
    this.worker?.terminate();
    this.worker = undefined;
    this.able = false;
    this.current = undefined;
  }

  /** Questions wait until the worker has the module, so that of one kind only the latest is answered then. */
  private advance(): void {
    if (this.current || this.queue.length === 0) return;
    if (!this.able || !this.worker) return this.begin();
    this.current = this.queue.shift()!;
    const { question } = this.current;
    this.clock = setTimeout(() => this.giveUp(texts.failure.late(this.budget)), 1000 * this.budget);
    this.worker.postMessage(question);
  }

  /** Starts the worker, whose script loads while the module does. */
  begin(): void {
    if (this.worker) return;
    const worker = (this.worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" }));
    worker.onmessage = ({ data }: MessageEvent<Reply>) => this.settle(data);
    worker.onerror = (event) => this.giveUp(event.message || texts.failure.stopped);
    compile().then(
      (module) => {
        if (this.worker !== worker) return;
        worker.postMessage({ module });
        this.able = true;
        this.advance();
      },
      (error: Error) => this.worker === worker && this.giveUp(error.message),
    );
  }

  private settle(reply: Reply): void {
    const waiting = this.current;
    if (!waiting || waiting.question.id !== reply.id) return;
    clearTimeout(this.clock);
    this.current = undefined;
    if ("error" in reply) {
      if (reply.trapped) this.stop();
      const message = reply.trapped ? texts.failure.trapped(reply.error) : reply.error;
      waiting.reject(new Error(message));
    } else {
      waiting.resolve(reply.value);
    }
    this.advance();
  }

  private giveUp(message: string): void {
    const waiting = this.current ?? this.queue.shift();
    this.stop();
    waiting?.reject(new Error(message));
    this.advance();
  }
}
