/** What the page starts with, and what a link opened over it shows. */

import { FIELDS } from "../settings";
import { PRESETS } from "../shapes/presets";
import { links as say } from "../words/links";
import { decode, overridden, type Saved } from "./text";

export type Opened = {
  readonly saved: Saved;
  /** Why the link, or what stands beside it in the address, was not read. */
  readonly problem: string | null;
  /** What was stored could not be read, as when a newer version of this page wrote it: it is to be left as it is. */
  readonly unread: boolean;
  /** The address does not hold what is shown: it comes from elsewhere, at least in part. */
  readonly unwritten: boolean;
  /** The link asks for the match to be left to a press: `match=later`, for those who are to guess it first. */
  readonly later: boolean;
};

export type Address = { readonly hash: string; readonly search: string };

/** What a link holds: null for an anchor of the page, such as #method. Throws a sentence's part. */
export function linkIn(hash: string): { readonly saved: Saved; readonly later: boolean } | null {
  const text = hash.replace(/^#/, "");
  if (!text.includes("=") && /^[\w-]*$/.test(text)) return null;
  return { saved: decode(text), later: isLater(new URLSearchParams(text)) };
}

/**
 * The link, else what was stored, else the first example; and single settings in the query (`?bending=0`) instead of
 * theirs. What cannot be read is reported and takes nothing away.
 */
export function open({ hash, search }: Address, stored: string | null): Opened {
  const query = new URLSearchParams(search);
  const later = isLater(query);
  const { last, why } = fromStorage(stored);
  const [unread, problem] = [why !== null, why && say.lost(why)];
  let opened: Opened = { saved: last ?? fallback(), problem, unread, unwritten: last !== null, later };
  try {
    const link = linkIn(hash);
    if (link) opened = { saved: link.saved, problem: null, unread, unwritten: false, later: later || link.later };
  } catch (error) {
    return { ...opened, problem: say.unread(reason(error)), unwritten: false };
  }
  if (!OVERRIDES.some((name) => query.has(name))) return opened;
  try {
    return { ...opened, saved: overridden(opened.saved, query), unwritten: true };
  } catch (error) {
    return { ...opened, problem: say.override(reason(error)), unwritten: true };
  }
}

/** What may stand in the query: it is in the fragment once the page has written that. */
const OVERRIDES: readonly string[] = [...FIELDS.map(({ name }) => name), "view", "morph", "match"];

/** The page's address with everything in the fragment. */
export function addressOf(text: string): string {
  const url = new URL(location.href);
  for (const name of OVERRIDES) url.searchParams.delete(name);
  url.hash = text;
  return url.href;
}

export function fallback(): Saved {
  const [{ id, reference, template }] = PRESETS;
  return { reference, template, pins: [], settings: {}, preset: id, view: "grid", morph: 1 };
}

export function reason(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

function isLater(query: URLSearchParams): boolean {
  return query.get("match") === "later";
}

function fromStorage(stored: string | null): { readonly last: Saved | null; readonly why: string | null } {
  try {
    return { last: stored === null ? null : decode(stored), why: null };
  } catch (error) {
    return { last: null, why: reason(error) };
  }
}
