/** A plane of the undeformed grid with what lies in it: its grid lines, and the curve that it cuts out of a surface. */

/** Line segments, x y z an end, before and after the deformation. */
export type Segments = { readonly from: Float32Array; readonly to: Float32Array };

export type Plane = {
  /** 0, 1, 2 for a plane across x, y, z. */
  readonly axis: number;
  /** Where it crosses the axis, 0 to 1. */
  readonly part: number;
};

/** Lines of the picture; finer grids show every so manieth. */
const LINES = 32;

/** The grid's lines in the plane. φ at the nodes, x y z a node, x fastest. */
export function gridLines(level: number, deformation: ArrayLike<number>, { axis, part }: Plane): Segments {
  const cells = 2 ** level;
  const side = cells + 1;
  const stride = Math.max(1, cells / LINES);
  const [first, second] = [0, 1, 2].filter((candidate) => candidate !== axis);
  const low = Math.min(cells - 1, Math.floor(part * cells));
  const share = part * cells - low;
  const from: number[] = [];
  const to: number[] = [];
  const end = (i: number, j: number) => {
    const node = [0, 0, 0];
    [node[first], node[second], node[axis]] = [i, j, low];
    const index = (node[2] * side + node[1]) * side + node[0];
    const beyond = index + [1, side, side * side][axis];
    for (let k = 0; k < 3; k += 1) {
      from.push(k === axis ? part : node[k] / cells);
      to.push((1 - share) * deformation[3 * index + k] + share * deformation[3 * beyond + k]);
    }
  };
  for (let line = 0; line <= cells; line += stride)
    for (let k = 0; k < cells; k += 1) {
      end(k, line);
      end(k + 1, line);
      end(line, k);
      end(line, k + 1);
    }
  return { from: Float32Array.from(from), to: Float32Array.from(to) };
}

/** The curve that the plane cuts out of a surface, and where the deformation takes it. */
export function cut(
  positions: ArrayLike<number>,
  moved: ArrayLike<number>,
  indices: Uint32Array,
  { axis, part }: Plane,
): Segments {
  const from: number[] = [];
  const to: number[] = [];
  for (let k = 0; k < indices.length; k += 3) {
    const crossings: [number, number, number][] = [];
    for (let corner = 0; corner < 3; corner += 1) {
      const [p, q] = [indices[k + corner], indices[k + ((corner + 1) % 3)]];
      const [before, after] = [positions[3 * p + axis] - part, positions[3 * q + axis] - part];
      if (before < 0 !== after < 0) crossings.push([p, q, before / (before - after)]);
    }
    for (const [p, q, share] of crossings)
      for (let component = 0; component < 3; component += 1) {
        const between = (values: ArrayLike<number>) =>
          (1 - share) * values[3 * p + component] + share * values[3 * q + component];
        from.push(between(positions));
        to.push(between(moved));
      }
  }
  return { from: Float32Array.from(from), to: Float32Array.from(to) };
}
