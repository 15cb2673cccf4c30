/**
 * What the page that holds a frame can say to it, and what it hears: docs/embedding.md. Every message is
 * `{thinshell: 1, kind, id?, …}`; an answer has the `id` of what it answers. Only the parent window is obeyed, and of
 * the origin that the frame's address names where it names one. What is refused has changed nothing.
 */

/** What a frame does when it is asked. */
export type Host<Report> = {
  /** Throws a sentence's part where it cannot be read; then nothing has changed. */
  set(state: string): void;
  report(): Report;
  /** φ at points; null without a match. Throws where there is none to be had. */
  map(points: readonly (readonly [number, number])[]): readonly (readonly [number, number])[] | null;
};

export type Answer<Report> = { readonly thinshell: 1; readonly id?: string | number } & (
  | { readonly kind: "done" }
  | { readonly kind: "report"; readonly report: Report }
  | { readonly kind: "mapped"; readonly points: readonly (readonly [number, number])[] }
  | { readonly kind: "refused"; readonly message: string }
);

/** Where a message comes from. */
export type Sender = { readonly isParent: boolean; readonly origin: string };

/** Letters of a state: some hundred times a drawn pair. */
export const MOST_LETTERS = 200_000;
export const MOST_POINTS = 10_000;

/** Names of a message's kinds, each with what it must hold. */
const KINDS: Readonly<Record<string, readonly string[]>> = { set: ["state"], get: [], map: ["points"] };

/** What is answered; null to what is not for this page, such as the messages of browser extensions. */
export function answer<Report>(
  data: unknown,
  sender: Sender,
  origin: string | null,
  host: Host<Report>,
): Answer<Report> | null {
  if (typeof data !== "object" || data === null || !Object.hasOwn(data, "thinshell")) return null;
  const message = data as Readonly<Record<string, unknown>>;
  // Not to be answered, or two frames would talk for ever.
  if (message.kind === "refused") return null;
  const { id } = message;
  const head = { thinshell: 1, ...((typeof id === "string" || Number.isFinite(id)) && { id }) } as { thinshell: 1 };
  try {
    if (!sender.isParent) throw new Error("only the page that holds this frame is answered");
    if (origin !== null && sender.origin !== origin)
      throw new Error(`only ${origin} is answered, as this frame's address says`);
    return { ...head, ...obeyed(message, host) };
  } catch (error) {
    return { ...head, kind: "refused", message: error instanceof Error ? error.message : String(error) };
  }
}

function obeyed<Report>(message: Readonly<Record<string, unknown>>, host: Host<Report>) {
  const { thinshell, kind, state, points } = message;
  if (thinshell !== 1) throw new Error("thinshell must be 1, the version of these messages");
  if (typeof kind !== "string" || !Object.hasOwn(KINDS, kind))
    throw new Error(`kind must be one of ${Object.keys(KINDS).join(", ")}`);
  const known = ["thinshell", "kind", "id", ...KINDS[kind]];
  const other = Object.keys(message).find((name) => !known.includes(name));
  if (other !== undefined) throw new Error(`a message of kind ${kind} has no “${other.slice(0, 40)}”`);
  if (kind === "set") {
    if (typeof state !== "string") throw new Error("state must be a text: what stands behind the # of a link");
    if (state.length > MOST_LETTERS) throw new Error(`state must have at most ${MOST_LETTERS} letters`);
    host.set(state.replace(/^#/, ""));
    return { kind: "done" } as const;
  }
  if (kind === "get") return { kind: "report", report: host.report() } as const;
  const mapped = host.map(pointsFrom(points));
  if (!mapped) throw new Error("there is no match yet; wait for “finished”");
  return { kind: "mapped", points: mapped } as const;
}

function pointsFrom(value: unknown): readonly (readonly [number, number])[] {
  const isPoint = (one: unknown): one is [number, number] =>
    Array.isArray(one) &&
    one.length === 2 &&
    Array.from(one).every((part) => Number.isFinite(part) && part >= 0 && part <= 1);
  // Of a list with holes `every` would not see them.
  if (Array.isArray(value) && value.length <= MOST_POINTS && Array.from(value).every(isPoint)) return value;
  throw new Error(`points must be a list of at most ${MOST_POINTS} points [x, y] of the box, from 0 to 1`);
}
