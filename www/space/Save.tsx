import { useSignal } from "@preact/signals";
import { fetched } from "../controls/fetched";
import { Menu } from "../controls/Menu";
import { download, type Saved } from "../export/download";
import { files } from "../words/files";
import { space as say } from "../words/space";
import { json, ply } from "./export";
import type { Result, SpaceSession } from "./session";
import { type Scene, Stage } from "./stage";

/** Pixels a side: 20 cm at 300 dots per inch. */
const PRINT_SIDE = 2400;

type Format = keyof typeof say.formats;

type Properties = {
  readonly session: SpaceSession;
  readonly stage: { readonly current: Stage | null };
  /** What the result shows. */
  readonly scene: { peek(): Scene };
};

/** The formats in which a match in space can be taken away. */
export function Save({ session, stage, scene }: Properties) {
  const busy = useSignal(false);
  const saved = async (format: Format): Promise<Saved> => {
    const result = session.result.peek();
    const match = result?.frame.status.finished ? result : null;
    const named = (blob: Blob, extension: string = format) => ({ blob, name: `thinshell-surfaces.${extension}` });
    switch (format) {
      case "png":
        if (!stage.current) throw new Error(say.noWebGl);
        return named(await stage.current.picture(session.pose.peek(), session.morph.peek(), PRINT_SIDE));
      case "ply":
        return named(bytes(ply(matched(match))));
      case "json":
        return named(bytes(json(session.step.peek(), match)));
      default:
        matched(match);
        return film(format, session, scene.peek());
    }
  };
  const save = async (format: Format) => {
    busy.value = true;
    try {
      const file = await saved(format);
      download(file);
      if (file.note) session.problem.value = file.note;
    } catch (error) {
      session.problem.value = say.notSaved(say.formats[format], error instanceof Error ? error.message : String(error));
    } finally {
      busy.value = false;
    }
  };
  const isMatched = session.result.value?.frame.status.finished === true;
  return (
    <Menu kind="save" label={busy.value ? say.saving : say.save} busy={busy.value}>
      {(Object.keys(say.formats) as Format[]).map((format) => (
        <li key={format}>
          <button
            type="button"
            disabled={busy.value || (!isMatched && format !== "png" && format !== "json")}
            onClick={() => void save(format)}
          >
            {say.formats[format]}
          </button>
        </li>
      ))}
    </Menu>
  );
}

function bytes(text: string): Blob {
  return new Blob([text], { type: "application/octet-stream" });
}

function matched(match: Result | null): Result {
  if (!match) throw new Error(say.noMatch);
  return match;
}

/** The way there and back, seen as it is seen now; a GIF where the browser records no video. */
async function film(format: "video" | "gif", session: SpaceSession, scene: Scene): Promise<Saved> {
  const { animated, filmed } = await fetched(say.films, () => import("../export/morph"));
  const stage = new Stage(document.createElement("canvas"));
  try {
    stage.show(scene);
    const paper = getComputedStyle(document.documentElement).getPropertyValue("--canvas") || "#fff";
    const paint = (canvas: HTMLCanvasElement, morph: number) => {
      const context = canvas.getContext("2d", { willReadFrequently: true });
      if (!context) throw new Error(files.noCanvas);
      stage.still(session.pose.peek(), morph, canvas.width);
      context.fillStyle = paper;
      context.fillRect(0, 0, canvas.width, canvas.height);
      context.drawImage(stage.canvas, 0, 0, canvas.width, canvas.height);
      return context;
    };
    const video = format === "video" ? await filmed(paint) : null;
    const made = video ?? (await animated(paint));
    const note = format === "video" && !video ? files.noVideo : undefined;
    return { blob: made.blob, name: `thinshell-surfaces.${made.extension}`, ...(note && { note }) };
  } finally {
    stage.dispose();
  }
}
