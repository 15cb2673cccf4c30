// One case: shapes and settings, a registration, and calls in an order that nobody would choose.

import { Defect, demand, judgeAnswers, judgeStatus, unclear } from "./judge.mjs";
import { Random } from "./random.mjs";
import { makeSettings } from "./settings.mjs";
import { goodCurve, makeShape } from "./shapes.mjs";

/** Turns of the event loop that a promise may take: the solver needs none. */
const TURNS = 3;
const NONSENSE = [0, -1, 1.5, Number.NaN, Infinity, 2 ** 40, "5", null, undefined, {}, Symbol("n")];

/** @typedef {{ outcome: "right" | "refused" | "defect", story: string[], defects: string[] }} Verdict */

/** @param {any} Registration @param {number} seed @returns {Promise<Verdict>} */
export async function runCase(Registration, seed) {
  const random = new Random(seed);
  /** @type {Verdict} */
  const verdict = { outcome: "right", story: [], defects: [] };
  const plain = random.chance(0.5);
  const reference = plain ? goodCurve(random) : makeShape(random);
  const template = plain || random.chance(0.6) ? goodCurve(random) : makeShape(random);
  const { name, settings, expected } = makeSettings(random);
  verdict.story.push(`create(${reference.name}, ${template.name}, ${name})`);

  const answer = await settled(() => Registration.create(reference.shape, template.shape, settings));
  const all = [reference.expected, template.expected, expected];
  if ("value" in answer) {
    if (all.includes("refused")) verdict.defects.push("what is no input was taken");
    await use(answer.value, random, verdict).catch((problem) => note(verdict, problem));
  } else {
    verdict.outcome = "refused";
    verdict.story.push(answer.problem instanceof Error ? answer.problem.message : String(answer.problem));
    refuse(verdict, answer.problem);
    if (all.every((each) => each === "right")) verdict.defects.push("what is in order was refused");
  }
  if (verdict.defects.length > 0) verdict.outcome = "defect";
  return verdict;
}

/** @param {any} registration @param {Random} random @param {Verdict} verdict */
async function use(registration, random, verdict) {
  let status = await stepped(registration, 1, verdict);
  judgeAnswers(registration, status);
  for (let call = random.whole(0, 8); call > 0; call--) {
    const kind = random.unit();
    if (kind < 0.35) status = await stepped(registration, random.whole(1, 6), verdict);
    else if (kind < 0.5) await update(registration, random, verdict);
    else if (kind < 0.65) await interleave(registration, random, verdict);
    else if (kind < 0.9) await nonsense(registration, random, verdict);
    else judgeAnswers(registration, await stepped(registration, 1, verdict));
  }
  // Whatever was refused in between, the object stays usable.
  judgeAnswers(registration, await stepped(registration, 1, verdict));
  await end(registration, random, verdict);
}

/** @param {any} registration @param {number} iterations @param {Verdict} verdict */
async function stepped(registration, iterations, verdict) {
  verdict.story.push(`step(${iterations})`);
  const answer = await settled(() => registration.step(iterations));
  if (!("value" in answer)) throw new Defect(`a step is refused: ${answer.problem}`);
  judgeStatus(answer.value);
  return answer.value;
}

/** @param {any} registration @param {Random} random @param {Verdict} verdict */
async function update(registration, random, verdict) {
  const change = makeChange(random, verdict);
  const answer = await settled(() => registration.update(change));
  if ("value" in answer) judgeStatus(answer.value);
  else refuse(verdict, answer.problem);
}

/** @param {Random} random @param {Verdict} verdict */
function makeChange(random, verdict) {
  /** @type {Record<string, unknown>} */
  const change = {};
  for (const side of ["reference", "template"])
    if (random.chance(0.4)) {
      const { name, shape } = makeShape(random);
      change[side] = shape;
      verdict.story.push(`${side}: ${name}`);
    }
  if (random.chance(0.4)) change.settings = makeSettings(random).settings;
  verdict.story.push("update");
  return random.chance(0.05) ? random.pick([null, undefined, 3, "x"]) : change;
}

/** Calls while others are under way. @param {any} registration @param {Random} random @param {Verdict} verdict */
async function interleave(registration, random, verdict) {
  verdict.story.push("interleaved");
  const waiting = Array.from({ length: random.whole(1, 4) }, () =>
    settled(() =>
      random.chance(0.8) ? registration.step(random.whole(1, 3)) : registration.update(makeChange(random, verdict)),
    ),
  );
  for (const ask of asking(registration, random)) {
    try {
      ask();
      verdict.defects.push("an answer was given while a step was under way");
    } catch (problem) {
      refuse(verdict, problem, /under way/);
    }
  }
  for (const answer of await Promise.all(waiting))
    if ("value" in answer) judgeStatus(answer.value);
    else refuse(verdict, answer.problem);
}

/** @param {any} registration @param {Random} random @returns {(() => unknown)[]} */
function asking(registration, random) {
  const some = Float64Array.of(0.5, 0.5);
  const all = [
    () => registration.deformation(),
    () => registration.curves(),
    () => registration.map(some),
    () => registration.inverseMap(some),
  ];
  return all.filter(() => random.chance(0.5));
}

/** @param {any} registration @param {Random} random @param {Verdict} verdict */
async function nonsense(registration, random, verdict) {
  const what = random.pick(["step", "map", "inverseMap", "evaluate"]);
  const input =
    what === "step"
      ? random.pick(NONSENSE)
      : random.pick([
          ...NONSENSE,
          [0.5, 0.5],
          Float64Array.of(1),
          Float64Array.of(0.5, Number.NaN),
          new Float32Array(2),
        ]);
  verdict.story.push(`${what}(${String(input)})`);
  const answer = await settled(() => registration[what](input));
  if ("value" in answer) verdict.defects.push(`${what} takes nonsense: ${String(input)}`);
  else refuse(verdict, answer.problem);
}

/** @param {any} registration @param {Random} random @param {Verdict} verdict */
async function end(registration, random, verdict) {
  const under = random.chance(0.3) ? settled(() => registration.step(2)) : null;
  verdict.story.push(under ? "free under way" : "free");
  registration.free();
  registration.free();
  const after = [...asking(registration, random), () => registration.step(1), () => registration.update({})];
  for (const ask of after) {
    const answer = await settled(ask);
    if ("value" in answer) verdict.defects.push("a freed registration answers");
    else refuse(verdict, answer.problem, /freed/);
  }
  const answer = await under;
  if (answer && "value" in answer) judgeStatus(answer.value);
  else if (answer) refuse(verdict, answer.problem, /freed/);
}

/** @param {Verdict} verdict @param {unknown} problem @param {RegExp} [about] */
function refuse(verdict, problem, about) {
  const what = unclear(problem);
  if (what !== null) verdict.defects.push(what);
  else if (about && !about.test(/** @type {Error} */ (problem).message))
    verdict.defects.push(`not about ${about}: ${/** @type {Error} */ (problem).message}`);
}

/** @param {Verdict} verdict @param {unknown} problem */
function note(verdict, problem) {
  verdict.defects.push(
    problem instanceof Error ? (problem instanceof Defect ? problem.message : String(problem.stack)) : String(problem),
  );
}

/**
 * What becomes of a call: a value or a problem. A promise still pending after some turns of the event loop is a defect.
 *
 * @param {() => unknown} call
 * @returns {Promise<{ value: any } | { problem: unknown }>}
 */
async function settled(call) {
  /** @type {{ value: any } | { problem: unknown } | null} */
  let end = null;
  try {
    const answer = call();
    if (!(answer instanceof Promise)) return { value: answer };
    answer.then(
      (value) => {
        end = { value };
      },
      (problem) => {
        end = { problem };
      },
    );
  } catch (problem) {
    return { problem };
  }
  for (let turn = 0; end === null && turn < TURNS; turn++) await new Promise((resolve) => setImmediate(resolve));
  if (end === null) throw new Defect("a promise stays pending");
  demand(end !== null, "a promise is settled");
  return end;
}
