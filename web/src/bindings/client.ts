/** Workers as functions: one of them answers one question after the other, and a newer question of a kind replaces an older. */
import type { Answer, Arguments, Name, Question, Reply } from "./calls";
import moduleUrl from "./generated/bifdiag_web_bg.wasm?url";

/** Somebody asked again before this was answered. */
export class Superseded extends Error {}

/** The module is compiled once and shared by all workers: while it arrives where the server knows its type, and else afterwards. */
let compiled: Promise<WebAssembly.Module> | undefined;
const compile = () =>
  (compiled ??= fetch(moduleUrl).then(async (response) => {
    if (!response.ok) throw new Error(`the program could not be loaded: ${response.status} ${response.statusText}`);
    const known = response.headers.get("Content-Type")?.startsWith("application/wasm");
    return known ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
  }));

interface Waiting {
  question: Question;
  resolve: (value: unknown) => void;
  reject: (error: Error) => void;
}

export class Channel {
  private worker: Worker | undefined;
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
    this.current = undefined;
  }

  private advance(): void {
    if (this.current || this.queue.length === 0) return;
    this.current = this.queue.shift()!;
    const { question } = this.current;
    this.clock = setTimeout(() => this.giveUp(`no answer within ${this.budget} seconds`), 1000 * this.budget);
    this.start().then(
      (worker) => this.current?.question === question && worker.postMessage(question),
      (error: Error) => this.giveUp(error.message),
    );
  }

  private async start(): Promise<Worker> {
    if (this.worker) return this.worker;
    // Its script loads while the module does. Nobody else asks before it has the module: one question after the other.
    const worker = (this.worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" }));
    worker.onmessage = ({ data }: MessageEvent<Reply>) => this.settle(data);
    worker.onerror = (event) => this.giveUp(event.message || "the worker stopped");
    worker.postMessage({ module: await compile() });
    return worker;
  }

  private settle(reply: Reply): void {
    const waiting = this.current;
    if (!waiting || waiting.question.id !== reply.id) return;
    clearTimeout(this.clock);
    this.current = undefined;
    if ("error" in reply) {
      if (reply.trapped) this.stop();
      const message = reply.trapped ? `the program failed on this question (${reply.error}) and was restarted` : reply.error;
      waiting.reject(new Error(message));
    } else {
      waiting.resolve(reply.value);
    }
    this.advance();
  }

  private giveUp(message: string): void {
    const waiting = this.current;
    this.stop();
    waiting?.reject(new Error(message));
    this.advance();
  }
}
