/** The two shapes. What code, links, files and the solver's interface call the template is the target in every sentence. */

export type Side = "reference" | "template";

export const SIDES: Readonly<Record<Side, string>> = { reference: "reference", template: "target" };

/** A sentence of the solver, which names the fields of its interface. */
export function sidesSaid(english: string): string {
  return english.replace(/\btemplate\b/g, SIDES.template);
}
