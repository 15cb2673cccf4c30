/** What each setting that the page offers does, in a sentence: comes with the panels that say it. */

import { SETTINGS, type Words } from "../wasm/settings.js";
import { page } from "./language";

type Name = Words["name"];

const offered = SETTINGS.filter(({ kind, onPage }) => onPage && kind !== "pins");

export const helps = page(
  "helps",
  Object.fromEntries(offered.map(({ name, help }) => [name, help])) as Readonly<Partial<Record<Name, string>>>,
);
