import { space as say } from "../words/space";
import { ACCEPTED } from "./files";
import { SURFACES, surface } from "./gallery";
import type { Side, SpaceSession } from "./session";
import type { Ways } from "./ways";

type Properties = { readonly session: SpaceSession; readonly ways: Ways };

/** The gallery of one side, and files. */
export function Source({ session, ways, side }: Properties & { side: Side }) {
  const solid = session.step.value[side];
  return (
    <div class="source">
      <select
        aria-label={say.choose(side)}
        value={solid.id}
        onChange={(event) => {
          const chosen = surface(event.currentTarget.value);
          if (chosen) session.commit({ [side]: chosen });
        }}
      >
        {!surface(solid.id) && <option value={solid.id}>{solid.name}</option>}
        {SURFACES.map(({ id, name }) => (
          <option key={id} value={id}>
            {name}
          </option>
        ))}
      </select>
      <label class="as-button">
        {say.file}
        <input
          type="file"
          class="unseen"
          accept={ACCEPTED}
          aria-label={say.open(side)}
          onChange={(event) => {
            const [file] = event.currentTarget.files ?? [];
            if (file) void ways.take(side, file);
            // The same file may be chosen again.
            event.currentTarget.value = "";
          }}
        />
      </label>
    </div>
  );
}
