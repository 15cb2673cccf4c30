/** How a morph plays: parts of the way over time. */

export type Play = "once" | "loop" | "swing";

export const PLAYS: readonly Play[] = ["once", "loop", "swing"];

/** From one end to the other. */
export const WAY_MILLIS = 2200;
/** At the end, before it begins again or turns. */
export const REST_MILLIS = 500;

/** Part 0…1 of the way after so many milliseconds; null when it is over. Smooth at both ends. */
export function partAt(play: Play, millis: number): number | null {
  const leg = WAY_MILLIS + REST_MILLIS;
  if (play === "once") return millis >= WAY_MILLIS ? null : eased(millis);
  if (play === "loop") return eased(millis % leg);
  const there = millis % (2 * leg);
  return there < leg ? eased(there) : 1 - eased(there - leg);
}

function eased(millis: number): number {
  return (1 - Math.cos(Math.PI * Math.min(1, Math.max(0, millis / WAY_MILLIS)))) / 2;
}
