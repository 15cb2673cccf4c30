/** Was der Löser auf Englisch sagt, aus denselben Tatsachen. */

import type { Inspection, Status } from "../../protocol";
import {
  type Approach,
  approachOf,
  isSeen,
  type Stop,
  stopOf,
  type Unresolved,
  unresolvedOf,
  type Verdict,
  verdictOf,
} from "../facts";
import { decimals, written } from "../numbers";
import { again } from "./again";
import { capital, DES } from "./sides";

const STOPS: Readonly<Record<Stop, string>> = {
  converged: "Konvergiert: Die Energie fällt um weniger als die Toleranz.",
  creeping: "Angehalten: Zwanzig Iterationen senken die Energie um weniger als ein Hundertstel.",
  noDescent: "Angehalten: Kein Schritt in Abstiegsrichtung senkt die Energie weiter.",
  iterationLimit: "Angehalten: Die Höchstzahl der Iterationen auf einer Stufe ist erreicht.",
  refined: "Fertig: Ein auf anderem Weg gefundener Abgleich wurde mit wenigen Iterationen verfeinert.",
  bestOf: "Fertig: von mehreren Wegen des Abgleichs der beste.",
};

const APPROACHES: Readonly<Record<Approach, string>> = {
  direct: "Die Referenz wird mit dem Ziel abgeglichen",
  exchanged: "Umgekehrter Abgleich: das Ziel mit der Referenz",
  inverted: "Die Umkehrung des umgekehrten Abgleichs wird verfeinert",
  sharpened: "Schärfen: Das Ziel zieht stärker, am meisten, wo es verfehlt wurde",
  sharpenedExchanged: "Der umgekehrte Abgleich wird geschärft",
  guided: "Abgleich entlang einander entsprechender Punkte beider Umrisse",
  guidedExchanged: "Umgekehrter Abgleich entlang einander entsprechender Punkte beider Umrisse",
};

/** Ohne Tatsachen, wie in alten Dateien, bleibt, was der Löser sagt. */
export function stop({ facts, stop: english }: Status): string {
  const found = stopOf(facts);
  return found ? STOPS[found] : (english ?? "Fertig.");
}

export function approach({ facts, approach: english }: Status): string {
  const found = approachOf(facts);
  return found ? APPROACHES[found] : english;
}

export function verdict(status: Status): string | null {
  const found = status.verdict === null ? null : verdictOf(status.facts);
  return found ? sentence(found, status) : status.verdict && again(status.verdict);
}

export function unresolved({ facts, words }: Inspection): string | null {
  const found = unresolvedOf(facts);
  return found ? `${capital(narrow(found))}.` : words && again(words);
}

function sentence(found: Verdict, status: Status): string {
  const { kind, from, to } = found;
  const { mismatch, cover, measure } = status;
  const most = Math.max(mismatch.max, cover.max);
  const farthest = distances(found, most);
  switch (kind) {
    case "parts":
      return `${capital(counted(from, "Teil", "Teile"))} gegen ${counted(to, "Teil", "Teile")}: Keine Verformung führt die eine Form in die andere über. ${farthest}`;
    case "holes":
      return `${capital(counted(from, "Loch", "Löcher"))} gegen ${counted(to, "Loch", "Löcher")}: Keine Verformung führt die eine Form in die andere über. ${farthest}`;
    case "notReached": {
      const hint = found.unresolved ? ` ${capital(narrow(found.unresolved))}.` : "";
      return `Passt, aber ${missed(found)} wurde nicht erreicht: Der Abstand ist ${fixed(cover.max, 1)} Zellen.${hint}`;
    }
    case "crumpled":
      return `Zerknittert (Längenverhältnis ${fixed(measure, 2)}). ${farthest} Die bewegte Kurve liegt in Falten: Sie ist ${decimals(measure)}-mal so lang wie das Ziel.`;
    case "fits":
      return `Passt: nirgends mehr als ${fixed(Math.ceil(100 * most) / 100, 2)} Zellen daneben${isSeen(status) ? "" : ", zu wenig, um es zu sehen"}.`;
    case "unresolved":
      return `Dieses Gitter löst die Form nicht auf: ${found.unresolved ? narrow(found.unresolved) : ""}. ${farthest}`;
    case "misfit":
      return `Passt nicht. ${farthest}`;
  }
}

function distances(found: Verdict, most: number): string {
  const size = `Der größte Abstand ist ${fixed(most, 2)} Zellen`;
  return found.place === "moved"
    ? `${size}, bei ${at(found)}.`
    : `${size}: ${capital(missed(found))} wurde nicht erreicht.`;
}

function missed(found: Verdict): string {
  const what = { hole: "das Loch", part: "der Teil", outline: "der Umriss", moved: "der Umriss" }[found.place];
  return `${what} bei ${at(found)}`;
}

/** Liest sich hinter „…: “, ohne Punkt. */
function narrow({ side, part, width, level, ...place }: Unresolved): string {
  const what =
    width < 0.05
      ? `der Umriss ${DES[side]} berührt sich selbst bei ${at(place)}`
      : `die engste ${part === "gap" ? "Lücke" : "Stelle"} ${DES[side]}, bei ${at(place)}, ist ${fixed(width, 1)} Zellen breit`;
  return level === null
    ? `${what}; nicht einmal ein Gitter mit 513² Knoten löst das auf, machen Sie die Stelle breiter`
    : `${what}; ein Gitter mit ${2 ** level + 1}² Knoten löst das auf`;
}

const NUMBERS = ["kein", "ein", "zwei", "drei", "vier", "fünf", "sechs"];

function counted(count: number, one: string, many: string): string {
  const number = NUMBERS[count] ?? String(count);
  if (count === 0) return `keine ${many}`;
  return `${number} ${count === 1 ? one : many}`;
}

function at({ x, y }: { readonly x: number; readonly y: number }): string {
  return `(${fixed(x, 2)}; ${fixed(y, 2)})`;
}

function fixed(value: number, digits: number): string {
  return written(value.toFixed(digits));
}
