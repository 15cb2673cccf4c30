import { useSignal } from "@preact/signals";
import type { Draw, Format } from "../export";
import type { Session } from "../session";
import { bandwidth } from "../settings";
import { embed as frames } from "../words/embed";
import { en } from "../words/en";
import { save as words } from "../words/save";
import { fetched } from "./fetched";
import { Menu } from "./Menu";
import { draw, limitOf, picture, view } from "./viewing";

const FORMATS: readonly { readonly format: Format; readonly needsMatch: boolean }[] = (
  ["png", "svg", "json", "csv", "video", "gif"] as const
).map((format) => ({ format, needsMatch: format === "csv" || format === "video" || format === "gif" }));

/** The formats in which a match can be taken away. */
export function Save({ session }: { session: Session }) {
  const busy = useSignal(false);
  const legend = useSignal(false);

  const save = async (format: Format) => {
    busy.value = true;
    try {
      const { saved, download } = await fetched(en.missing.files, () => import("../export"));
      const result = session.result.value;
      const match = result?.frame ?? null;
      const present = { ...session.shapes.value, settings: session.settings.value };
      // A match with what it was computed from; a run that is still on its way is no result.
      const inputs = result && (match?.status.finished || format !== "json") ? result : present;
      const width = bandwidth(inputs.settings);
      const { reference, template, pins, settings } = inputs;
      const saving = { reference, template, pins, settings, bandwidth: width, match };
      const limit = limitOf(match && { ...match, level: match.status.level }, width);
      const drawn: Draw = (context, frame, colours, scene) => draw(context, frame, colours, scene, limit);
      const look = {
        view: view.value,
        limit,
        picture: picture.value,
        morph: session.morph.value,
        legend: legend.value,
      };
      const file = await saved(saving, format, look, drawn);
      download(file);
      if (file.note) session.problem.value = file.note;
    } catch (error) {
      const why = error instanceof Error ? error.message : String(error);
      session.problem.value = words.failed(words.formats[format], why);
    } finally {
      busy.value = false;
    }
  };

  const embed = async () => {
    try {
      const { ask } = await fetched(frames.what, () => import("../embed/Dialog"));
      ask(session);
    } catch (error) {
      session.problem.value = error instanceof Error ? error.message : String(error);
    }
  };

  const matched = session.result.value !== null;
  return (
    <Menu kind="save" label={busy.value ? words.busy : words.name} busy={busy.value}>
      {FORMATS.map(({ format, needsMatch }) => (
        <li key={format}>
          <button type="button" disabled={busy.value || (needsMatch && !matched)} onClick={() => save(format)}>
            {words.formats[format]}
          </button>
        </li>
      ))}
      <li>
        <label>
          <input
            type="checkbox"
            checked={legend.value}
            onChange={(event) => {
              legend.value = event.currentTarget.checked;
            }}
          />
          {words.legend}
        </label>
      </li>
      <li>
        <button type="button" onClick={embed}>
          {frames.begin}
        </button>
      </li>
    </Menu>
  );
}
