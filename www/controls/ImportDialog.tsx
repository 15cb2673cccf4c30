import { useSignal, useSignalEffect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { decodeRecord, type MatchRecord } from "../record";
import type { Session, Side } from "../session";
import type { Found } from "../shapes/import/found";
import { readFile, readText } from "../shapes/import/index";
import { Gallery } from "./Gallery";
import "./import.css";
import { ImportOptions, ImportPreview } from "./ImportPreview";
import { begun, type Draft, type Outcome, outcome } from "./importDraft";
import { importing } from "./importing";

const SIDES: readonly Side[] = ["reference", "template"];

const ACCEPTED = ".svg,.png,.jpg,.jpeg,.webp,.gif,.bmp,.json,.geojson,.csv,.txt,image/*,application/json,text/csv";

/** Choose, look, adjust, take: nothing of the page changes before the last step, and one undo takes it back. */
export function ImportDialog({ session }: { session: Session }) {
  const dialog = useRef<HTMLDialogElement>(null);
  const primary = useRef<HTMLButtonElement>(null);
  const draft = useSignal<Draft | null>(null);
  const saved = useSignal<MatchRecord | null>(null);
  const problem = useSignal<string | null>(null);
  const reading = useSignal(false);
  const browsing = useSignal(false);

  useEffect(() => dialog.current?.showModal(), []);

  const show = (found: Found, name: string, preview: ImageBitmap | null = null) => {
    browsing.value = false;
    problem.value = null;
    saved.value = found.kind === "saved" ? decodeRecord(found.content) : null;
    draft.value = found.kind === "saved" ? null : begun(found, name, preview);
  };
  const refuse = (error: unknown) => {
    draft.value = null;
    saved.value = null;
    problem.value = error instanceof Error ? error.message : String(error);
  };

  // One input after another may arrive while the dialog is open; the last one counts.
  useSignalEffect(() => {
    const request = importing.value;
    if (!request || request.input === null) return;
    const { input } = request;
    problem.value = null;
    if (typeof input === "string") {
      try {
        show(readText(input), "the pasted text");
      } catch (error) {
        refuse(error);
      }
      return;
    }
    reading.value = true;
    readFile(input)
      .then((found) => {
        if (importing.value !== request) return;
        show(found, input instanceof File ? input.name : "the picture", found.preview ?? null);
      })
      .catch((error) => {
        if (importing.value === request) refuse(error);
      })
      .finally(() => {
        if (importing.value === request) reading.value = false;
      });
  });

  // What was pressed in the gallery is gone with it: go on at the next step.
  const source = draft.value?.source;
  useEffect(() => {
    if (source !== undefined && document.activeElement === document.body) primary.current?.focus();
  }, [source]);

  const side = importing.value?.side ?? "reference";
  const read = (input: Blob | string | null) => {
    if (input) importing.value = { side, input };
  };
  const close = () => dialog.current?.close();
  const result: Outcome | null = draft.value && outcome(draft.value);
  const take = (target: Side) => {
    if (!result?.prepared) return;
    session.commitShape(target, result.prepared.shape);
    close();
  };

  return (
    <dialog
      ref={dialog}
      class="import"
      aria-labelledby="import-name"
      onClose={() => {
        importing.value = null;
      }}
    >
      <header>
        <h2 id="import-name">Import a {side}</h2>
        <button type="button" class="quiet" onClick={close}>
          Close
        </button>
      </header>
      <Sources onInput={read} browsing={browsing.value} onBrowse={() => (browsing.value = !browsing.value)} />
      <div role="alert">{problem.value && <p class="refusal">{problem.value}</p>}</div>
      {reading.value && <p role="status">Reading …</p>}
      {browsing.value && <Gallery onChoose={show} onProblem={refuse} />}
      {!browsing.value && draft.value && result && (
        <>
          <div class="look">
            <ImportPreview draft={draft.value} result={result} side={side} />
            <ImportOptions draft={draft.value} result={result} onChange={(next) => (draft.value = next)} />
          </div>
          <footer>
            {[side, ...SIDES.filter((other) => other !== side)].map((target) => (
              <button
                key={target}
                ref={target === side ? primary : undefined}
                type="button"
                class={target === side ? "primary" : undefined}
                disabled={!result.prepared}
                onClick={() => take(target)}
              >
                Use as {target}
              </button>
            ))}
          </footer>
        </>
      )}
      {!browsing.value && saved.value && (
        <SavedMatch
          record={saved.value}
          onOpen={(record) => {
            session.restore(record);
            close();
          }}
          onShape={(name, loops) =>
            show(
              { kind: "shapes", choices: [{ name, loops, placed: true, mainPart: false, smoothing: 0 }], notes: [] },
              name,
            )
          }
        />
      )}
    </dialog>
  );
}

type SourcesProps = {
  readonly onInput: (input: Blob | string | null) => void;
  readonly browsing: boolean;
  readonly onBrowse: () => void;
};

function Sources({ onInput, browsing, onBrowse }: SourcesProps) {
  return (
    <div class="sources">
      <label class="file">
        <span>Choose a file</span>
        <input
          type="file"
          accept={ACCEPTED}
          aria-describedby="import-formats"
          onChange={(event) => {
            onInput(event.currentTarget.files?.[0] ?? null);
            // The same file may be chosen again, after it has been changed.
            event.currentTarget.value = "";
          }}
        />
      </label>
      <button type="button" aria-expanded={browsing} onClick={onBrowse}>
        Gallery
      </button>
      <p id="import-formats" class="help">
        SVG, PNG, JPEG, WebP, JSON, GeoJSON, CSV, or a match saved here. You can also drop a file anywhere on the page,
        or paste a picture or text.
      </p>
      <details>
        <summary>Paste text here</summary>
        <textarea
          rows={3}
          aria-label="SVG, JSON or CSV text"
          spellcheck={false}
          onInput={(event) => onInput(event.currentTarget.value.trim() || null)}
        />
      </details>
    </div>
  );
}

type SavedProps = {
  readonly record: MatchRecord;
  readonly onOpen: (record: MatchRecord) => void;
  readonly onShape: (name: string, loops: MatchRecord["reference"]) => void;
};

function SavedMatch({ record, onOpen, onShape }: SavedProps) {
  const { match } = record;
  return (
    <div class="saved">
      <p>
        {match
          ? `A saved match on the ${2 ** match.status.level + 1} × ${2 ** match.status.level + 1} grid, with its shapes and settings.`
          : "Two saved shapes with their settings, not yet matched."}
      </p>
      <footer>
        <button type="button" class="primary" onClick={() => onOpen(record)}>
          Open everything
        </button>
        {record.reference.length > 0 && (
          <button type="button" onClick={() => onShape("Reference", record.reference)}>
            Only the reference
          </button>
        )}
        {record.template.length > 0 && (
          <button type="button" onClick={() => onShape("Template", record.template)}>
            Only the template
          </button>
        )}
      </footer>
    </div>
  );
}
