/**
 * A loop as a short text of A–Z, a–z, 0–9, - and _, six bits a letter, the highest first.
 *
 * Coordinates are whole steps of 2/65535 of the box, from −0.5 to 1.5: at most 2 · 10⁻⁵ off. On a curve the next point is
 * nearly where the last two point to; only what it is off from there is written, by an adaptive Rice code (as JPEG-LS
 * has it): the 200 points of a drawn curve take some 350 letters. A checksum comes first.
 */

import type { Loop } from "../shapes/geometry";

const LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
const LOW = -0.5;
const SPAN = 2;
const STEPS = 65535;

/** More points than any drawing or import makes; a hostile text could ask for millions. */
export const MOST_POINTS = 50_000;

const COUNT_BITS = 16;
const COORDINATE_BITS = 16;
const SUM_BITS = 16;
/** Quotients from here on are written as plain numbers; those take any second difference of coordinates. */
const LONGEST_QUOTIENT = 20;
const PLAIN_BITS = 19;
/** How soon the code forgets what it has adapted to. */
const WINDOW = 16;
const FIRST_GUESS = 64;

export function pack(loop: Loop): string {
  const steps = Array.from(loop, stepOf);
  const writer = new Writer();
  writer.bits(checksum(steps), SUM_BITS);
  writer.bits(steps.length / 2, COUNT_BITS);
  const code = new Rice();
  steps.forEach((step, i) => {
    if (i < 2) writer.bits(step, COORDINATE_BITS);
    else code.write(writer, step - expected(steps, i));
  });
  return writer.end();
}

/** The inverse. Throws "damaged", "cut off" or "too long" for what `pack` has not written. */
export function unpack(text: string): Float64Array {
  const reader = new Reader(text);
  const sum = reader.bits(SUM_BITS);
  const count = reader.bits(COUNT_BITS);
  if (count > MOST_POINTS) throw new Error("too long");
  const steps: number[] = [];
  const code = new Rice();
  while (steps.length < 2 * count) {
    const i = steps.length;
    const step = i < 2 ? reader.bits(COORDINATE_BITS) : expected(steps, i) + code.read(reader);
    if (step < 0 || step > STEPS) throw new Error("damaged");
    steps.push(step);
  }
  if (checksum(steps) !== sum || !reader.ends()) throw new Error("damaged");
  return Float64Array.from(steps, (step) => LOW + (step / STEPS) * SPAN);
}

export function stepOf(coordinate: number): number {
  return Math.min(STEPS, Math.max(0, Math.round(((coordinate - LOW) / SPAN) * STEPS)));
}

/** Where the points before lead to. */
function expected(steps: readonly number[], i: number): number {
  return i < 4 ? steps[i - 2] : 2 * steps[i - 2] - steps[i - 4];
}

function checksum(steps: readonly number[]): number {
  // The largest prime below 2¹⁶, so that every step counts wherever it stands.
  return steps.reduce((sum, step) => (31 * sum + step + 1) % 65521, steps.length % 65521);
}

/** Small numbers of either sign in few bits, after the mean size of those before. */
class Rice {
  private sum = FIRST_GUESS;
  private count = 1;

  write(writer: Writer, value: number): void {
    const folded = value < 0 ? -2 * value - 1 : 2 * value;
    const low = this.lowBits();
    const quotient = folded >> low;
    if (quotient >= LONGEST_QUOTIENT) {
      writer.ones(LONGEST_QUOTIENT);
      writer.bits(folded, PLAIN_BITS);
    } else {
      writer.ones(quotient);
      writer.bits(0, 1);
      writer.bits(folded & ((1 << low) - 1), low);
    }
    this.adapt(folded);
  }

  read(reader: Reader): number {
    const low = this.lowBits();
    let quotient = 0;
    while (quotient < LONGEST_QUOTIENT && reader.bits(1) === 1) quotient += 1;
    const plain = quotient === LONGEST_QUOTIENT;
    const folded = plain ? reader.bits(PLAIN_BITS) : (quotient << low) + reader.bits(low);
    this.adapt(folded);
    return folded % 2 === 1 ? -(folded + 1) / 2 : folded / 2;
  }

  private lowBits(): number {
    let bits = 0;
    while (this.count << bits < this.sum) bits += 1;
    return Math.max(0, bits - 1);
  }

  private adapt(folded: number): void {
    this.sum += folded;
    this.count += 1;
    if (this.count < WINDOW) return;
    this.sum >>= 1;
    this.count >>= 1;
  }
}

class Writer {
  private text = "";
  private held = 0;
  private count = 0;

  bits(value: number, count: number): void {
    for (let bit = count - 1; bit >= 0; bit -= 1) {
      this.held = 2 * this.held + ((value >> bit) & 1);
      this.count += 1;
      if (this.count < 6) continue;
      this.text += LETTERS[this.held];
      this.held = 0;
      this.count = 0;
    }
  }

  ones(count: number): void {
    for (let i = 0; i < count; i += 1) this.bits(1, 1);
  }

  end(): string {
    while (this.count > 0) this.bits(0, 1);
    return this.text;
  }
}

class Reader {
  private readonly text: string;
  private at = 0;

  constructor(text: string) {
    this.text = text;
  }

  bits(count: number): number {
    let value = 0;
    for (let i = 0; i < count; i += 1) {
      const letter = Math.floor(this.at / 6);
      if (letter >= this.text.length) throw new Error("cut off");
      const six = LETTERS.indexOf(this.text[letter]);
      if (six < 0) throw new Error("damaged");
      value = 2 * value + ((six >> (5 - (this.at % 6))) & 1);
      this.at += 1;
    }
    return value;
  }

  /** Whether nothing but the last letter's filling is left. */
  ends(): boolean {
    if (this.text.length !== Math.ceil(this.at / 6)) return false;
    return this.at % 6 === 0 || this.bits(6 - (this.at % 6)) === 0;
  }
}
