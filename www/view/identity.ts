/** The nodes of a grid in the box, x y a node, x fastest. */
export function identity(cells: number): Float64Array {
  const side = cells + 1;
  return Float64Array.from({ length: 2 * side * side }, (_, k) =>
    k % 2 === 0 ? ((k >> 1) % side) / cells : Math.floor((k >> 1) / side) / cells,
  );
}
