/** What a book in another language holds: every page that words/language.ts registers, by its name. */

import type { actions as pinActions, reports as pinReports, told as pinsTold } from "../pins/words";
import type { SettingField } from "../settings";
import type { batch } from "./batch";
import type { guides, actions as outline, told } from "./drawing";
import type { embed } from "./embed";
import type { en } from "./en";
import type { experiments } from "./experiments";
import type { files } from "./files";
import type { helps } from "./helps";
import type { imports } from "./imports";
import type { captions, later } from "./later";
import type { lessons } from "./lessons";
import type { links } from "./links";
import type { memory } from "./memory";
import type { numbers } from "./numbers";
import type { offline } from "./offline";
import type { words as place } from "./place";
import type { recent } from "./recent";
import type { save } from "./save";
import type { space } from "./space";
import type { strokes } from "./strokes";
import type { exchange, words as tools } from "./tools";
import type { way } from "./way";

/** Of a setting that the page offers; the label with its symbol, the options in their order. */
export type SettingWords = {
  readonly label: string;
  readonly unit?: string;
  readonly options?: readonly { readonly label: string }[];
};

export type ExperimentWords = { readonly title: string; readonly paper: string; readonly setup: string };

type Held = { readonly innerHTML: string };

/** Of a file of the page; the prose in its order. */
export type FileWords = {
  readonly root: { readonly lang: string };
  readonly title: { readonly textContent: string };
  readonly description: { readonly content: string };
  readonly change: { readonly textContent: string; readonly lang: string };
  readonly prose: readonly Held[];
};

export type Book = {
  readonly en: typeof en;
  readonly later: typeof later;
  readonly captions: typeof captions;
  readonly embed: typeof embed;
  readonly lessons: typeof lessons;
  readonly links: typeof links;
  readonly save: typeof save;
  readonly memory: typeof memory;
  readonly recent: typeof recent;
  readonly offline: typeof offline;
  readonly numbers: typeof numbers;
  readonly place: typeof place;
  readonly tools: typeof tools;
  readonly exchange: typeof exchange;
  readonly guides: typeof guides;
  readonly outline: typeof outline;
  readonly told: typeof told;
  readonly strokes: typeof strokes;
  readonly pinActions: typeof pinActions;
  readonly pinsTold: typeof pinsTold;
  readonly pinReports: typeof pinReports;
  readonly files: typeof files;
  readonly imports: typeof imports;
  readonly batch: typeof batch;
  readonly settings: Readonly<Partial<Record<SettingField["name"], SettingWords>>>;
  readonly helps: typeof helps;
  readonly way: typeof way;
  readonly space: typeof space;
  /** By the surfaces' ids, and by those of both surfaces of a pair. */
  readonly surfaces: Readonly<Record<string, { readonly name: string }>>;
  readonly pairsOfSurfaces: Readonly<Record<string, { readonly name: string }>>;
  readonly presets: Readonly<Record<string, { readonly title: string }>>;
  readonly experiments: typeof experiments;
  /** By the experiments' ids. */
  readonly experimentTexts: Readonly<Record<string, ExperimentWords>>;
  readonly indexFile: FileWords;
  readonly experimentsFile: FileWords;
  readonly lessonsFile: FileWords;
};
