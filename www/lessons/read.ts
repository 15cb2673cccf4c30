/**
 * Reads a lesson's file: docs/lessons.md says how one is written. Every mistake is found while the page is built, and
 * said with its file and line.
 */

import { asked } from "../embed/asked";
import { decode } from "../link/text";
import { surface } from "../space/gallery";
import { decode as decodeSolid } from "../space/link";
import { type Check, parseCheck } from "./checks";
import type { Lesson, Step } from "./lesson";
import { htmlOf, inlineOf, Mistake } from "./prose";

/** Lines from `line` on, counted from 1 within the file. */
type Piece = { readonly line: number; readonly lines: readonly string[] };
type Entry = { readonly line: number; readonly value: string };
type Block = { readonly line: number; readonly entries: ReadonlyMap<string, readonly Entry[]>; readonly body: Piece };

const LESSON_KEYS = ["lesson", "about", "minutes"];
const STEP_KEYS = ["step", "show", "controls", "sliders", "a", "b", "state", "reveal", "check", "solution", "holds"];
/** What may stand more than once in a block. */
const LISTS = ["check", "holds"];
const SECTIONS = ["Predict", "Answer", "Do", "For the teacher"];
const FEWEST = 5;
const MOST = 10;

/** All mistakes of a file, each with its place. */
export class Mistakes extends Error {
  readonly found: readonly Mistake[];

  constructor(path: string, found: readonly Mistake[]) {
    super(found.map(({ line, message }) => `${path}:${line}: ${message}`).join("\n"));
    this.found = found;
  }
}

/** `isKnown` tells whether a page of this site is there. Throws Mistakes. */
export function readLesson(path: string, text: string, isKnown: (address: string) => boolean): Lesson {
  const found: Mistake[] = [];
  const look = <T>(read: () => T, instead: T): T => {
    try {
      return read();
    } catch (error) {
      if (!(error instanceof Mistake)) throw error;
      found.push(error);
      return instead;
    }
  };
  const id = /(?:^|\/)\d+-([a-z][a-z-]*)\.md$/.exec(path)?.[1] ?? "";
  if (id === "") found.push(new Mistake(1, "a lesson's file is called like 04-bending.md"));
  const blocks = look(() => blocksOf(text), []);
  const [head, ...steps] = blocks;
  if (!head) throw new Mistakes(path, found);
  look(() => onlyKeys(head, LESSON_KEYS, "a lesson"), undefined);
  const lesson: Lesson = {
    id,
    title: look(() => needed(head, "lesson").value, ""),
    about: look(() => needed(head, "about").value, ""),
    minutes: look(() => wholeNumber(needed(head, "minutes")), 1),
    notes: look(() => prose(head.body, isKnown) || null, null),
    steps: steps.flatMap((step) => look<Step[]>(() => [stepOf(step, isKnown, (mistake) => found.push(mistake))], [])),
  };
  if (steps.length < FEWEST || steps.length > MOST)
    found.push(new Mistake(head.line, `a lesson has ${FEWEST} to ${MOST} steps; this one has ${steps.length}`));
  if (found.length > 0)
    throw new Mistakes(
      path,
      found.toSorted((a, b) => a.line - b.line),
    );
  return lesson;
}

/** A block is what stands between two lines of three dashes, and the text after it. */
function blocksOf(text: string): Block[] {
  const lines = text.replace(/\r\n/g, "\n").trimEnd().split("\n");
  if (lines[0] !== "---") throw new Mistake(1, "a lesson begins with a line of three dashes, ---");
  const blocks: Block[] = [];
  for (let at = 0; at < lines.length; ) {
    const end = lines.indexOf("---", at + 1);
    if (end < 0) throw new Mistake(at + 1, "what begins with --- here does not end with ---");
    const next = lines.indexOf("---", end + 1);
    const stop = next < 0 ? lines.length : next;
    blocks.push({
      line: at + 1,
      entries: entriesOf(lines, at + 1, end),
      body: { line: end + 2, lines: lines.slice(end + 1, stop) },
    });
    at = stop;
  }
  return blocks;
}

function entriesOf(lines: readonly string[], from: number, end: number): Block["entries"] {
  const entries = new Map<string, Entry[]>();
  for (let at = from; at < end; at += 1) {
    if (lines[at].trim() === "") continue;
    const [, key, value] = /^([a-z]+):\s*(.*?)\s*$/.exec(lines[at]) ?? [];
    if (key === undefined) throw new Mistake(at + 1, `“${lines[at]}” is not like name: value`);
    const entry = { line: at + 1, value };
    const before = entries.get(key);
    if (before && !LISTS.includes(key)) throw new Mistake(at + 1, `${key} stands here twice`);
    entries.set(key, [...(before ?? []), entry]);
  }
  return entries;
}

function stepOf(block: Block, isKnown: (address: string) => boolean, note: (mistake: Mistake) => void): Step {
  onlyKeys(block, STEP_KEYS, "a step");
  const sections = sectionsOf(block.body);
  const section = (name: string) => {
    const piece = sections.get(name);
    return piece ? { piece, html: prose(piece, isKnown) } : null;
  };
  const [main, question, answer, task, notes] = ["", ...SECTIONS].map(section);
  const checks = checksOf(block, "check");
  const frame = frameOf(block);
  const state = needed(block, "state");
  const isCompared = frame.startsWith("embed=compare");
  checkState(state, isCompared);
  for (const name of ["reveal", "solution"]) for (const entry of all(block, name)) checkState(entry, isCompared);
  if (!main?.html) throw new Mistake(block.body.line, "a step has a text before its questions and tasks");
  // A piece begins below its heading.
  const at = (name: string) => all(block, name)[0]?.line ?? block.line;
  if (question && !answer) note(new Mistake(question.piece.line - 1, "## Predict needs an ## Answer after it"));
  if (answer && !question) note(new Mistake(answer.piece.line - 1, "## Answer needs a ## Predict before it"));
  if (all(block, "reveal").length > 0 && !answer) note(new Mistake(at("reveal"), "reveal needs an ## Answer"));
  if (task && checks.length === 0)
    note(new Mistake(task.piece.line - 1, "## Do needs a check: above, or nobody learns"));
  if (task && all(block, "solution").length === 0)
    note(new Mistake(task.piece.line - 1, "## Do needs a solution: above, a state that its checks accept"));
  if (!task && checks.length > 0) note(new Mistake(at("check"), "check needs a ## Do that says what to do"));
  return {
    title: titleOf(needed(block, "step")),
    html: main.html,
    predict:
      question && answer
        ? { question: question.html, answer: answer.html, reveal: all(block, "reveal")[0]?.value ?? null }
        : null,
    task: task && { html: task.html, checks, solution: all(block, "solution")[0]?.value ?? "" },
    notes: notes?.html ?? null,
    frame,
    state: state.value,
    holds: checksOf(block, "holds"),
  };
}

/** The text before the first heading has no name. */
function sectionsOf({ line, lines }: Piece): ReadonlyMap<string, Piece> {
  const sections = new Map<string, { line: number; lines: string[] }>([["", { line, lines: [] }]]);
  let current = "";
  for (const [index, text] of lines.entries()) {
    const heading = /^#+\s+(.*?)\s*$/.exec(text)?.[1];
    if (heading === undefined) {
      sections.get(current)?.lines.push(text);
      continue;
    }
    if (!text.startsWith("## ") || !SECTIONS.includes(heading))
      throw new Mistake(line + index, `“${text}” is no heading of a step; there are ## ${SECTIONS.join(", ## ")}`);
    if (sections.has(heading)) throw new Mistake(line + index, `## ${heading} stands here twice`);
    sections.set(heading, { line: line + index + 1, lines: [] });
    current = heading;
  }
  return sections;
}

function prose({ line, lines }: Piece, isKnown: (address: string) => boolean): string {
  try {
    return htmlOf(lines.join("\n"), isKnown);
  } catch (error) {
    throw error instanceof Mistake ? new Mistake(line + error.line, error.message) : error;
  }
}

function titleOf({ line, value }: Entry): string {
  try {
    return inlineOf(value);
  } catch (error) {
    throw error instanceof Mistake ? new Mistake(line, error.message) : error;
  }
}

/** What the address of the step's frame asks for. */
function frameOf(block: Block): string {
  const [show] = all(block, "show");
  const query = new URLSearchParams({ embed: show?.value ?? "result" });
  const parts = ["controls", "sliders", "a", "b"].flatMap((name) => all(block, name).map((entry) => ({ name, entry })));
  for (const { name, entry } of parts) {
    if ((name === "a" || name === "b") && show?.value !== "compare")
      throw new Mistake(entry.line, `${name} is for show: compare`);
    query.set(name, entry.value);
    at(entry, () => asked(`?embed=compare&${new URLSearchParams({ [name]: entry.value })}`));
  }
  if (show) at(show, () => asked(`?embed=${encodeURIComponent(show.value)}`));
  return query.toString();
}

/** A link's text, of curves or of surfaces. */
function checkState(entry: Entry, isCompared: boolean): void {
  at(entry, () => {
    if (isCompared && new URLSearchParams(entry.value).has("space"))
      throw new Error("surfaces cannot be compared side by side");
    tryState(entry.value);
  });
}

/** Throws a sentence's part where the page could not show it. */
export function tryState(state: string): void {
  if (!new URLSearchParams(state).has("space")) {
    decode(state);
    return;
  }
  const { reference, template } = decodeSolid(state);
  for (const id of [reference, template]) if (!surface(id)) throw new Error(`there is no surface “${id}”`);
}

function checksOf(block: Block, name: "check" | "holds"): Check[] {
  return all(block, name).map((entry) => at(entry, () => parseCheck(entry.value)));
}

/** What goes wrong is at the line of the entry. */
function at<T>({ line }: Entry, read: () => T): T {
  try {
    return read();
  } catch (error) {
    throw new Mistake(line, error instanceof Error ? error.message : String(error));
  }
}

function all(block: Block, name: string): readonly Entry[] {
  return block.entries.get(name) ?? [];
}

function needed(block: Block, name: string): Entry {
  const [entry] = all(block, name);
  if (!entry || entry.value === "") throw new Mistake(entry?.line ?? block.line, `${name}: is missing here`);
  return entry;
}

function onlyKeys(block: Block, keys: readonly string[], what: string): void {
  for (const [key, [entry]] of block.entries)
    if (!keys.includes(key)) throw new Mistake(entry.line, `${what} has no “${key}”; it has ${keys.join(", ")}`);
}

function wholeNumber({ line, value }: Entry): number {
  if (!/^[1-9]\d*$/.test(value)) throw new Mistake(line, `minutes is “${value}”, which must be a whole number`);
  return Number(value);
}
