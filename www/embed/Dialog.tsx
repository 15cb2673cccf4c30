import { type Signal, useComputed, useSignal } from "@preact/signals";
import { render } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { adopt } from "../controls/adopt";
import type { Session } from "../session";
import { FIELDS, parseSetting } from "../settings";
import { embed as words } from "../words/embed";
import { addressFor, type Change, CONTROLS, type Control, KINDS, type Kind, snippet, USUAL } from "./asked";
import style from "./dialog.css?inline";

adopt(style);

/** Sides of a frame, in pixels: smaller shows nothing, larger fits no page. */
const LEAST = 200;
const MOST = 2000;

/** What can be done in a frame is not the same in each. */
const OFFERED: Readonly<Record<Kind, readonly Control[]>> = {
  result: CONTROLS,
  compare: ["view", "morph", "match", "link"],
  full: CONTROLS,
};

/** Opens the dialog over the page. */
export function ask(session: Session): void {
  const place = document.createElement("div");
  // Within it, headings and feet are of the dialog, not of the page.
  (document.querySelector("main") ?? document.body).append(place);
  const end = () => {
    render(null, place);
    place.remove();
  };
  render(<Dialog session={session} onClose={end} />, place);
}

/** What is to be shown elsewhere, and how; the snippet for it, and how it will look. */
function Dialog({ session, onClose }: { session: Session; onClose: () => void }) {
  const { dialog: say } = words;
  const dialog = useRef<HTMLDialogElement>(null);
  const kind = useSignal<Kind>("result");
  const controls = useSignal<ReadonlySet<Control>>(new Set(USUAL.result));
  const [width, height] = [useSignal(700), useSignal(500)];
  const runs = useSignal(true);
  const change = useSignal<Change | null>(changeOf("bending", "0"));
  useEffect(() => dialog.current?.showModal(), []);

  const address = useComputed(() =>
    addressFor(location.href, {
      kind: kind.value,
      controls: OFFERED[kind.value].filter((name) => controls.value.has(name)),
      sides: kind.value === "compare" ? [null, change.value] : [null, null],
      later: !runs.value,
      link: session.link(),
    }),
  );
  const text = useComputed(() => snippet(address.value, width.value, height.value));
  const choose = (wanted: Kind) => {
    kind.value = wanted;
    controls.value = new Set(USUAL[wanted]);
  };
  const close = () => dialog.current?.close();
  return (
    <dialog ref={dialog} class="embedding" aria-labelledby="embedding-name" onClose={onClose}>
      <header>
        <h2 id="embedding-name">{say.title}</h2>
        <button type="button" class="quiet" onClick={close}>
          {say.close}
        </button>
      </header>
      <div class="wishes">
        <fieldset>
          <legend>{say.kind}</legend>
          {KINDS.map((one) => (
            <label key={one}>
              <input type="radio" name="kind" checked={kind.value === one} onChange={() => choose(one)} />
              {say.kinds[one]}
            </label>
          ))}
          {kind.value === "compare" && <ChangeField change={change} />}
        </fieldset>
        <fieldset>
          <legend>{say.controls}</legend>
          {OFFERED[kind.value].map((name) => (
            <label key={name}>
              <input
                type="checkbox"
                checked={controls.value.has(name)}
                onChange={(event) => {
                  const next = new Set(controls.value);
                  if (event.currentTarget.checked) next.add(name);
                  else next.delete(name);
                  controls.value = next;
                }}
              />
              {say.names[name]}
            </label>
          ))}
        </fieldset>
        <fieldset>
          <legend>{say.size}</legend>
          <Length label={say.width} value={width} />
          <Length label={say.height} value={height} />
          <label>
            <input
              type="checkbox"
              checked={runs.value}
              onChange={(event) => {
                runs.value = event.currentTarget.checked;
              }}
            />
            {say.run}
          </label>
        </fieldset>
      </div>
      <label class="code">
        {say.snippet}
        <textarea readOnly rows={4} spellcheck={false} value={text} onFocus={(event) => event.currentTarget.select()} />
      </label>
      <footer>
        <Copy text={text.value} />
        <p class="help">{say.more}</p>
      </footer>
      <details>
        <summary>{say.preview}</summary>
        <iframe key={address.value} title={words.title} src={address} width={width} height={height} loading="lazy" />
      </details>
    </dialog>
  );
}

function Length({ label, value }: { label: string; value: Signal<number> }) {
  return (
    <label class="length">
      {label}
      <input
        type="number"
        min={LEAST}
        max={MOST}
        value={value}
        onChange={(event) => {
          const wanted = Math.round(event.currentTarget.valueAsNumber);
          if (wanted >= LEAST && wanted <= MOST) value.value = wanted;
          else event.currentTarget.value = String(value.peek());
        }}
      />
    </label>
  );
}

/** The setting that the second side has otherwise. */
function ChangeField({ change }: { change: Signal<Change | null> }) {
  const { dialog: say } = words;
  const set = (name: string, text: string) => {
    const next = changeOf(name, text);
    if (next) change.value = next;
  };
  const { field, value } = change.value ?? {};
  if (!field) return null;
  return (
    <div class="other">
      <label>
        {say.setting}
        <select
          value={field.name}
          onChange={({ currentTarget: { value: name } }) =>
            set(name, String(FIELDS.find((one) => one.name === name)?.initial))
          }
        >
          {FIELDS.map(({ name, label }) => (
            <option key={name} value={name}>
              {label}
            </option>
          ))}
        </select>
      </label>
      {/* biome-ignore lint/a11y/noLabelWithoutControl: whichever stands in it */}
      <label>
        {say.value}
        {field.kind === "choice" ? (
          <select value={String(value)} onChange={(event) => set(field.name, event.currentTarget.value)}>
            {field.options.map((option) => (
              <option key={String(option.value)} value={String(option.value)}>
                {option.label}
              </option>
            ))}
          </select>
        ) : (
          <input
            type="number"
            step="any"
            min={field.least}
            max={field.most}
            value={String(value)}
            onChange={(event) => set(field.name, event.currentTarget.value)}
          />
        )}
      </label>
    </div>
  );
}

/** Null for a value that the setting cannot have. */
function changeOf(name: string, text: string): Change | null {
  const field = FIELDS.find((one) => one.name === name);
  if (!field) return null;
  try {
    return { field, value: parseSetting(field, text) };
  } catch {
    return null;
  }
}

function Copy({ text }: { text: string }) {
  const { dialog: say } = words;
  const said = useSignal<"copy" | "copied" | "select">("copy");
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(text);
      said.value = "copied";
    } catch {
      said.value = "select";
    }
  };
  // Another snippet is not yet copied.
  useEffect(() => {
    if (text) said.value = "copy";
  }, [text, said]);
  return (
    <button type="button" class="primary" onClick={copy}>
      {say[said.value]}
    </button>
  );
}
