/** Reads what is imported and prepares shapes of it, away from the page: either may take seconds. */

import { Content, type Offer, type Outcome, type Selection } from "./content";
import { type Found, type FoundShapes, ImportError } from "./found";
import { pictureFrom } from "./ink";
import { readText } from "./read";
import { shapesOf } from "./svg";
import type { Drawing } from "./svgDrawing";

/** Longest side of the small picture in pixels: a few for each cell of the finest grid. */
const SIDE = 640;

export type ReaderRequest =
  | { readonly kind: "picture"; readonly file: Blob }
  /** Anything but SVG, which only the page can parse. */
  | { readonly kind: "text"; readonly text: string }
  | { readonly kind: "drawing"; readonly drawing: Drawing }
  | { readonly kind: "found"; readonly found: FoundShapes }
  | { readonly kind: "prepare"; readonly number: number; readonly wishes: Selection };

export type ReaderReply =
  | { readonly kind: "progress"; readonly done: number }
  | { readonly kind: "read"; readonly offer: Offer; readonly preview: ImageBitmap | null }
  | { readonly kind: "saved"; readonly content: unknown }
  | { readonly kind: "prepared"; readonly number: number; readonly outcome: Outcome }
  | { readonly kind: "refused"; readonly message: string };

let content: Content | null = null;

self.onmessage = async ({ data }: MessageEvent<ReaderRequest>) => {
  try {
    await answer(data);
  } catch (error) {
    post({ kind: "refused", message: error instanceof Error ? error.message : String(error) });
  }
};

async function answer(request: ReaderRequest): Promise<void> {
  switch (request.kind) {
    case "picture": {
      const { picture, preview, notes } = await readPicture(request.file);
      offer({ kind: "picture", picture, notes }, preview);
      break;
    }
    case "text":
      offer(readText(request.text));
      break;
    case "drawing":
      offer(shapesOf(request.drawing, (done) => post({ kind: "progress", done })));
      break;
    case "found":
      offer(request.found);
      break;
    case "prepare":
      if (content) post({ kind: "prepared", number: request.number, outcome: content.outcome(request.wishes) });
  }
}

function offer(found: Found, preview: ImageBitmap | null = null): void {
  if (found.kind === "saved") {
    post({ kind: "saved", content: found.content });
    return;
  }
  content = new Content(found);
  post({ kind: "read", offer: content.offer, preview }, preview ? [preview] : []);
}

async function readPicture(file: Blob) {
  const whole = await createImageBitmap(file).catch((error) => {
    const why = error instanceof Error ? error.message.replace(/\.$/, "") : String(error);
    throw new ImportError(
      `The picture cannot be decoded (${why}); it may be damaged or too large. Save it again as PNG, or make it smaller.`,
    );
  });
  const original = { width: whole.width, height: whole.height };
  const factor = Math.min(1, SIDE / Math.max(whole.width, whole.height));
  const width = Math.max(1, Math.round(factor * whole.width));
  const height = Math.max(1, Math.round(factor * whole.height));
  const preview =
    factor < 1
      ? await createImageBitmap(whole, { resizeWidth: width, resizeHeight: height, resizeQuality: "high" })
      : whole;
  const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
  if (!context) throw new ImportError("This browser gives no canvas to read pictures with; use a current one.");
  context.drawImage(preview, 0, 0);
  if (preview !== whole) whole.close();
  const picture = pictureFrom(context.getImageData(0, 0, width, height).data, width, height);
  const notes =
    factor < 1 ? [`The picture of ${original.width} × ${original.height} pixels is read at ${width} × ${height}.`] : [];
  return { picture, preview, notes };
}

function post(reply: ReaderReply, transfer: Transferable[] = []): void {
  self.postMessage(reply, { transfer });
}
