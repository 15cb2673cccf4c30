/** The shapes of a file as a batch takes them: every part of each, fitted into the box. */

import { begun, selectionOf, withChoice } from "../controls/importDraft";
import type { Offer, Outcome, Selection } from "../shapes/import/content";
import { type Subject, subjectOf } from "./subject";

/** A shape, or why it is none. */
export type Taken = { readonly name: string } & ({ readonly subject: Subject } | { readonly problem: string });

/**
 * Of lists every shape, of a drawing all of it together; where only the outline is wanted, of each its largest part,
 * without holes. `prepare` is asked one by one.
 */
export async function subjectsIn(
  offer: Offer,
  file: string,
  outline: boolean,
  prepare: (wishes: Selection) => Outcome | Promise<Outcome>,
): Promise<Taken[]> {
  const stem = file.replace(/^.*[/\\]/, "").replace(/\.\w+$/, "");
  const taken: Taken[] = [];
  const draft = begun(offer, file, null);
  const count = offer.firstIsAll ? 1 : Math.max(1, offer.choices.length);
  for (let chosen = 0; chosen < count; chosen += 1) {
    const choice = offer.choices[chosen];
    const usual: Selection = { ...selectionOf(withChoice(draft, chosen)), placement: "fit" };
    const wishes: Selection = outline ? { ...usual, parts: "largest", holes: "fill" } : usual;
    const { prepared, problem } = await prepare(wishes);
    // A file of one shape is known by its own name, unless the shape has been given one by hand.
    const name = choice && (count > 1 || choice.marks) ? choice.name : stem;
    if (prepared) taken.push({ name, subject: subjectOf(name, choice ?? {}, prepared) });
    else taken.push({ name, problem: problem ?? "The shape cannot be taken." });
  }
  return taken;
}

/** Gives each name once, whatever its capitals: one that has been there before gets a number. */
export function distinct(): (name: string) => string {
  const given = new Set<string>();
  return (name) => {
    let unlike = name;
    for (let i = 2; given.has(unlike.toLowerCase()); i += 1) unlike = `${name} (${i})`;
    given.add(unlike.toLowerCase());
    return unlike;
  };
}
