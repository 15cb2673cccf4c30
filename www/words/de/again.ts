/**
 * Was Löser und Import auf Englisch sagen, noch einmal auf Deutsch: Satz für Satz nach Mustern. Was in deren Lücken
 * steht, wird ebenso gesagt, oder bleibt, wie es ist: Namen, und Zahlen mit Komma.
 */

import { imports } from "./again/imports";
import { solver } from "./again/solver";

/** Lücken, `{name}`, heißen in beiden Sprachen gleich. */
export type Patterns = Readonly<Record<string, string>>;

type Rule = { readonly english: RegExp; readonly german: string };

const HOLE = /\{(\w+)\}/g;

let known: readonly Rule[] = [];

/** Ein Satz ohne Muster lässt alles, wie es ist. */
export function again(english: string): string {
  if (known.length === 0) known = Object.entries({ ...imports, ...solver }).map(rule);
  const whole = said(english);
  if (whole !== null) return whole;
  const sentences = english.split(/(?<=[.!?]) (?=[A-Z])/).map(said);
  return sentences.includes(null) ? english : sentences.join(" ");
}

function rule([english, german]: [string, string]): Rule {
  const pattern = english
    .split(HOLE)
    // An jeder zweiten Stelle steht der Name einer Lücke.
    .map((text, i) => (i % 2 === 1 ? `(?<${text}>.+?)` : text.replace(/[.*+?^$(){}|[\]\\]/g, "\\$&")))
    .join("");
  return { english: new RegExp(`^${pattern}$`, "s"), german };
}

function said(english: string): string | null {
  for (const rule of known) {
    const found = rule.english.exec(english);
    if (found) return rule.german.replaceAll(HOLE, (_, name) => part(found.groups?.[name] ?? ""));
  }
  return null;
}

function part(text: string): string {
  const isNumbers = /^[\d.e,() −-]+$/.test(text);
  return (
    said(text) ?? (isNumbers ? text.replace(/, /g, "; ").replace(/(?<![\d.])(\d+)\.(\d+)(?![\d.])/g, "$1,$2") : text)
  );
}
