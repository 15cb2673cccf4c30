/** The matches so far, each with what it was computed from: to be shown again, and to be compared. */

import { signal } from "@preact/signals";
import type { Result } from "./run";
import { type Chosen, FIELDS, sameSettings } from "./settings";
import { written } from "./words/numbers";

export type KeptRun = Result & { readonly id: number };

/** Runs kept besides the pinned one. */
const MOST = 12;
/** Numbers kept of all deformations together: 32 MB. */
const NUMBERS = 4e6;

export class Runs {
  /** Newest first. */
  readonly list = signal<readonly KeptRun[]>([]);
  readonly pinned = signal<number | null>(null);
  private next = 1;

  /** The same match again, as one shown from this list, is none. */
  add(result: Result): void {
    const known = this.list.value.some(({ frame }) => frame.deformation === result.frame.deformation);
    if (known) return;
    const all = [{ ...result, id: this.next }, ...this.list.value];
    this.next += 1;
    let numbers = 0;
    this.list.value = all.filter(({ id, frame }, i) => {
      numbers += frame.deformation.length;
      return i === 0 || id === this.pinned.value || (i < MOST && numbers <= NUMBERS);
    });
  }

  /** Pinned, a run is kept and the newest one is shown beside it; once more, it is let go. */
  pin(id: number): void {
    this.pinned.value = this.pinned.value === id ? null : id;
  }

  of(id: number | null): KeptRun | null {
    return this.list.value.find((run) => run.id === id) ?? null;
  }
}

/** What a setting is chosen to be, in words: "Bending 0". */
export function choiceWords(chosen: Chosen, other: Chosen): readonly string[] {
  return FIELDS.filter(({ name }) => !sameSettings({ [name]: chosen[name] }, { [name]: other[name] })).map((field) => {
    const value = chosen[field.name] ?? field.initial;
    const text = field.kind === "choice" ? field.options.find((option) => option.value === value)?.label : value;
    return `${field.label} ${written(String(text ?? value))}`;
  });
}
