/** Which square of the plane is shown of two shapes. Domain units. */

export type Square = { readonly left: number; readonly bottom: number; readonly size: number };

/** The box, from corner to corner. */
export const BOX: Square = { left: 0, bottom: 0, size: 1 };

/** φ leaves the box a little under the natural boundary condition; never more than this around it is shown. */
const MARGIN = 0.05;
export const WHOLE: Square = { left: -MARGIN, bottom: -MARGIN, size: 1 + 2 * MARGIN };

/** On each side of the shapes, as a part of their extent: the plane around them is seen to give way. */
const AIR = 0.2;
/** More of it below the shapes, where the legend of a view lies. */
const FOOT = 0.15;
/** Less air than this, and the square is chosen anew. */
const LEAST_AIR = 0.06;
/** So is one that could be smaller than this part of what it is. */
const LOOSE = 0.7;
/** No closer than this. */
const LEAST = 0.3;

type Point = { readonly x: number; readonly y: number };

/** What is to be seen of two shapes and what ties them. */
export function seenOf({
  reference,
  template,
  pins,
}: {
  readonly reference: readonly Float64Array[];
  readonly template: readonly Float64Array[];
  readonly pins: readonly { readonly reference: Point; readonly template: Point }[];
}): readonly Float64Array[] {
  const ends = pins.flatMap(({ reference: p, template: q }) => [p.x, p.y, q.x, q.y]);
  return [...reference, ...template, Float64Array.from(ends)];
}

/**
 * The square around the shapes, with room for a legend or without; `before`, one of the same kind, stays as long as it
 * will do, so that the picture does not move with every stroke.
 */
export function framing(loops: readonly Float64Array[], before: Square | null = null, { legend = false } = {}): Square {
  const extent = extentOf(loops);
  if (!extent) return WHOLE;
  const foot = legend ? FOOT : 0;
  const wanted = around(extent, AIR, foot);
  // Where nothing was shown, nothing moves.
  if (!before || before === WHOLE) return wanted;
  const needed = around(extent, LEAST_AIR, foot);
  const isWide = wanted.size < LOOSE * before.size;
  return isWide || !holds(before, needed) ? wanted : before;
}

type Extent = { readonly x: number; readonly y: number; readonly across: number };

function extentOf(loops: readonly Float64Array[]): Extent | null {
  let [left, bottom, right, top] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const loop of loops) {
    for (let i = 0; i < loop.length; i += 2) {
      left = Math.min(left, loop[i]);
      right = Math.max(right, loop[i]);
      bottom = Math.min(bottom, loop[i + 1]);
      top = Math.max(top, loop[i + 1]);
    }
  }
  if (!(left <= right)) return null;
  return { x: (left + right) / 2, y: (bottom + top) / 2, across: Math.max(right - left, top - bottom) };
}

function around({ x, y, across }: Extent, air: number, foot: number): Square {
  const size = Math.min(WHOLE.size, Math.max(LEAST, across * (1 + 2 * air + foot)));
  const within = (low: number) => Math.min(1 + MARGIN - size, Math.max(-MARGIN, low));
  return { left: within(x - size / 2), bottom: within(y - (foot * across) / 2 - size / 2), size };
}

function holds(outer: Square, inner: Square): boolean {
  const slack = 1e-9;
  return (
    inner.left >= outer.left - slack &&
    inner.bottom >= outer.bottom - slack &&
    inner.left + inner.size <= outer.left + outer.size + slack &&
    inner.bottom + inner.size <= outer.bottom + outer.size + slack
  );
}
