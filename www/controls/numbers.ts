/** Numbers for people: three significant digits, no exponent where it can be helped. */
export function decimals(value: number): string {
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-4) return value.toExponential(1).replace("e", " × 10^").replace("+", "");
  return String(Number(value.toPrecision(3)));
}
