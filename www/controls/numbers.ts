/** Numbers for people: three significant digits, no exponent where it can be helped, and words for what is no number. */
export function decimals(value: number): string {
  if (value === 0) return "0";
  if (Number.isNaN(value)) return "not defined";
  if (!Number.isFinite(value)) return value > 0 ? "beyond all bounds" : "below all bounds";
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-4) return value.toExponential(1).replace("e", " × 10^").replace("+", "");
  return String(Number(value.toPrecision(3)));
}

/** A distance in cells of the grid. There is none where no part of the curve lies on the grid that was matched. */
export function cells(distance: number): string {
  return Number.isFinite(distance) ? `${decimals(distance)} cells` : "none: the grid does not see the curve";
}
