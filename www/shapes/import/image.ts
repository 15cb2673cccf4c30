/** The page's side of reading a picture: a worker of its own for each, gone when it has answered. */

import { ImportError, type Picture } from "./found";
import type { ImageReply } from "./image.worker";
import ImageWorker from "./image.worker?worker&inline";

export type ReadPicture = {
  readonly picture: Picture;
  readonly preview: ImageBitmap;
  readonly notes: readonly string[];
};

export function readImage(file: Blob): Promise<ReadPicture> {
  const worker = new ImageWorker({ name: "thinshell picture" });
  return new Promise<ReadPicture>((resolve, reject) => {
    worker.onmessage = ({ data }: MessageEvent<ImageReply>) => {
      if ("problem" in data) reject(new ImportError(data.known ? data.problem : undecodable(data.problem)));
      else resolve({ picture: data.picture, preview: data.preview, notes: sizeNote(data) });
    };
    worker.onerror = (event) => reject(new ImportError(undecodable(event.message)));
    worker.postMessage(file);
  }).finally(() => worker.terminate());
}

function sizeNote({ picture, original }: Extract<ImageReply, { picture: Picture }>): readonly string[] {
  if (picture.width === original.width) return [];
  return [
    `The picture of ${original.width} × ${original.height} pixels is read at ${picture.width} × ${picture.height}.`,
  ];
}

function undecodable(why: string): string {
  const reason = why.replace(/\.$/, "");
  return `The picture cannot be decoded (${reason}); it may be damaged or too large. Save it again as PNG, or make it smaller.`;
}
