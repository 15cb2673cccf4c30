import { effect, useSignal } from "@preact/signals";
import { useEffect, useId, useRef } from "preact/hooks";
import type { Side } from "../session";
import type { Outcome } from "../shapes/import/content";
import { pixelX, pixelY, Surface, trace } from "../view/canvas";
import { BOX } from "../view/framing";
import { imports as say } from "../words/imports";
import { type Draft, withChoice } from "./importDraft";

type PreviewProps = { readonly draft: Draft; readonly result: Outcome; readonly side: Side };

/** The shape where it will lie in the box, over the picture it comes from. */
export function ImportPreview({ draft, result, side }: PreviewProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const shown = useSignal({ draft, result, side });
  shown.value = { draft, result, side };

  useEffect(() => {
    if (!canvas.current) return;
    const surface = new Surface(
      canvas.current,
      () => BOX,
      (context, frame, colours) => {
        const { draft, result, side } = shown.value;
        if (!result.prepared) return;
        const { shape, box } = result.prepared;
        if (draft.preview) {
          // Pixel centres lie at whole numbers from 1 on, y up: so does the outline that was traced.
          const left = 0.5 * box.a + box.x;
          const top = (draft.preview.height + 0.5) * box.a + box.y;
          context.globalAlpha = 0.35;
          context.drawImage(
            draft.preview,
            pixelX(frame, left),
            pixelY(frame, top),
            draft.preview.width * box.a * frame.scale,
            draft.preview.height * box.a * frame.scale,
          );
        }
        context.beginPath();
        for (const loop of shape) trace(context, frame, loop, true);
        context.fillStyle = colours[side];
        context.globalAlpha = 0.16;
        context.fill("nonzero");
        context.globalAlpha = 1;
        context.strokeStyle = colours[side];
        context.lineWidth = 2 * frame.ratio;
        context.lineJoin = "round";
        context.stroke();
      },
    );
    const stop = effect(() => {
      shown.value;
      surface.invalidate();
    });
    return () => {
      stop();
      surface.dispose();
    };
  }, [shown]);

  return (
    <div class="surface">
      <canvas ref={canvas} role="img" aria-label={say.preview(words(result))} />
    </div>
  );
}

function words({ prepared, problem }: Outcome): string {
  if (!prepared) return problem ? say.words(problem) : say.nothing;
  const points = prepared.shape.reduce((sum, loop) => sum + loop.length / 2, 0);
  return say.counts(prepared.shape.length, points);
}

type OptionsProps = { readonly draft: Draft; readonly result: Outcome; readonly onChange: (draft: Draft) => void };

export function ImportOptions({ draft, result, onChange }: OptionsProps) {
  return (
    <div class="options">
      <p class="source">{say.from(draft.source)}</p>
      {draft.choices.length > 1 && (
        <Choice
          label={say.options.shape}
          value={String(draft.chosen)}
          options={Object.fromEntries(draft.choices.map((choice, i) => [String(i), say.words(choice.name)]))}
          onChange={(chosen) => onChange(withChoice(draft, Number(chosen)))}
        />
      )}
      {draft.picture && <PictureOptions draft={draft} onChange={onChange} />}
      {result.loops > 1 && (
        <>
          <Choice
            label={say.options.parts}
            value={draft.parts}
            options={say.parts}
            onChange={(parts) => onChange({ ...draft, parts })}
          />
          <Choice
            label={say.options.holes}
            value={draft.holes}
            options={say.holes}
            onChange={(holes) => onChange({ ...draft, holes })}
          />
        </>
      )}
      <Choice
        label={say.options.smoothing}
        value={String(draft.smoothing)}
        // Details finer than a cell no grid can see; they only cost iterations.
        options={say.smoothings}
        onChange={(smoothing) => onChange({ ...draft, smoothing: Number(smoothing) })}
      />
      {result.placed && (
        <Choice
          label={say.options.place}
          value={draft.placement}
          options={say.places}
          onChange={(placement) => onChange({ ...draft, placement })}
        />
      )}
      <div class="notes" aria-live="polite">
        {result.problem ? <p class="refusal">{say.words(result.problem)}</p> : <p>{words(result)}</p>}
        {[...draft.notes, ...result.notes].map((note) => (
          <p key={note}>{say.words(note)}</p>
        ))}
      </div>
    </div>
  );
}

function PictureOptions({ draft, onChange }: Omit<OptionsProps, "result">) {
  const id = useId();
  const automatic = draft.picture?.threshold ?? 0;
  return (
    <>
      <div class="option">
        <label for={id}>{say.options.threshold}</label>
        <input
          id={id}
          type="range"
          min={1}
          max={254}
          step={1}
          value={draft.threshold}
          onInput={(event) => onChange({ ...draft, threshold: event.currentTarget.valueAsNumber })}
        />
      </div>
      <button
        type="button"
        disabled={draft.threshold === automatic}
        onClick={() => onChange({ ...draft, threshold: automatic })}
      >
        {say.options.automatic}
      </button>
      <Choice
        label={say.options.inside}
        value={draft.flipped ? "light" : "dark"}
        options={say.insides}
        onChange={(inside) => onChange({ ...draft, flipped: inside === "light" })}
      />
    </>
  );
}

type ChoiceProps<T extends string> = {
  readonly label: string;
  readonly value: T;
  readonly options: Readonly<Record<T, string>>;
  readonly onChange: (value: T) => void;
};

function Choice<T extends string>({ label, value, options, onChange }: ChoiceProps<T>) {
  const id = useId();
  return (
    <div class="option">
      <label for={id}>{label}</label>
      <select id={id} value={value} onChange={(event) => onChange(event.currentTarget.value as T)}>
        {(Object.keys(options) as T[]).map((key) => (
          <option key={key} value={key}>
            {options[key]}
          </option>
        ))}
      </select>
    </div>
  );
}
