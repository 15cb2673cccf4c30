/** The live picture beside a lesson: the page in a frame, spoken to as any page would (docs/embedding.md). */

import { decode } from "../link/text";
import { FIELDS } from "../settings";
import { language } from "../words/language";
import { type Check, evaluate, type Known, numberIn, type Outcome } from "./checks";

type Report = {
  readonly state: string;
  readonly finished: boolean;
  readonly match: object | null;
};
type Answer =
  | { readonly kind: "done" }
  | { readonly kind: "report"; readonly report: Report }
  | { readonly kind: "mapped"; readonly points: readonly (readonly [number, number])[] }
  | { readonly kind: "refused"; readonly message: string };

/** How long an answer may take: it needs no computation. */
const PATIENCE_MILLIS = 5000;

export function addressOf(frame: string, state: string): string {
  const query = `${frame}&origin=${encodeURIComponent(location.origin)}&lang=${language.peek()}`;
  return `./index.html?${query}#${state}`;
}

let last = 0;

/** Rejects where no answer comes. */
export function ask(target: Window, message: object): Promise<Answer> {
  last += 1;
  const id = last;
  return new Promise((resolve, reject) => {
    const listening = new AbortController();
    const patience = setTimeout(() => {
      listening.abort();
      reject(new Error("no answer"));
    }, PATIENCE_MILLIS);
    const hear = ({ data, source }: MessageEvent) => {
      if (source !== target || data?.thinshell !== 1 || data.id !== id) return;
      clearTimeout(patience);
      listening.abort();
      resolve(data);
    };
    addEventListener("message", hear, { signal: listening.signal });
    target.postMessage({ thinshell: 1, id, ...message }, location.origin);
  });
}

/** What has come of the checks; null where nothing that is chosen now has been matched. */
export async function checked(
  target: Window,
  checks: readonly Check[],
  given: string,
): Promise<readonly Outcome[] | null> {
  const answer = await ask(target, { kind: "get" });
  if (answer.kind !== "report") throw new Error("no report");
  const { report } = answer;
  if (!report.finished || !report.match) return null;
  const points = checks.flatMap((check) => (check.kind === "point" ? [check.from] : []));
  const mapped = points.length > 0 ? await ask(target, { kind: "map", points }) : null;
  if (mapped && mapped.kind !== "mapped") return null;
  const known = knownFrom(report.state, given, report.match, (point) => {
    const index = points.indexOf(point);
    return mapped?.points[index] ?? [Number.NaN, Number.NaN];
  });
  return checks.map((check) => evaluate(check, known));
}

/** `state` is what is there, `given` what the lesson began with. */
export function knownFrom(state: string, given: string, numbers: object, map: Known["map"]): Known {
  const curves = state.includes("space=") ? null : decode(state);
  const chosen: Readonly<Record<string, unknown>> = curves?.settings ?? {};
  return {
    number: (name) => numberIn(numbers, name),
    setting: (name) => {
      const field = FIELDS.find((candidate) => candidate.name === name);
      return (chosen[name] ?? field?.initial ?? "") as number | string | boolean;
    },
    pins: curves?.pins.length ?? 0,
    shapesKept: shapesIn(state) === shapesIn(given),
    map,
  };
}

/** What a link says of the shapes alone: an untouched example by its name, others point for point. */
function shapesIn(state: string): string {
  const query = new URLSearchParams(state);
  return ["preset", "reference", "template"].map((name) => query.get(name) ?? "").join(" ");
}
