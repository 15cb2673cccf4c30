import { page } from "./language";

export const numbers = page("numbers", {
  point: ".",
  undefined: "not defined",
  above: "beyond all bounds",
  below: "below all bounds",
});

/**
 * Numbers for people, in one way everywhere: three significant digits, true minus signs, tens with their exponent raised,
 * and words for what is no number.
 */
export function decimals(value: number): string {
  if (value === 0) return "0";
  if (Number.isNaN(value)) return numbers.undefined;
  if (!Number.isFinite(value)) return value > 0 ? numbers.above : numbers.below;
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-4) return withPower(value, 1);
  return plain(value, 3);
}

/** So many significant digits, no exponent. */
export function plain(value: number, digits: number): string {
  return written(String(Number(value.toPrecision(digits))));
}

/** 1.2·10⁻⁵ */
export function withPower(value: number, digits: number): string {
  const [mantissa, exponent] = value.toExponential(digits).split("e");
  return written(`${mantissa}·10${raised(Number(exponent))}`);
}

/** 10⁻³ for 0.001, and so on; null for all but whole powers of ten. */
export function power(value: number | null): string | null {
  const exponent = Math.log10(value ?? Number.NaN);
  return Math.abs(exponent - Math.round(exponent)) < 1e-9 ? `10${raised(Math.round(exponent))}` : null;
}

const RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

export function raised(whole: number): string {
  const digits = Array.from(String(Math.abs(whole)), (digit) => RAISED[Number(digit)]).join("");
  return whole < 0 ? `⁻${digits}` : digits;
}

/** What JavaScript writes, with a true minus and the language's decimal sign. */
export function written(text: string): string {
  return text.replace("-", "−").replace(".", numbers.point);
}
