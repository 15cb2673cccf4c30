/** Every format in which a match is taken away, by its name. */

import { encodeRecord } from "../record";
import { framing, seenOf } from "../view/framing";
import type { View } from "../view/names";
import { theme } from "../view/palette";
import type { Picture } from "../view/raster";
import { markedScale } from "../view/views";
import { files } from "../words/files";
import { csv } from "./csv";
import type { Saved } from "./download";
import { legendOf, legendSvg } from "./legend";
import { gif, type SceneAt, video } from "./morph";
import { type Draw, png } from "./png";
import { fileName, type Saving, sceneAt } from "./scene";
import { svg } from "./svg";
import { svgOf } from "./svgView";

export { download } from "./download";
export type { Draw, Saved };

export type Format = "png" | "svg" | "json" | "csv" | "video" | "gif";

/** How the match is looked at, and whether pictures and drawings say what their colours mean. */
export type Look = {
  readonly view: View;
  readonly limit: number;
  readonly picture: Picture | null;
  readonly morph: number;
  readonly legend: boolean;
};

/** `draw` draws as the look says. Throws a sentence when the format needs a match and there is none. */
export async function saved(saving: Saving, format: Format, look: Look, draw: Draw): Promise<Saved> {
  const { view, limit, picture, morph } = look;
  const colours = theme();
  const legend = () => {
    const { match, bandwidth, missed } = at(morph);
    const scale = match && markedScale(view, match, bandwidth, limit, colours.dark);
    return legendOf(view, scale, colours, view !== "pullback" && missed !== undefined && missed.length > 0);
  };
  const at: SceneAt = (part) => sceneAt(saving, part);
  const square = framing(seenOf(saving), null, { legend: look.legend });
  const named = (blob: Blob, extension: string): Saved => ({ blob, name: fileName(saving, extension) });
  const text = (content: string, type: string) => named(new Blob([content], { type }), format);
  switch (format) {
    case "png":
      return named(await png(at(morph), square, colours, draw, look.legend ? legend() : null), "png");
    case "svg": {
      const { match, ...scene } = at(morph);
      const words = look.legend ? legendSvg(legend(), colours, square) : "";
      const drawing =
        match && picture && view !== "grid"
          ? await svgOf(
              view,
              { match, morph, bandwidth: scene.bandwidth, limit, picture, missed: scene.missed ?? [] },
              square,
              colours,
              words,
            )
          : svg({ match, ...scene }, square, colours, words);
      return text(drawing, "image/svg+xml");
    }
    case "json":
      // A run that is still on its way is no result: its shapes and settings are enough to start it again.
      return text(
        encodeRecord(saving.match?.status.finished ? saving : { ...saving, match: null }),
        "application/json",
      );
    case "csv":
      return text(csv(needed(saving).curves), "text/csv");
    case "video": {
      needed(saving);
      const film = await video(at, square, colours, draw);
      if (film) return named(film.blob, film.extension);
      return {
        ...named((await gif(at, square, colours, draw)).blob, "gif"),
        note: files.noVideo,
      };
    }
    case "gif":
      needed(saving);
      return named((await gif(at, square, colours, draw)).blob, "gif");
  }
}

function needed({ match }: Saving): NonNullable<Saving["match"]> {
  if (!match) throw new Error(files.noMatch);
  return match;
}
