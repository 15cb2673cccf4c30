/** Decodes a picture and makes it small, away from the page: fifty megapixels take seconds. */

import type { Picture } from "./found";
import { pictureFrom } from "./ink";

/** Longest side of the small picture in pixels: a few for each cell of the finest grid. */
const SIDE = 640;

export type ImageReply =
  | { readonly picture: Picture; readonly preview: ImageBitmap; readonly original: { width: number; height: number } }
  | { readonly problem: string; readonly known: boolean };

self.onmessage = async ({ data }: MessageEvent<Blob>) => {
  try {
    const whole = await createImageBitmap(data);
    const original = { width: whole.width, height: whole.height };
    const factor = Math.min(1, SIDE / Math.max(whole.width, whole.height));
    const width = Math.max(1, Math.round(factor * whole.width));
    const height = Math.max(1, Math.round(factor * whole.height));
    const small =
      factor < 1
        ? await createImageBitmap(whole, { resizeWidth: width, resizeHeight: height, resizeQuality: "high" })
        : whole;
    const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
    if (!context) throw new Error("this browser gives no canvas to read pictures with");
    context.drawImage(small, 0, 0);
    if (small !== whole) whole.close();
    const { data: pixels } = context.getImageData(0, 0, width, height);
    const picture = pictureFrom(pixels, width, height);
    const reply: ImageReply = { picture, preview: small, original };
    self.postMessage(reply, { transfer: [picture.ink.buffer as ArrayBuffer, small] });
  } catch (error) {
    const problem = error instanceof Error ? error.message : String(error);
    const known = error instanceof Error && error.name === "ImportError";
    self.postMessage({ problem, known } satisfies ImageReply);
  }
};
