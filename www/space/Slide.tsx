/** A slider from 0 to 100 %. */

type Slid = {
  readonly name: string;
  readonly value: number;
  readonly text: string;
  readonly disabled?: boolean;
  readonly change: (value: number) => void;
};

export function Slide({ name, value, text, disabled = false, change }: Slid) {
  return (
    <label class="way">
      <span>{name}</span>
      <input
        type="range"
        aria-label={name}
        min={0}
        max={100}
        value={Math.round(100 * value)}
        disabled={disabled}
        aria-valuetext={text}
        onInput={(event) => change(event.currentTarget.valueAsNumber / 100)}
      />
      <span class="percent">{Math.round(100 * value)} %</span>
    </label>
  );
}
