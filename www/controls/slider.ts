/** Where a setting stands on its slider: even steps for short ranges, even ratios for those over several decades. */

import type { NumberSetting } from "../settings";

export const SLIDER_STEPS = 200;

/** Decades on either side of the default that a slider of even ratios spans; the number field takes the rest. */
const DECADES = 2;

type Range = Pick<NumberSetting, "initial" | "least" | "most">;

export function onSlider(field: Range, value: number): number {
  const { ratio, low, high } = ends(field);
  const part = ratio ? Math.log(Math.max(value, low) / low) / Math.log(high / low) : (value - low) / (high - low);
  return Math.round(SLIDER_STEPS * Math.min(1, Math.max(0, part)));
}

/** As many digits as the slider's steps need. */
export function fromSlider(field: Range, position: number): number {
  // The default is found again exactly.
  if (position === onSlider(field, field.initial)) return field.initial;
  const { ratio, low, high } = ends(field);
  const part = position / SLIDER_STEPS;
  if (ratio) return Number((low * (high / low) ** part).toPrecision(3));
  const decimals = Math.max(0, Math.ceil(-Math.log10((high - low) / SLIDER_STEPS)));
  return Number((low + part * (high - low)).toFixed(decimals));
}

/** A range that may reach 0 cannot have even ratios: it ends a little above its default instead. */
function ends({ initial, least, most }: Range): { ratio: boolean; low: number; high: number } {
  if (least > 0) {
    const reach = 10 ** DECADES;
    return { ratio: true, low: Math.max(least, initial / reach), high: Math.min(most, initial * reach) };
  }
  return { ratio: false, low: least, high: initial > 0 ? Math.min(most, 4 * initial) : most };
}
