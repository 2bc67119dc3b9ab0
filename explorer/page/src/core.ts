// The core in a worker: requests go in as JSON, replies come out. Of the requests of one channel only the newest waits; those
// of views that are not shown wait for all others, and while the page is hidden all of them do. As long as one of them is
// under way the page is marked as busy. A long reply can be read in the worker, which holds up no frame: `isLong`.

import { views, type View } from "./state.ts";

/** What explorer_core.js defines: a function whose text runs in the worker, and its WebAssembly, zipped, in base64. */
declare const microslipCore: ((...args: unknown[]) => unknown) | undefined;
declare const microslipWasm: string;

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };
export interface Request { call: string; case?: string; files?: Record<string, string>; [key: string]: unknown }
export interface Reply<Result> { result?: Result; error?: { message: string }; time?: number }

interface Waiting { request: Request; isLong: boolean; done: (reply: Reply<never>) => void }

/** A program of one import, one export and no code but v128.const: valid where there are vector instructions. */
const vectorProgram = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11,
]);

/** Vector instructions and exceptions, which explorer_core.js is compiled to. */
export function hasVectors(): boolean {
  return typeof WebAssembly === "object" && "Tag" in WebAssembly && WebAssembly.validate(vectorProgram);
}

export function loadScript(name: string): Promise<void> {
  return new Promise((resolve, reject) => {
    const script = document.createElement("script");
    script.src = name;
    script.onload = () => { resolve(); };
    script.onerror = () => { reject(new Error(`${name} is missing beside this page`)); };
    document.head.append(script);
  });
}

function workerText(): string {
  return `"use strict";
async function unzipped(letters) {
  const binary = atob(letters), bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}
/** A reply whose longer lists of numbers are arrays of one type, which are handed over without a copy. */
function packed(value, buffers) {
  if (value === null || typeof value !== "object") return value;
  if (Array.isArray(value) && value.length > 64 && typeof value[0] === "number") {
    const numbers = Float64Array.from(value);
    buffers.push(numbers.buffer);
    return numbers;
  }
  for (const key of Object.keys(value)) value[key] = packed(value[key], buffers);
  return value;
}
const core = unzipped("${microslipWasm}").then((wasmBinary) => (${String(microslipCore)})({ wasmBinary }));
onmessage = async ({ data }) => {
  try {
    const made = await core;
    if (data.put) { made.put(data.put, data.bytes); postMessage("{}"); }
    else if (data.isLong) {
      const buffers = [], reply = packed(JSON.parse(made.answer(data.request)), buffers);
      postMessage(reply, buffers);
    }
    else postMessage(made.answer(data.request));
  } catch (error) {
    postMessage(JSON.stringify({ error: { message: String(error && error.message || error) } }));
  }
};`;
}

export class Core {
  #worker: Worker | undefined; // once its script is there; until then requests wait
  readonly #waiting = new Map<string, Waiting>();
  #running: ((reply: Reply<never>) => void) | undefined;
  /** The view that is seen, whose requests go first. */
  shown: View = "rail";

  constructor() {
    document.addEventListener("visibilitychange", () => { this.#next(); });
  }

  /** Loads it, and begins with what has been asked meanwhile. */
  async start(): Promise<void> {
    if (typeof WebAssembly !== "object") throw new Error("this browser has no WebAssembly, which the computation needs");
    await loadScript(hasVectors() ? "explorer_core.js" : "explorer_core_plain.js");
    this.#worker = new Worker(URL.createObjectURL(new Blob([workerText()], { type: "text/javascript" })));
    this.#worker.onmessage = ({ data }: MessageEvent<string | Reply<never>>) => { this.#finish(typeof data === "string" ? JSON.parse(data) as Reply<never> : data); };
    this.#worker.onerror = (event) => { this.#finish({ error: { message: event.message || "the core has stopped" } }); };
    this.#next();
  }

  /** The reply, or undefined if a newer request of the same channel replaced this one before it began. Channels of a view begin with its name. */
  ask<Result>(channel: string, request: Request, isLong = false): Promise<Reply<Result> | undefined> {
    return new Promise((resolve) => {
      this.#waiting.get(channel)?.done(undefined as never);
      this.#waiting.delete(channel); // and to the end of the queue
      this.#waiting.set(channel, { request, isLong, done: resolve as (reply: Reply<never>) => void });
      this.#next();
    });
  }

  /** A binary file beside the case. Between requests only. */
  put(name: string, bytes: Uint8Array): Promise<unknown> {
    return new Promise((resolve) => {
      const start = () => {
        if (this.#running || !this.#worker) { setTimeout(start, 5); return; }
        this.#running = resolve;
        this.#worker.postMessage({ put: name, bytes });
      };
      start();
    });
  }

  #markBusy(): void {
    document.body.ariaBusy = String(this.#running !== undefined || this.#waiting.size > 0);
  }

  #next(): void {
    this.#startNext();
    this.#markBusy();
  }

  #startNext(): void {
    if (this.#running || !this.#worker || document.hidden) return;
    const isOfOther = (channel: string) => views.some((view) => view !== this.shown && channel.startsWith(`${view} `));
    const all = [...this.#waiting], first = all.find(([channel]) => !isOfOther(channel)) ?? all[0];
    if (!first) return;
    const [channel, { request, isLong, done }] = first;
    this.#waiting.delete(channel);
    this.#running = done;
    this.#worker.postMessage({ request: JSON.stringify(request), isLong });
  }

  #finish(reply: Reply<never>): void {
    const done = this.#running;
    this.#running = undefined;
    done?.(reply);
    this.#next();
  }
}
