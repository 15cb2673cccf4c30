/** What the page says of files that it writes, and of those that it has written. */

import { page } from "./language";

export const files = page("files", {
  noVideo: "This browser recorded no video, so the morph is saved as a GIF.",
  noMatch: "There is no match to save yet; press Match first.",
  empty: "The file came out empty; try again, or save another format.",
  recorder: "the recorder has failed",
  noPicture: "The browser could not make the picture; it may be short of memory.",
  noCanvas: "The browser gives no canvas to draw the picture on.",
  matchTitle: "Deformed grid and matched curve",
  shapesTitle: "Reference and target",

  version: (found: string, known: number) => `The file is of version ${found}; this page reads version ${known}.`,
  setting: (name: string) => `The file has a setting “${name}”, which this page does not know.`,
  deformation: (found: number, level: number, needed: number) =>
    `The deformation has ${found} numbers, but level ${level} needs ${needed}; save it again.`,
  folded: "The deformation folds the plane, which no match of this page does; save it again.",
  unlike: "The matched curves have not the points of the reference; save the match again.",
  /** `what` is a sentence without its end, made of the following; names are those of the file's fields. */
  damaged: (what: string) => `The file is damaged: ${what}; save it again.`,
  manyPins: (most: number) => `it has more than ${most} pins`,
  outside: (name: string) => `${name} is no point of the box`,
  manyNumbers: (name: string) => `${name} has more than two numbers`,
  missing: (name: string) => `${name} is missing or of the wrong kind`,
  noList: (name: string) => `${name} is no list`,
  noNumber: (name: string) => `${name} is no number`,
  strange: (name: string, found: number) => `${name} is ${found}, which no match has`,
});
