/** What a lesson is, once its file has been read: texts as HTML, and what the frame beside them shows. */

import type { Check } from "./checks";

export type Step = {
  readonly title: string;
  readonly html: string;
  /** To be thought about before the answer is shown. */
  readonly predict: { readonly question: string; readonly answer: string; readonly reveal: string | null } | null;
  readonly task: { readonly html: string; readonly checks: readonly Check[]; readonly solution: string } | null;
  /** For the teacher. */
  readonly notes: string | null;
  /** The query of the frame's address, and the state behind its #. */
  readonly frame: string;
  readonly state: string;
  /** What is true of the match of the state, or of what an answer reveals: tests solve it. */
  readonly holds: readonly Check[];
};

export type Lesson = {
  readonly id: string;
  readonly title: string;
  /** One sentence. */
  readonly about: string;
  readonly minutes: number;
  readonly notes: string | null;
  readonly steps: readonly Step[];
};

/** What the list of lessons knows of one. */
export type Listed = Pick<Lesson, "id" | "title" | "about" | "minutes"> & {
  readonly load: () => Promise<{ readonly default: Lesson }>;
};
