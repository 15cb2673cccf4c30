import { expect, test } from "vitest";
import { FIELDS, type NumberSetting } from "../settings";
import { fromSlider, onSlider, SLIDER_STEPS } from "./slider";

const NUMBERS = FIELDS.filter((field): field is NumberSetting => field.kind === "number");

test.each(NUMBERS)("the slider of “$label” holds its default and allowed values only, ever larger", (field) => {
  expect(fromSlider(field, onSlider(field, field.initial))).toBe(field.initial);
  let before = -Infinity;
  for (let position = 0; position <= SLIDER_STEPS; position += 1) {
    const value = fromSlider(field, position);
    expect(value).toBeGreaterThanOrEqual(field.least);
    expect(value).toBeLessThanOrEqual(field.most);
    expect(value).toBeGreaterThan(before);
    expect(Math.abs(onSlider(field, value) - position)).toBeLessThanOrEqual(1);
    before = value;
  }
});

test("values beyond the slider rest at its ends", () => {
  const field = { initial: 1000, least: 0.001, most: 1e7 };
  expect(onSlider(field, 1e7)).toBe(SLIDER_STEPS);
  expect(onSlider(field, 0.001)).toBe(0);
});
