import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { en } from "../words/en";

/** Where the parts of the page lie under each other; the same width as in layout.css. */
const NARROW = "(max-width: 900px)";

/**
 * The place of the result. Where it has been scrolled away above, as on a phone whose settings are open, a small one
 * stays at the top, with what is said of it, and a tap on it leads back.
 */
export function Stage({ said, children }: { said: () => string; children: ComponentChildren }) {
  const place = useRef<HTMLDivElement>(null);
  const pinned = useSignal(false);
  useEffect(() => {
    if (!place.current) return;
    const narrow = matchMedia(NARROW);
    const watcher = new IntersectionObserver(
      ([{ intersectionRatio, boundingClientRect }]) => {
        pinned.value = narrow.matches && intersectionRatio < 0.3 && boundingClientRect.top < 0;
      },
      // What lies below counts as seen: who jumps from above it to below it has passed it.
      { threshold: [0, 0.3], rootMargin: "0px 0px 1000000px" },
    );
    watcher.observe(place.current);
    return () => watcher.disconnect();
  }, [pinned]);
  return (
    <div ref={place} class="stage">
      <div class={pinned.value ? "surface pinned" : "surface"}>
        {children}
        {pinned.value && (
          <>
            {/* Who hears the page has heard it. */}
            <p class="told" aria-hidden="true">
              {said()}
            </p>
            <button type="button" class="back" aria-label={en.result.back} onClick={reveal} />
          </>
        )}
      </div>
    </div>
  );
}

/** Brings the result into view, unless most of it is. */
export function reveal(): void {
  const outcome = document.querySelector(".outcome");
  const box = outcome?.querySelector(".stage")?.getBoundingClientRect();
  if (!outcome || !box) return;
  const seen = Math.min(innerHeight, box.bottom) - Math.max(0, box.top);
  if (seen > 0.8 * box.height) return;
  const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
  outcome.scrollIntoView({ block: "start", behavior: calm ? "auto" : "smooth" });
}
