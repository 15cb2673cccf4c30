/**
 * The page's side of reading: what a file is, judged by its content and not by its name, and a worker for each that
 * reads it and prepares shapes of it. Ending the worker ends whatever it does.
 */

import type { Offer, Outcome, Selection } from "./content";
import { type FoundShapes, ImportError } from "./found";
import type { ReaderReply, ReaderRequest } from "./import.worker";
import ImportWorker from "./import.worker?worker&inline";
import { kindOf, textIn } from "./kind";
import { drawingMeanwhile } from "./svgDrawing";

export type Read =
  | { readonly kind: "offer"; readonly offer: Offer; readonly preview: ImageBitmap | null }
  /** JSON that this page has saved: to be read by whoever knows about matches. */
  | { readonly kind: "saved"; readonly content: unknown };

/** Larger files than these are no outlines. */
const MOST_TEXT = 40e6;
const MOST_PICTURE = 400e6;

const NO_WORKER =
  "The import could not be started or ran out of memory, because the browser ended the page's worker. Close other pages or take a smaller file; let the page's security policy allow “worker-src blob:”.";

type Settle<T> = { resolve(value: T): void; reject(problem: Error): void };

export class Reader {
  private worker: Worker | null = null;
  private aborting = new AbortController();
  private reading: Settle<Read> | null = null;
  private preparing: (Settle<Outcome> & { readonly number: number }) | null = null;
  private number = 0;
  private readonly report: (done: number) => void;

  /** `report` is told the part of a reading that is done, where that is known. */
  constructor(report: (done: number) => void) {
    this.report = report;
  }

  /** Ends what was being read before. Rejects with an `ImportError` for whatever cannot be taken. */
  async read(input: Blob | string | FoundShapes): Promise<Read> {
    this.stop();
    const { signal } = this.aborting;
    const request = await requestFor(input, signal);
    signal.throwIfAborted();
    return new Promise((resolve, reject) => {
      this.reading = { resolve, reject };
      this.spawn().postMessage(request);
    });
  }

  /** What has been read last, as a shape. Of several under way only the last is answered; the others stay pending. */
  prepare(wishes: Selection): Promise<Outcome> {
    this.number += 1;
    const { number } = this;
    return new Promise((resolve, reject) => {
      this.preparing = { number, resolve, reject };
      this.worker?.postMessage({ kind: "prepare", number, wishes } satisfies ReaderRequest);
    });
  }

  /** Whatever is under way is never answered. */
  stop(): void {
    this.aborting.abort();
    this.aborting = new AbortController();
    this.worker?.terminate();
    this.worker = null;
    this.reading = null;
    this.preparing = null;
  }

  private spawn(): Worker {
    let worker: Worker;
    try {
      worker = new ImportWorker({ name: "thinshell import" });
    } catch {
      throw new ImportError(NO_WORKER);
    }
    this.worker = worker;
    worker.onmessage = ({ data }: MessageEvent<ReaderReply>) => this.receive(data);
    worker.onerror = (event) => {
      event.preventDefault();
      this.fail(new ImportError(NO_WORKER));
    };
    return worker;
  }

  private receive(reply: ReaderReply): void {
    switch (reply.kind) {
      case "progress":
        this.report(reply.done);
        break;
      case "read":
        this.reading?.resolve({ kind: "offer", offer: reply.offer, preview: reply.preview });
        this.reading = null;
        break;
      case "saved":
        this.reading?.resolve(reply);
        this.reading = null;
        break;
      case "prepared":
        if (this.preparing?.number !== reply.number) return;
        this.preparing.resolve(reply.outcome);
        this.preparing = null;
        break;
      case "refused":
        this.fail(new ImportError(reply.message));
    }
  }

  private fail(problem: ImportError): void {
    const { reading, preparing } = this;
    this.stop();
    reading?.reject(problem);
    preparing?.reject(problem);
  }
}

async function requestFor(input: Blob | string | FoundShapes, signal: AbortSignal): Promise<ReaderRequest> {
  if (typeof input === "string") return requestForText(input, signal);
  if (!(input instanceof Blob)) return { kind: "found", found: input };
  if (input.size === 0) throw new ImportError("The file is empty.");
  const bytes = await input
    .slice(0, 64)
    .arrayBuffer()
    .catch(() => {
      throw new ImportError("The file cannot be read; it may be a folder, or gone. Choose it again.");
    });
  const kind = kindOf(String.fromCharCode(...new Uint8Array(bytes)));
  if (typeof kind === "object") throw new ImportError(kind.refusal);
  if (kind === "picture") {
    if (input.size > MOST_PICTURE) throw new ImportError("The picture has more than 400 MB; make it smaller.");
    return { kind: "picture", file: input };
  }
  if (input.size > MOST_TEXT) throw new ImportError("The file has more than 40 MB; simplify the drawing first.");
  return requestForText(await input.text(), signal);
}

async function requestForText(text: string, signal: AbortSignal): Promise<ReaderRequest> {
  const { kind, text: given } = textIn(text);
  return kind === "text" ? { kind, text: given } : { kind, drawing: await drawingMeanwhile(given, signal) };
}
