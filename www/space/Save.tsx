import { Menu } from "../controls/Menu";
import { download } from "../export/download";
import { space as say } from "../words/space";
import { json, ply } from "./export";
import type { SpaceSession } from "./session";
import type { Stage } from "./stage";

/** Pixels a side: 20 cm at 300 dots per inch. */
const PRINT_SIDE = 2400;

type Format = keyof typeof say.formats;

export function Save({ session, stage }: { session: SpaceSession; stage: { readonly current: Stage | null } }) {
  const save = async (format: Format) => {
    try {
      const result = session.result.peek();
      const match = result?.frame.status.finished ? result : null;
      if (format === "ply" && !match) throw new Error(say.noMatch);
      const name = `thinshell-surfaces.${format}`;
      if (format === "png") {
        if (!stage.current) throw new Error(say.noWebGl);
        download({ blob: await stage.current.picture(session.pose.peek(), session.morph.peek(), PRINT_SIDE), name });
      } else {
        const text = format === "ply" && match ? ply(match) : json(session.step.peek(), match);
        download({ blob: new Blob([text], { type: "application/octet-stream" }), name });
      }
    } catch (error) {
      session.problem.value = say.notSaved(say.formats[format], error instanceof Error ? error.message : String(error));
    }
  };
  const matched = session.result.value?.frame.status.finished === true;
  return (
    <Menu kind="save" label={say.save}>
      {(Object.keys(say.formats) as Format[]).map((format) => (
        <li key={format}>
          <button type="button" disabled={format === "ply" && !matched} onClick={() => void save(format)}>
            {say.formats[format]}
          </button>
        </li>
      ))}
    </Menu>
  );
}
