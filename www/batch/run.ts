/** A batch on the page: files read one by one, their shapes matched one by one. Signals; no DOM. */

import { signal } from "@preact/signals";
import { evenPoints } from "../morphometrics/semilandmarks";
import type { Session } from "../session";
import { Reader } from "../shapes/import/reader";
import { batch as say } from "../words/batch";
import { en } from "../words/en";
import { imports } from "../words/imports";
import { gridName, verdict } from "../words/said";
import type { Plan } from "./match";
import { Matcher } from "./matcher";
import type { Subject } from "./subject";
import { distinct, subjectsIn, type Taken } from "./subjects";
import { counts, type Row } from "./tables";

export type Choices = {
  readonly files: readonly File[];
  /** The reference is the first shape of the files, else that of the page. */
  readonly first: boolean;
  readonly outline: boolean;
  readonly points: number;
};

const IN_PLACE = { a: 1, b: 0, x: 0, y: 0 };

export class BatchRun {
  readonly rows = signal<readonly Row[]>([]);
  readonly plan = signal<Plan | null>(null);
  readonly running = signal(false);
  /** Files that are done, and how many there are. */
  readonly done = signal<readonly [number, number]>([0, 0]);
  readonly words = signal("");
  readonly problem = signal<string | null>(null);
  private aborting = new AbortController();
  private readonly reader = new Reader(() => {});

  constructor(private readonly session: Session) {}

  stop(): void {
    this.aborting.abort();
    this.reader.stop();
  }

  async start(choices: Choices): Promise<void> {
    this.stop();
    this.aborting = new AbortController();
    const { signal } = this.aborting;
    this.rows.value = [];
    this.plan.value = null;
    this.problem.value = null;
    this.done.value = [0, choices.files.length];
    this.running.value = true;
    let matcher: Matcher | null = null;
    try {
      matcher = new Matcher(await this.session.engine.module());
      await this.all(choices, matcher, signal);
      const { matched, fitting } = counts(this.rows.value);
      this.words.value = say.done(matched, this.rows.value.length, fitting);
    } catch (error) {
      this.words.value = signal.aborted ? say.stopped(counts(this.rows.value).matched) : "";
      if (!signal.aborted) this.problem.value = reason(error);
    } finally {
      matcher?.stop();
      // A run that was begun meanwhile has a signal of its own.
      if (signal === this.aborting.signal) this.running.value = false;
    }
  }

  private async all({ files, first, outline, points }: Choices, matcher: Matcher, signal: AbortSignal): Promise<void> {
    const name = distinct();
    let reference = first ? null : this.ofPage();
    for (const [i, file] of files.entries()) {
      this.words.value = say.reading(file.name);
      const taken = await this.read(file, outline, signal);
      for (const each of taken) {
        if (!reference) {
          if ("problem" in each) throw new Error(say.unread(each.name, each.problem));
          reference = each.subject;
          this.prepare(reference, points);
          name(reference.name);
          continue;
        }
        if (!this.plan.value) this.prepare(reference, points);
        if (this.plan.value) await this.one(this.plan.value, each, file.name, name(each.name), matcher, signal);
      }
      this.done.value = [i + 1, files.length];
    }
  }

  private prepare(reference: Subject, points: number): void {
    // What is drawn on the page knows no settings but the page's own.
    this.plan.value = {
      reference,
      points: evenPoints(reference.shape, points),
      // Its workers have the first package, whatever the page's own match is computed by.
      settings: { ...this.session.settings.value, backend: "cpu" },
    };
  }

  private ofPage(): Subject {
    const shape = this.session.shapes.value.reference;
    if (shape.length === 0) throw new Error(say.noReference);
    return { name: "reference", shape, box: IN_PLACE, landmarks: new Float64Array(), image: null, scale: null };
  }

  /** A file that cannot be read is a row of the table, too. */
  private async read(file: File, outline: boolean, signal: AbortSignal): Promise<readonly Taken[]> {
    try {
      const read = await until(this.reader.read(file), signal);
      if (read.kind === "saved") return [{ name: file.name, problem: say.saved }];
      read.preview?.close();
      const prepare = (wishes: Parameters<Reader["prepare"]>[0]) => until(this.reader.prepare(wishes), signal);
      const taken = await subjectsIn(read.offer, file.name, outline, prepare);
      return taken.map((each) => ("problem" in each ? { ...each, problem: imports.words(each.problem) } : each));
    } catch (error) {
      signal.throwIfAborted();
      return [{ name: file.name, problem: imports.words(reason(error)) }];
    }
  }

  private async one(
    plan: Plan,
    taken: Taken,
    file: string,
    name: string,
    matcher: Matcher,
    signal: AbortSignal,
  ): Promise<void> {
    const add = (row: Pick<Row, "outcome" | "target" | "match">) => {
      this.rows.value = [...this.rows.value, { name, file, ...row }];
    };
    if ("problem" in taken) return add({ outcome: taken.problem, target: null, match: null });
    const { subject: target } = taken;
    const onLevel = (level: number) => {
      this.words.value = say.matching(name, gridName(level));
    };
    try {
      const match = await matcher.match(plan, target, onLevel, signal);
      add({ outcome: [verdict(match.status), match.note].filter(Boolean).join(" "), target, match });
    } catch (error) {
      signal.throwIfAborted();
      add({ outcome: en.solver.words(reason(error)), target: null, match: null });
    }
  }
}

/** What is under way in the reader is never answered once it is stopped. */
function until<T>(promise: Promise<T>, signal: AbortSignal): Promise<T> {
  return new Promise((resolve, reject) => {
    if (signal.aborted) reject(signal.reason);
    signal.addEventListener("abort", () => reject(signal.reason), { once: true });
    promise.then(resolve, reject);
  });
}

function reason(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
