/** SVG and CSS transform lists as matrices. */

import { ImportError } from "./found";

/** x ↦ a x + c y + e, y ↦ b x + d y + f: the order of SVG's matrix(). */
export type Matrix = readonly [a: number, b: number, c: number, d: number, e: number, f: number];

export const IDENTITY: Matrix = [1, 0, 0, 1, 0, 0];

/** First `inner`, then `outer`. */
export function compose(outer: Matrix, inner: Matrix): Matrix {
  const [a, b, c, d, e, f] = outer;
  const [g, h, i, j, k, l] = inner;
  return [a * g + c * h, b * g + d * h, a * i + c * j, b * i + d * j, a * k + c * l + e, b * k + d * l + f];
}

export function applied([a, b, c, d, e, f]: Matrix, x: number, y: number): readonly [number, number] {
  return [a * x + c * y + e, b * x + d * y + f];
}

const DEGREES: Record<string, number> = { "": 1, deg: 1, rad: 180 / Math.PI, grad: 0.9, turn: 360 };
const PIXELS: Record<string, number> = { "": 1, px: 1, pt: 4 / 3, pc: 16, in: 96, cm: 96 / 2.54, mm: 9.6 / 2.54 };

/** No number that anybody means has more letters. */
const LONGEST = 100;

/** A length in user units, or null for what is none: `auto`, percentages, units relative to a font. */
export function pixels(text: string): number | null {
  if (text.length > LONGEST) return null;
  const match = /^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)([a-z]*)\s*$/i.exec(text);
  const factor = match && PIXELS[match[2].toLowerCase()];
  return match && factor !== undefined ? Number(match[1]) * Number(factor) : null;
}

/** With its unit; commas between numbers may be missing where a sign or a point makes them plain. */
const NUMBER = /[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?[a-z%]*/gi;

/** One transform of a list; from where the last ended, so that what is none is found out at once. */
const TRANSFORM = /\s*([a-z0-9]+)\s*\(([^)]*)\)[\s,]*/iy;

/** The matrix of a list such as `translate(3 4) rotate(45)`; the last in the list acts first. Throws on unknown words. */
export function parseTransform(text: string): Matrix {
  if (text.trim() === "none") return IDENTITY;
  let matrix = IDENTITY;
  TRANSFORM.lastIndex = 0;
  for (let end = 0; end < text.length; end = TRANSFORM.lastIndex) {
    const found = TRANSFORM.exec(text);
    if (!found) {
      if (text.slice(end).trim() === "") break;
      throw unreadable(text);
    }
    matrix = compose(matrix, single(found[1], found[2], text));
  }
  return matrix;
}

function single(name: string, list: string, text: string): Matrix {
  const words = list.match(NUMBER) ?? [];
  if (list.replace(NUMBER, "").replace(/[\s,]/g, "") !== "") throw unreadable(text);
  const length = (i: number) => {
    const value = pixels(words[i]);
    if (value === null) throw unreadable(text);
    return value;
  };
  const angle = (i: number) => {
    const match = words[i].length <= LONGEST && /^([+-]?[\d.]+(?:e[+-]?\d+)?)([a-z]*)$/i.exec(words[i]);
    const unit = match && DEGREES[match[2].toLowerCase()];
    if (!match || !unit) throw unreadable(text);
    return (Number(match[1]) * unit * Math.PI) / 180;
  };
  const count = words.length;
  const [cos, sin] = name.toLowerCase().startsWith("rotate") && count > 0 ? turn(angle(0)) : [1, 0];
  switch (`${name.toLowerCase()} ${count}`) {
    case "matrix 6":
      return [length(0), length(1), length(2), length(3), length(4), length(5)];
    case "translate 1":
    case "translatex 1":
      return [1, 0, 0, 1, length(0), 0];
    case "translatey 1":
      return [1, 0, 0, 1, 0, length(0)];
    case "translate 2":
      return [1, 0, 0, 1, length(0), length(1)];
    case "scale 1":
      return [length(0), 0, 0, length(0), 0, 0];
    case "scale 2":
      return [length(0), 0, 0, length(1), 0, 0];
    case "scalex 1":
      return [length(0), 0, 0, 1, 0, 0];
    case "scaley 1":
      return [1, 0, 0, length(0), 0, 0];
    case "rotate 1":
      return [cos, sin, -sin, cos, 0, 0];
    case "rotate 3": {
      const x = length(1);
      const y = length(2);
      return [cos, sin, -sin, cos, x - cos * x + sin * y, y - sin * x - cos * y];
    }
    case "skewx 1":
    case "skew 1":
      return [1, 0, Math.tan(angle(0)), 1, 0, 0];
    case "skewy 1":
      return [1, Math.tan(angle(0)), 0, 1, 0, 0];
    case "skew 2":
      return [1, Math.tan(angle(1)), Math.tan(angle(0)), 1, 0, 0];
    default:
      throw unreadable(text);
  }
}

function turn(angle: number): readonly [number, number] {
  return [Math.cos(angle), Math.sin(angle)];
}

function unreadable(text: string): ImportError {
  const shown = text.length > 60 ? `${text.slice(0, 60)}…` : text;
  return new ImportError(
    `The transform “${shown}” cannot be read; save the drawing as plain SVG, with its transforms applied.`,
  );
}
