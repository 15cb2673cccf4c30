/** Numbers and progress as every status of the page shows them. */

type ValueProperties = {
  /** For machines. */
  readonly name: string;
  readonly label: string;
  readonly value: number;
  readonly text: string;
  readonly unit?: string;
};

/** For machines only what is a number; for people always words. */
export function Value({ name, label, value, text, unit = "" }: ValueProperties) {
  return (
    <div>
      <dt>{label}</dt>
      <dd>
        {Number.isFinite(value) ? (
          <data data-name={name} value={String(value)}>
            {text}
          </data>
        ) : (
          text
        )}
        {unit && <span class="unit">{unit}</span>}
      </dd>
    </div>
  );
}

/** A bar that knows how far it is, or that it does not. */
export function Bar({ label, percent }: { readonly label: string; readonly percent: number | null }) {
  const known = percent === null ? {} : { "aria-valuemin": 0, "aria-valuemax": 100, "aria-valuenow": percent };
  return (
    <div class={percent === null ? "progress unknown" : "progress"} role="progressbar" aria-label={label} {...known}>
      <div style={percent === null ? undefined : { inlineSize: `${percent}%` }} />
    </div>
  );
}
