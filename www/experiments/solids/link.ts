/** An experiment's pair as a link to the page of surfaces. */

import { type Chosen, withSetting } from "../../settings";
import { encode } from "../../space/link";
import { FIRST_LOOK } from "../../space/session";
import { SPACE_FIELDS } from "../../space/settings";
import type { SolidExperiment } from "../experiment";

/** Settings that the page does not offer are left to its defaults. */
export function linkToSpace({ reference, template, settings }: SolidExperiment["example"]): string {
  let chosen: Chosen = {};
  for (const field of SPACE_FIELDS) {
    const value = settings[field.name];
    if (value !== undefined) chosen = withSetting(chosen, field, value as number | string | boolean);
  }
  return encode({ reference: { id: reference }, template: { id: template }, pins: [], settings: chosen }, FIRST_LOOK);
}
