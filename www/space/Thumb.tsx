import { signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { surface } from "./gallery";
import { picture } from "./picture";

/** Pixels a side, twice what they are shown at. */
const SIDE = 88;
/** Between one picture and the next: the page stays alive, and a match that starts goes first. */
const PAUSE_MILLIS = 60;

/** Addresses by the surfaces' names, painted one after the other. */
const painted = signal<ReadonlyMap<string, string>>(new Map());
const asked = new Set<string>();
let last: Promise<unknown> = Promise.resolve();

async function paint(id: string): Promise<void> {
  await new Promise((resolve) => setTimeout(resolve, PAUSE_MILLIS));
  const solid = surface(id);
  if (!solid) return;
  const { positions, indices } = solid;
  const address = await picture({ positions, indices, places: positions }, SIDE);
  painted.value = new Map(painted.value).set(id, address);
}

/** A small picture of a surface of the gallery, painted when it comes into sight: most visits never scroll to most. */
export function Thumb({ id }: { id: string }) {
  const place = useRef<HTMLSpanElement>(null);
  useEffect(() => {
    if (!place.current) return;
    const watcher = new IntersectionObserver((seen) => {
      if (!seen.some(({ isIntersecting }) => isIntersecting)) return;
      watcher.disconnect();
      if (asked.has(id)) return;
      asked.add(id);
      // A picture that cannot be painted is left out.
      last = last.then(() => paint(id)).catch(() => {});
    });
    watcher.observe(place.current);
    return () => watcher.disconnect();
  }, [id]);
  const address = painted.value.get(id);
  return (
    <span ref={place} class="thumb">
      {address && <img src={address} alt="" />}
    </span>
  );
}
