/** What the page says of links that it cannot read. */

import { page } from "./language";
import { SIDES, type Side } from "./sides";

/** Characters of what was given that a sentence repeats. */
const LONGEST = 40;

export function brief(text: string): string {
  return text.length > LONGEST ? `${text.slice(0, LONGEST)}…` : text;
}

export const links = page("links", {
  unread: (why: string) =>
    `The link could not be read: ${why}. What would be here without it is shown instead; ask for a fresh link to see the others.`,
  lost: (why: string) =>
    `What was here last could not be read: ${why}. It stays under “Recent sessions”; the first example is shown instead.`,
  kept: (why: string) => `The link could not be read: ${why}. Everything is left as it was.`,
  override: (why: string) => `The address asks for what cannot be: ${why}. The rest of it is shown.`,
  foreign: "it is no link of this page",
  version: (version: string) => `version “${brief(version)}” is not known`,
  noExample: (id: string) => `there is no example called “${brief(id)}”`,
  missing: (side: Side) => `the ${SIDES[side]} is missing`,
  loop: (index: number, side: Side) => `loop ${index} of the ${SIDES[side]}`,
  pins: "the list of pins",
  damaged: (what: string) => `${what} is damaged`,
  cutOff: (what: string) => `${what} is cut off`,
  tooLong: (what: string) => `${what} is too long`,
  tooFew: (what: string) => `${what} has fewer than three points`,
  manyPins: (most: number) => `there are more than ${most} pins`,
  pinOutside: "a pin lies outside the box",
  noView: (view: string) => `there is no view called “${brief(view)}”`,
  noMorph: (text: string) => `the morph is “${brief(text)}”, but must be a number from 0 to 1`,
  /** A setting in a link, a file or a field. */
  noChoice: (label: string, given: string, known: string) => `${label} is “${given}”, but must be one of ${known}`,
  noNumber: (label: string, given: string, least: number, most: number) =>
    `${label} is “${given}”, but must be a number from ${least} to ${most}`,
});
