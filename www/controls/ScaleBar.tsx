import { css, type Scale } from "../view/scales";

/** A scale's colours, with their numbers and what they are of. */
export function ScaleBar({ scale }: { scale: Scale }) {
  const stops = Array.from({ length: 17 }, (_, i) =>
    css(scale.colours[Math.round((i / 16) * (scale.colours.length - 1))]),
  );
  return (
    <>
      <div class="bar" style={{ background: `linear-gradient(to right, ${stops.join(", ")})` }} />
      <ol class="ticks">
        {scale.ticks.map(({ part, text }) => (
          <li key={part} style={{ insetInlineStart: `${100 * part}%` }}>
            {text}
          </li>
        ))}
      </ol>
      <figcaption>
        {scale.title}
        {scale.unit && <span class="unit">{scale.unit}</span>}
      </figcaption>
    </>
  );
}
