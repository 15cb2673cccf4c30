import { expect, test } from "vitest";
import { seeded } from "../testing/mutate";
import { pack, unpack } from "./pack";

/** Coordinates that a text keeps as they are. */
function onSteps(numbers: readonly number[]): Float64Array {
  return Float64Array.from(numbers, (step) => -0.5 + (step / 65535) * 2);
}

test("every loop comes back to the step, smooth or wild", () => {
  const random = seeded(3);
  for (const size of [1, 10, 1000, 65535]) {
    for (const count of [1, 2, 3, 50]) {
      const loop = onSteps(Array.from({ length: 2 * count }, () => Math.floor(size * random())));
      expect(unpack(pack(loop))).toEqual(loop);
    }
  }
  const corners = onSteps([0, 65535, 65535, 0, 0, 65535, 65535, 0]);
  expect(unpack(pack(corners))).toEqual(corners);
});

test("a smooth curve takes less than two letters a point", () => {
  const circle = Float64Array.from({ length: 400 }, (_, k) => {
    const t = (2 * Math.PI * (k >> 1)) / 200;
    return 0.5 + 0.3 * (k % 2 === 0 ? Math.cos(t) : Math.sin(t));
  });
  expect(pack(circle).length).toBeLessThan(2 * 200);
});

test("what is cut off, lengthened or changed in one letter is refused", () => {
  const text = pack(onSteps([100, 200, 300, 250, 500, 900, 20, 30]));
  for (let i = 0; i < text.length; i += 1) {
    expect(() => unpack(text.slice(0, i))).toThrow();
    for (const letter of "A5_") {
      if (letter !== text[i]) expect(() => unpack(text.slice(0, i) + letter + text.slice(i + 1))).toThrow();
    }
  }
  expect(() => unpack(`${text}A`)).toThrow("damaged");
});
