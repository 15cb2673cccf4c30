/** Pictures for the image view: a pattern that shows direction and size, and whatever the user has. */

import { later } from "../words/later";
import { rgbFromOklab } from "./palette";
import type { Picture } from "./raster";

/** Pixels a side: more than the result canvas shows of one. */
export const PICTURE_SIZE = 512;

const FIELDS = 16;

/** Colours that tell where a point comes from, a chessboard that tells how it is sheared, and thin lines. */
export function pattern(): Picture {
  const size = PICTURE_SIZE;
  const data = new Uint8ClampedArray(4 * size * size);
  for (let row = 0; row < size; row += 1) {
    for (let column = 0; column < size; column += 1) {
      const x = (column + 0.5) / size;
      const y = 1 - (row + 0.5) / size;
      const odd = (Math.floor(FIELDS * x) + Math.floor(FIELDS * y)) % 2;
      const line = Math.min(ruled(x), ruled(y)) < 0.03 ? 0.14 : 0;
      const rgb = rgbFromOklab((odd ? 0.76 : 0.62) - line, 0.2 * (x - 0.5), 0.2 * (y - 0.5));
      const at = 4 * (row * size + column);
      for (let k = 0; k < 3; k += 1) data[at + k] = 255 * Math.min(1, Math.max(0, rgb[k]));
      data[at + 3] = 255;
    }
  }
  return { width: size, height: size, data };
}

/** Distance to the nearest line of the chessboard, in its fields. */
function ruled(x: number): number {
  const part = (FIELDS * x) % 1;
  return Math.min(part, 1 - part);
}

/** The whole picture in the middle of the box. Throws a sentence for what is none. */
export async function pictureFrom(file: Blob): Promise<Picture> {
  let bitmap: ImageBitmap;
  try {
    bitmap = await createImageBitmap(file);
  } catch {
    throw new Error(later.pictures.unread);
  }
  const size = PICTURE_SIZE;
  const context = new OffscreenCanvas(size, size).getContext("2d");
  if (!context) throw new Error(later.pictures.canvas);
  const scale = size / Math.max(bitmap.width, bitmap.height);
  const width = bitmap.width * scale;
  const height = bitmap.height * scale;
  context.imageSmoothingQuality = "high";
  context.drawImage(bitmap, (size - width) / 2, (size - height) / 2, width, height);
  bitmap.close();
  const { data } = context.getImageData(0, 0, size, size);
  return { width: size, height: size, data };
}
