/** Which parts of a shape are taken: all or the largest, with holes or filled. */

import { bounds, type Loop, type Shape, signedArea, winding } from "../geometry";

export type Parts = "all" | "largest";
export type Holes = "keep" | "fill";

/** Loops do not cross; bodies run counter-clockwise, holes clockwise. */
export function chosenParts(shape: Shape, parts: Parts, holes: Holes): Shape {
  const bodies = shape.filter((loop) => signedArea(loop) > 0);
  const kept =
    parts === "all" || bodies.length < 2
      ? shape
      : withHoles(
          shape,
          bodies.reduce((a, b) => (signedArea(b) > signedArea(a) ? b : a)),
        );
  if (holes === "keep") return kept;
  const outer = kept.filter((loop) => signedArea(loop) > 0);
  // What stood in a hole is inside now, and no outline any more.
  return outer.filter((loop) => !outer.some((other) => other !== loop && encloses(other, loop)));
}

/** The body with the holes that are cut directly into it. */
function withHoles(shape: Shape, body: Loop): Shape {
  const inside = shape.filter((loop) => loop !== body && encloses(body, loop));
  const islands = inside.filter((loop) => signedArea(loop) > 0);
  const holes = inside.filter((loop) => signedArea(loop) < 0 && !islands.some((island) => encloses(island, loop)));
  return [body, ...holes];
}

/** Whether the loop lies inside the other, asked at most of its points: outlines may touch in some. */
function encloses(outer: Loop, loop: Loop): boolean {
  const box = bounds([outer]);
  let inside = 0;
  const step = 2 * Math.max(1, Math.floor(loop.length / 2 / 16));
  let asked = 0;
  for (let i = 0; i < loop.length; i += step) {
    asked += 1;
    const point = { x: loop[i], y: loop[i + 1] };
    const near = box && point.x >= box.left && point.x <= box.right && point.y >= box.bottom && point.y <= box.top;
    if (near && winding([outer], point) !== 0) inside += 1;
  }
  return 2 * inside > asked;
}
