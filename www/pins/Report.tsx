import type { Session } from "../session";
import { signedDistance } from "../view/along";
import { pinEnds } from "./draw";
import { pinsAside, pinsOff } from "./words";

/** Says which pins the match has not brought to their partners, and which it should not. */
export function Report({ session }: { session: Session }) {
  const result = session.result.value;
  if (!result || result.pins.length === 0 || session.stale.value) return null;
  const { pins, reference, template, settings, frame } = result;
  const { level } = frame.status;
  const cells = 2 ** level;
  const strength = settings.pinWeight ?? 1;
  const off = pinsOff(
    pinEnds(pins, { level, deformation: frame.deformation }).map((end) => end.off * cells),
    strength,
  );
  const aside = pinsAside(
    pins.map(
      ({ reference: p, template: q }) =>
        cells * Math.abs(signedDistance(template, q.x, q.y) - signedDistance(reference, p.x, p.y)),
    ),
  );
  const words = off ?? (strength > 0 ? aside : null);
  return words && <p class="pins-off">{words}</p>;
}
