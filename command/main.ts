/** `thinshell match`: one reference with many targets, from the command line. */

import { readFileSync } from "node:fs";
import { setImmediate } from "node:timers/promises";
import { matched, type Plan } from "../www/batch/match";
import type { Subject } from "../www/batch/subject";
import { distinct, type Taken } from "../www/batch/subjects";
import { counts, type Row } from "../www/batch/tables";
import { evenPoints } from "../www/morphometrics/semilandmarks";
import type { Status } from "../www/protocol";
import init, { Registration } from "../www/wasm/thinshell.js";
import { sidesSaid } from "../www/words/sides";
import { Refusal, USAGE, type Wanted, wantedIn } from "./arguments";
import { provideParser } from "./drawing";
import { filesIn, read } from "./files";
import { Output, printed } from "./output";

/** The end that Ctrl-C asks for; a second one ends at once. */
const INTERRUPTED = 130;

const cancelling = new AbortController();

async function main(): Promise<void> {
  const wanted = wantedIn(process.argv.slice(2));
  if (wanted === "help") console.log(USAGE);
  else if (wanted === "version") {
    console.log(JSON.parse(readFileSync(new URL("../package.json", import.meta.url), "utf8")).version);
  } else {
    process.once("SIGINT", () => cancelling.abort());
    await batch(wanted);
  }
}

async function batch(wanted: Wanted): Promise<void> {
  provideParser();
  await init();
  const reference = await referenceIn(wanted);
  const plan: Plan = { reference, points: evenPoints(reference.shape, wanted.points), settings: wanted.settings };
  const files = filesIn(wanted.targets);
  const output = new Output(wanted.out, plan, wanted.strains);
  const name = distinct();
  name(reference.name);
  const rows: Row[] = [];
  for (const [i, file] of files.entries()) {
    for (const taken of await targetsIn(file, wanted.outline)) {
      if (cancelling.signal.aborted) break;
      const row = await rowOf(plan, taken, file, name(taken.name), `${i + 1}/${files.length}`);
      if (!row) break;
      if (row.match) output.match(row, row.match);
      rows.push(row);
      output.tables(rows);
    }
    if (cancelling.signal.aborted) break;
  }
  if (rows.length > 0) console.log(printed(rows));
  const { matched: good, fitting } = counts(rows);
  const cancelled = cancelling.signal.aborted;
  const count = `${good} of ${rows.length} matched, ${fitting} of them fit${cancelled ? ", then cancelled" : ""}`;
  console.log(`${count}; written to ${wanted.out}.`);
  process.exitCode = cancelled ? INTERRUPTED : good === rows.length ? 0 : 1;
}

async function referenceIn({ reference: file, outline }: Wanted): Promise<Subject> {
  const [taken, ...more] = await read(file, outline).catch((error) => {
    throw new Refusal(`${file}: ${reason(error)}`);
  });
  if (!("subject" in taken)) throw new Refusal(`${file}: ${taken.problem}`);
  if (more.length > 0)
    console.error(`${file} holds ${more.length + 1} shapes; the first, ${taken.name}, is the reference.`);
  return taken.subject;
}

/** A file that cannot be read is a row of the table, too. */
async function targetsIn(file: string, outline: boolean): Promise<Taken[]> {
  return read(file, outline).catch((error) => [{ name: file.replace(/^.*[/\\]/, ""), problem: reason(error) }]);
}

/** Null where it was cancelled on the way. */
async function rowOf(plan: Plan, taken: Taken, file: string, name: string, count: string): Promise<Row | null> {
  const failed = (outcome: string): Row => ({ name, file, outcome, target: null, match: null });
  const begin = `${count}  ${name}`;
  let row: Row;
  if ("problem" in taken) row = failed(taken.problem);
  else {
    try {
      const match = await matched({ Registration }, plan, taken.subject, async ({ level, iteration }: Status) => {
        progress(`${begin}: grid ${2 ** level + 1} × ${2 ** level + 1}, iteration ${iteration}`);
        // Lets Ctrl-C be heard.
        await setImmediate();
        cancelling.signal.throwIfAborted();
      });
      const { verdict, stop } = match.status;
      const outcome = [verdict ?? stop, match.note].filter(Boolean).join(" ");
      row = { name, file, outcome, target: taken.subject, match };
    } catch (error) {
      if (cancelling.signal.aborted) return null;
      row = failed(sidesSaid(reason(error)));
    }
  }
  progress("");
  console.error(`${begin}: ${row.outcome}`);
  return row;
}

/** One line that is written over, where somebody looks. */
function progress(text: string): void {
  if (process.stderr.isTTY) process.stderr.write(`\r\x1b[K${text}`);
}

function reason(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

main().catch((error) => {
  console.error(error instanceof Refusal ? `${error.message}\n\nthinshell --help says how it is used.` : error);
  process.exitCode = 2;
});
