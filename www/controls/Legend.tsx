import type { ReadonlySignal } from "@preact/signals";
import type { Session } from "../session";
import type { Match } from "../view/result";
import { css, type Scale } from "../view/scales";
import { later } from "../words/later";
import { adopt } from "./adopt";
import style from "./legend.css?inline";
import { ScaleBar } from "./ScaleBar";
import { useDark } from "./useDark";
import { lazy, picture, view } from "./viewing";

adopt(style);

const BINS = 40;

/** What the colours mean, over the lower edge of the picture. */
export function Legend({ session, match, limit, bandwidth }: Shown) {
  const dark = useDark();
  const painter = lazy.value;
  const shown = match.value;
  if (view.value === "grid" || !painter || !shown) return null;
  if (view.value === "image" || view.value === "pullback") return <PictureChoice session={session} />;
  const scale = painter.views.markedScale(view.value, shown, bandwidth, limit.value, dark.value);
  if (!scale) return null;
  return (
    <figure class="legend" aria-label={later.view.legend}>
      {view.value === "stretch" && <Histogram parts={painter.views.histogram(shown, scale, BINS)} scale={scale} />}
      <ScaleBar scale={scale} />
    </figure>
  );
}

type Shown = {
  readonly session: Session;
  readonly match: ReadonlySignal<Match | null>;
  readonly limit: ReadonlySignal<number>;
  /** Of the match. */
  readonly bandwidth: number;
};

/** How much of the curve has which stretch. */
function Histogram({ parts, scale }: { parts: readonly number[]; scale: Scale }) {
  const most = Math.max(...parts);
  return (
    <svg class="histogram" viewBox={`0 0 ${BINS} 10`} preserveAspectRatio="none" role="img" aria-label={words(parts)}>
      {parts.map((part, i) => (
        <rect
          key={css(scale.colours[Math.round((i / BINS) * 255)])}
          x={i + 0.08}
          y={10 - (10 * part) / most}
          width={0.84}
          height={(10 * part) / most}
        />
      ))}
    </svg>
  );
}

function words(parts: readonly number[]): string {
  const highest = parts.indexOf(Math.max(...parts));
  const [shorter, kept, longer] = later.view.shares;
  const where = highest < parts.length * 0.4 ? shorter : highest < parts.length * 0.6 ? kept : longer;
  return later.view.histogram(where);
}

/** Any picture instead of the pattern, chosen or dropped onto the result. */
function PictureChoice({ session }: { session: Session }) {
  return (
    <div class="legend picture">
      <label>
        {later.view.choose}
        <input
          type="file"
          accept="image/*"
          onChange={(event) => {
            const [file] = event.currentTarget.files ?? [];
            if (file) void takePicture(session, file);
          }}
        />
      </label>
      <button
        type="button"
        class="quiet"
        onClick={() => {
          picture.value = lazy.value?.pictures.pattern() ?? null;
        }}
      >
        {later.view.pattern}
      </button>
    </div>
  );
}

/** What cannot be read is reported; the picture before it stays. */
export async function takePicture(session: Session, file: File): Promise<void> {
  try {
    picture.value = (await lazy.value?.pictures.pictureFrom(file)) ?? picture.value;
  } catch (error) {
    session.problem.value = error instanceof Error ? error.message : String(error);
  }
}
