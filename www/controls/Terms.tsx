import { useRef } from "preact/hooks";
import type { Status } from "../protocol";
import type { Result } from "../run";
import type { Session } from "../session";
import { FIELDS, type SettingField } from "../settings";
import { hands } from "../tools/tool";
import { en } from "../words/en";
import { decimals } from "../words/numbers";
import { Sign } from "./Sign";

type Term = {
  readonly name: keyof Status["energies"] & keyof typeof en.terms.names;
  /** The setting that weighs it. */
  readonly weight: SettingField["name"];
  readonly off: number | null;
};

/** `off` leaves a term out, or as good as: without any volume term the plane could fold. None for what the fit is. */
const TERMS: readonly Term[] = [
  { name: "membrane", weight: "membrane", off: 0 },
  { name: "bending", weight: "bending", off: 0 },
  { name: "mismatch", weight: "penalty", off: null },
  { name: "volume", weight: "volume", off: 1e-6 },
];

/**
 * What the energy is made of, as a bar that follows the run, less what is there undeformed: else the plane's rest would
 * outweigh all that is of interest. The terms can be left out and taken in again.
 */
export function Terms({ session }: { session: Session }) {
  const result = session.result.value;
  const parts = TERMS.map((term) => {
    if (!result) return { ...term, energy: null, rest: 0 };
    const rest = restOf(result, term.name);
    return { ...term, energy: Math.max(0, result.frame.status.energies[term.name] - rest), rest };
  });
  const rest = parts.reduce((sum, part) => sum + part.rest, 0);
  const whole = parts.reduce((sum, { energy }) => sum + (energy ?? 0), 0);
  return (
    <section class="terms" aria-label={en.terms.title}>
      <div class="stack" aria-hidden="true">
        {parts.map(({ name, energy }) => (
          <div key={name} class={name} style={{ inlineSize: `${whole > 0 ? (100 * (energy ?? 0)) / whole : 25}%` }} />
        ))}
      </div>
      <ul>
        {parts.map((term) => (
          <li key={term.name}>
            <Name session={session} term={term} />
            <span class="share">{term.energy === null ? "–" : decimals(term.energy)}</span>
          </li>
        ))}
      </ul>
      {rest > 0 && <p class="at-rest">{en.terms.rest(decimals(rest))}</p>}
    </section>
  );
}

/** The least that the term can be, as the identity tells: of mismatch and bending it tells nothing like that. */
function restOf({ frame: { rest }, settings }: Result, name: Term["name"]): number {
  const known = name === "volume" || (name === "membrane" && settings.membraneModel !== "projected");
  return known && rest ? rest[name] : 0;
}

function Name({ session, term: { name, weight, off } }: { session: Session; term: Term }) {
  /** The value to come back to. */
  const before = useRef<number | null>(null);
  const field = FIELDS.find((candidate) => candidate.name === weight);
  const words = [en.terms.names[name], field && <Sign key="sign" text={field.symbol} />];
  if (off === null || !field) return <span class={`term ${name}`}>{words}</span>;
  const value = chosen(session, field);
  const on = value > off;
  return (
    <button
      type="button"
      role="switch"
      aria-checked={on}
      title={hands.value?.withoutTerm(name)}
      class={`term ${name}`}
      onClick={() => {
        if (on) before.current = value;
        session.choices.tryOut(field, on ? off : (before.current ?? Number(field.initial)));
      }}
    >
      {words}
    </button>
  );
}

function chosen(session: Session, { name, initial }: SettingField): number {
  return Number(session.settings.value[name] ?? initial);
}
