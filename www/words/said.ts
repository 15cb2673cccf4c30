/** What the page says of a run, made of its state alone. */

import { isDone, isFollowing, isPaused, type Phase } from "../phase";
import type { Status } from "../protocol";
import { en as words } from "./en";
import { decimals } from "./numbers";

export type Told = {
  readonly phase: Phase;
  /** The solver has been fetched. */
  readonly loaded: boolean;
  /** Of the run under way, once it has a frame. */
  readonly status: Status | null;
  /** What is shown was computed with other settings, or with other pins. */
  readonly stale: boolean;
  readonly otherPins?: boolean;
};

export function staleness({ outdated }: { readonly outdated: { readonly value: "settings" | "pins" | null } }) {
  return { stale: outdated.value !== null, otherPins: outdated.value === "pins" };
}

/** The one sentence under the picture. */
export function headline({ phase, loaded, status, stale, otherPins }: Told): string {
  const { status: say } = words;
  switch (phase) {
    case "idle":
      return say.ready;
    case "cancelled":
      return say.cancelled;
    case "preparing":
      return loaded ? say.preparing : say.loading;
    case "following":
    case "astray":
      return say.following;
    case "paused":
    case "pausedRefining":
      return say.paused;
  }
  if (!isDone(phase)) return status ? say.on(say.approach(status), gridName(status.level)) : say.matching;
  if (!status) return say.shapesChanged;
  if (stale) return otherPins ? say.pinsChanged : say.settingsChanged;
  return verdict(status);
}

/** How the match ended, and what that means for the eye. */
export function verdict(status: Status): string {
  return words.status.verdict(status) ?? words.status.stop(status);
}

/** The state, for those who do not see the picture. */
export function resultState({ phase, status, stale, otherPins }: Omit<Told, "loaded">): string {
  const { result: say } = words;
  if (!status) return phase === "preparing" ? say.starting : say.none;
  if (stale) return otherPins ? say.otherPins : say.stale;
  if (isDone(phase)) {
    const most = Math.max(status.mismatch.max, status.cover.max);
    return Number.isFinite(most) ? say.matched(decimals(most)) : say.blind;
  }
  const doing = isPaused(phase) ? "paused" : isFollowing(phase) ? "following" : "matching";
  return say.on(say.doing[doing], 2 ** status.level + 1);
}

export function gridName(level: number): string {
  const side = 2 ** level + 1;
  return `${side} × ${side}`;
}

/** A distance in cells of the grid. There is none where no part of the curve lies on the grid that was matched. */
export function cells(distance: number): { readonly text: string; readonly unit: string } {
  const { numbers: say } = words;
  return Number.isFinite(distance) ? { text: decimals(distance), unit: say.cells } : { text: say.noCells, unit: "" };
}
