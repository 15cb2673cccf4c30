/** What the solver came to, said in German from its facts. */

import { afterAll, beforeAll, expect, test } from "vitest";
import type { Inspection, Status } from "../protocol";
import { en } from "./en";
import { speak } from "./language";
import { headline, resultState, verdict } from "./said";

beforeAll(() => speak("de"));
afterAll(() => speak("en"));

const NONE = [-1, -1, -1, -1, -1, -1];

function status(facts: readonly number[], more: Partial<Status> = {}): Status {
  return {
    finished: true,
    stop: "Converged: the energy falls by less than the tolerance.",
    level: 6,
    iteration: 12,
    evaluations: 40,
    energies: { membrane: 0, bending: 0, mismatch: 0, volume: 0, pins: 0, total: 0 },
    leastDeterminant: 0.5,
    mismatch: { mean: 0.01, max: 0.02 },
    cover: { mean: 0.01, max: 0.03 },
    stretch: { mean: 1, deviation: 0 },
    measure: 1,
    backend: "cpu",
    verdict: "Fits: nowhere more than 0.03 cells off.",
    approach: "Matching the reference with the target",
    facts: Float64Array.from(facts),
    ...more,
  };
}

const far = { mismatch: { mean: 1, max: 2 }, cover: { mean: 1, max: 3.456 } };

test.each([
  [[4, 1, 1, 2, 0.5, 0.5, ...NONE], {}, "Passt: nirgends mehr als 0,03 Zellen daneben, zu wenig, um es zu sehen."],
  [
    [4, 1, 1, 2, 0.5, 0.5, ...NONE],
    { cover: { mean: 0.01, max: 0.0506 } },
    "Passt: nirgends mehr als 0,06 Zellen daneben, zu wenig, um es zu sehen.",
  ],
  [
    [4, 1, 1, 2, 0.5, 0.5, ...NONE],
    { cover: { mean: 0.01, max: 0.5 } },
    "Passt: nirgends mehr als 0,50 Zellen daneben.",
  ],
  [
    [0, 1, 2, 1, 0.25, 0.5, ...NONE],
    far,
    "Ein Teil gegen zwei Teile: Keine Verformung führt die eine Form in die andere über. Der größte Abstand ist 3,46 Zellen: Der Teil bei (0,25; 0,50) wurde nicht erreicht.",
  ],
  [
    [2, 0, 1, 0, 0.5, 0.5, ...NONE],
    far,
    "Keine Löcher gegen ein Loch: Keine Verformung führt die eine Form in die andere über. Der größte Abstand ist 3,46 Zellen: Das Loch bei (0,50; 0,50) wurde nicht erreicht.",
  ],
  [
    [1, 1, 1, 0, 0.5, 0.5, ...NONE],
    { cover: { mean: 1, max: 1.26 } },
    "Passt, aber das Loch bei (0,50; 0,50) wurde nicht erreicht: Der Abstand ist 1,3 Zellen.",
  ],
  [
    [3, 1, 1, 3, 0.1, 0.9, ...NONE],
    { measure: 1.3, mismatch: { mean: 1, max: 2 } },
    "Zerknittert (Längenverhältnis 1,30). Der größte Abstand ist 2,00 Zellen, bei (0,10; 0,90). Die bewegte Kurve liegt in Falten: Sie ist 1,3-mal so lang wie das Ziel.",
  ],
  [
    [5, 1, 1, 2, 0.5, 0.5, 1, 0.8, 0.5, 0.4, 1, 9],
    far,
    "Dieses Gitter löst die Form nicht auf: die engste Lücke des Ziels, bei (0,50; 0,40), ist 0,8 Zellen breit; ein Gitter mit 513² Knoten löst das auf. Der größte Abstand ist 3,46 Zellen: Der Umriss bei (0,50; 0,50) wurde nicht erreicht.",
  ],
  [
    [6, 1, 1, 3, 0.5, 0.5, ...NONE],
    { mismatch: { mean: 1, max: 2 } },
    "Passt nicht. Der größte Abstand ist 2,00 Zellen, bei (0,50; 0,50).",
  ],
] as const)("the verdict of %j is German", (facts, more, words) => {
  const found = status([0, 0, ...facts], { verdict: "English", ...more });
  expect(verdict(found)).toBe(words);
});

test("without facts, as in files of before and of surfaces, the solver's own words are said again", () => {
  expect(verdict(status([]))).toBe("Passt: nirgends mehr als 0,03 Zellen daneben.");
  expect(en.status.stop(status([]))).toBe("Converged: the energy falls by less than the tolerance.");
  expect(verdict(status([2.5, Number.NaN, 99, 1, 1, 7]))).toBe("Passt: nirgends mehr als 0,03 Zellen daneben.");
});

test("every reason to end and every approach has a sentence of its own", () => {
  const stops = [0, 1, 2, 3, 4, 5].map((stop) => en.status.stop(status([stop])));
  const approaches = [0, 1, 2, 3, 4, 5, 6].map((approach) => en.status.approach(status([-1, approach])));
  expect(new Set(stops).size).toBe(6);
  expect(new Set(approaches).size).toBe(7);
  for (const sentence of stops) expect(sentence).toMatch(/^(Konvergiert|Angehalten|Fertig): .*\.$/);
  for (const sentence of approaches) expect(sentence).not.toMatch(/Matching|Sharpening|Refining/);
});

test("what the grid does not resolve is said, with the grid that does, or that none does", () => {
  const inspection = (facts: readonly number[]): Inspection => ({
    words: "English",
    level: null,
    facts: Float64Array.from(facts),
  });
  expect(en.status.unresolved(inspection([0, 0.01, 0.5, 0.25, 0, 0]))).toBe(
    "Der Umriss der Referenz berührt sich selbst bei (0,50; 0,25); nicht einmal ein Gitter mit 513² Knoten löst das auf, machen Sie die Stelle breiter.",
  );
  expect(en.status.unresolved(inspection([1, 1.25, 0.5, 0.25, 0, 8]))).toBe(
    "Die engste Stelle des Ziels, bei (0,50; 0,25), ist 1,3 Zellen breit; ein Gitter mit 257² Knoten löst das auf.",
  );
  expect(en.status.unresolved({ words: null, level: null, facts: Float64Array.from(NONE) })).toBeNull();
});

test("the state is told in German, with numbers", () => {
  const told = { phase: "solving", loaded: true, stale: false, status: status([-1, 3]) } as const;
  expect(headline(told)).toBe(
    "Schärfen: Das Ziel zieht stärker, am meisten, wo es verfehlt wurde, auf dem Gitter 65 × 65 …",
  );
  expect(resultState({ ...told, phase: "matched" })).toBe(
    "abgeglichen, höchstens 0,03 Zellen daneben, keine Zelle gefaltet",
  );
  expect(resultState(told)).toBe("Abgleich läuft, auf dem Gitter 65 mal 65");
});
