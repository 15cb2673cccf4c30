import { isWorking } from "../phase";
import { space as say } from "../words/space";
import { Slide } from "./Slide";
import type { SpaceSession, View } from "./session";
import { VIEWS } from "./session";

/** How the result is looked at. */
export function ViewPicker({ session }: { session: SpaceSession }) {
  return (
    <>
      <select
        class="view-picker"
        aria-label={say.view}
        aria-describedby="view-caption"
        value={session.view.value}
        onChange={(event) => {
          session.view.value = event.currentTarget.value as View;
        }}
      >
        {VIEWS.map((view) => (
          <option key={view} value={view}>
            {say.views[view]}
          </option>
        ))}
      </select>
      <label class="target">
        <input
          type="checkbox"
          checked={session.showsTarget.value}
          onChange={(event) => {
            session.showsTarget.value = event.currentTarget.checked;
          }}
        />
        {say.target}
      </label>
    </>
  );
}

export function PlaneChoice({ session }: { session: SpaceSession }) {
  const { axis, part } = session.plane.value;
  return (
    <div class="morph plane">
      <select
        aria-label={say.plane}
        value={String(axis)}
        onChange={(event) => {
          session.plane.value = { axis: Number(event.currentTarget.value), part };
        }}
      >
        {say.axes.map((name, k) => (
          <option key={name} value={String(k)}>
            {say.plane} {name}
          </option>
        ))}
      </select>
      <Slide
        name={say.at}
        value={part}
        text={say.percent(part)}
        change={(value) => {
          session.plane.value = { axis, part: value };
        }}
      />
    </div>
  );
}

/** The match as it was after each level: what a coarse grid sees, and what a fine one adds. */
export function LevelChoice({ session }: { session: SpaceSession }) {
  const levels = session.levels.value;
  if (levels.length < 2 || isWorking(session.phase.value)) return null;
  const last = levels[levels.length - 1];
  return (
    <label class="morph level">
      <span>{say.after}</span>
      <select
        value={String(session.chosenLevel.value ?? last)}
        onChange={(event) => {
          const level = Number(event.currentTarget.value);
          session.chosenLevel.value = level === last ? null : level;
        }}
      >
        {levels.map((level) => (
          <option key={level} value={String(level)}>
            {say.grid(level)}
          </option>
        ))}
      </select>
    </label>
  );
}
