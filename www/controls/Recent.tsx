import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { reason } from "../link/open";
import { decode, type Saved } from "../link/text";
import type { Kept } from "../memory/sessions";
import type { Session } from "../session";
import { bandwidth, changedFields } from "../settings";
import { PRESETS } from "../shapes/presets";
import { memory as words } from "../words/memory";
import { recent as say } from "../words/recent";
import { adopt } from "./adopt";
import style from "./earlier.css?inline";
import { Thumbnail } from "./Thumbnail";

adopt(style);

/** The sessions that this browser keeps: each can be opened again, and deleted. */
export function Recent({ session }: { session: Session }) {
  const { memory } = session;
  const list = useSignal(read(memory.sessions.list()));
  useEffect(() => {
    const look = () => {
      list.value = read(memory.sessions.list());
    };
    // Other tabs write too.
    addEventListener("storage", look);
    const stop = memory.writes.subscribe(look);
    return () => {
      removeEventListener("storage", look);
      stop();
    };
  }, [memory]);
  if (list.value.length === 0) return <p class="help">{say.none}</p>;
  const remove = (kept: Kept) => {
    memory.sessions.remove(kept.id);
    list.value = read(memory.sessions.list());
  };
  return (
    <>
      <p class="help">{say.help}</p>
      <ul class="earlier" aria-label={words.title}>
        {list.value.map((one) => (
          <Entry key={one.kept.id} session={session} {...one} remove={() => remove(one.kept)} />
        ))}
      </ul>
    </>
  );
}

/** `saved` is a sentence's part where this version of the page cannot read it. */
type Found = { readonly kept: Kept; readonly saved: Saved | string };

function read(list: readonly Kept[]): readonly Found[] {
  return list.map((kept) => {
    try {
      return { kept, saved: decode(kept.text) };
    } catch (error) {
      return { kept, saved: reason(error) };
    }
  });
}

function Entry({ session, kept, saved, remove }: Found & { session: Session; remove: () => void }) {
  const what = titleOf(saved);
  const when = kept.at === 0 ? say.before : say.when(new Date(kept.at));
  const own = kept.id === session.memory.own;
  return (
    <li>
      {typeof saved !== "string" && (
        <button type="button" aria-label={say.open(what, when)} onClick={() => session.openLink(`#${kept.text}`)}>
          <Thumbnail key={kept.text} scene={{ ...saved, match: null, bandwidth: bandwidth(saved.settings) }} />
        </button>
      )}
      <span class="what">
        {what}
        <br />
        {own ? `${when} (${say.own})` : when}
      </span>
      <button type="button" class="quiet" aria-label={say.remove(what, when)} onClick={remove}>
        {say.removeShort}
      </button>
    </li>
  );
}

function titleOf(saved: Found["saved"]): string {
  if (typeof saved === "string") return say.unread(saved);
  const changed = changedFields(saved.settings).length;
  const title = PRESETS.find(({ id }) => id === saved.preset)?.title ?? say.drawn;
  return changed > 0 ? `${title}, ${say.settings(changed)}` : title;
}
