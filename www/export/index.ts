/** Every format in which a match is taken away, by its name. */

import { encodeRecord } from "../record";
import { theme } from "../view/palette";
import { csv } from "./csv";
import { gif, type SceneAt, video } from "./morph";
import { type Draw, png } from "./png";
import { fileName, type Saving, sceneAt } from "./scene";
import { svg } from "./svg";

export type { Draw };

export type Format = "png" | "svg" | "json" | "csv" | "video" | "gif";

export type Saved = {
  readonly blob: Blob;
  readonly name: string;
  /** What is other than was asked for. */
  readonly note?: string;
};

/**
 * `morph` is what the view shows and `draw` how; drawings (SVG) are of the grid. Throws a sentence when the format needs a
 * match and there is none.
 */
export async function saved(saving: Saving, format: Format, morph: number, draw: Draw): Promise<Saved> {
  const colours = theme();
  const at: SceneAt = (part) => sceneAt(saving, part);
  const named = (blob: Blob, extension: string): Saved => ({ blob, name: fileName(saving, extension) });
  const text = (content: string, type: string) => named(new Blob([content], { type }), format);
  switch (format) {
    case "png":
      return named(await png(at(morph), colours, draw), "png");
    case "svg":
      return text(svg(at(morph), colours), "image/svg+xml");
    case "json":
      // A run that is still on its way is no result: its shapes and settings are enough to start it again.
      return text(
        encodeRecord(saving.match?.status.finished ? saving : { ...saving, match: null }),
        "application/json",
      );
    case "csv":
      return text(csv(matchOf(saving).curves), "text/csv");
    case "video": {
      matchOf(saving);
      const film = await video(at, colours, draw);
      if (film) return named(film.blob, film.extension);
      return {
        ...named((await gif(at, colours, draw)).blob, "gif"),
        note: "This browser recorded no video, so the morph is saved as a GIF.",
      };
    }
    case "gif":
      matchOf(saving);
      return named((await gif(at, colours, draw)).blob, "gif");
  }
}

function matchOf({ match }: Saving): NonNullable<Saving["match"]> {
  if (!match) throw new Error("There is no match to save yet; press Match first.");
  return match;
}

/** Hands the file to the browser's downloads. */
export function download({ blob, name }: Saved): void {
  if (blob.size === 0) throw new Error("The file came out empty; try again, or save another format.");
  const address = URL.createObjectURL(blob);
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  // Browsers read the address after the click; a minute is ample.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}
