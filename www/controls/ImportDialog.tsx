import { useSignal, useSignalEffect } from "@preact/signals";
import type { ComponentProps, FunctionComponent } from "preact";
import { useEffect, useMemo, useRef } from "preact/hooks";
import { type Subject, subjectOf, tied } from "../batch/subject";
import { decodeRecord, type MatchRecord } from "../record";
import type { Session, Side } from "../session";
import type { Outcome } from "../shapes/import/content";
import type { FoundShapes } from "../shapes/import/found";
import { type Read, Reader } from "../shapes/import/reader";
import { batch } from "../words/batch";
import { en } from "../words/en";
import { imports as say } from "../words/imports";
import { later } from "../words/later";
import { gridName } from "../words/said";
import { adopt } from "./adopt";
import type { Batch } from "./Batch";
import { fetched } from "./fetched";
import { Gallery } from "./Gallery";
import { ImportOptions, ImportPreview } from "./ImportPreview";
import style from "./import.css?inline";
import { begun, type Draft, selectionOf } from "./importDraft";
import { importing } from "./imported";

adopt(style);

const SIDES: readonly Side[] = ["reference", "template"];

const ACCEPTED = ".svg,.png,.jpg,.jpeg,.webp,.gif,.bmp,.json,.geojson,.csv,.tps,.txt,image/*,application/json,text/csv";

/** What has been taken last for either side: landmarks of both are tied to each other. */
const taken: Partial<Record<Side, Subject>> = {};

/** Choose, look, adjust, take: nothing of the page changes before the last step, and one undo takes it back. */
export function ImportDialog({ session }: { session: Session }) {
  const dialog = useRef<HTMLDialogElement>(null);
  const primary = useRef<HTMLButtonElement>(null);
  const draft = useSignal<Draft | null>(null);
  const result = useSignal<Outcome | null>(null);
  /** The result under way, or the last one: what is taken is what was wished last. */
  const pending = useRef<Promise<Outcome> | null>(null);
  const saved = useSignal<MatchRecord | null>(null);
  const problem = useSignal<string | null>(null);
  /** The part of a reading that is done; 0 as well where nobody knows. Null while nothing is read. */
  const reading = useSignal<number | null>(null);
  const isGallery = useMemo(() => importing.peek()?.gallery === true, []);
  const browsing = useSignal(isGallery);
  const reader = useMemo(
    () =>
      new Reader((done) => {
        reading.value = done;
      }),
    [reading],
  );

  useEffect(() => dialog.current?.showModal(), []);
  useEffect(() => () => reader.stop(), [reader]);

  const empty = () => {
    draft.peek()?.preview?.close();
    draft.value = null;
    result.value = null;
    saved.value = null;
    problem.value = null;
    reading.value = null;
  };
  const refuse = (error: unknown) => {
    empty();
    problem.value = error instanceof Error ? error.message : String(error);
  };
  /** The next press of its button tries again. */
  const withoutGallery = (error: unknown) => {
    browsing.value = false;
    refuse(error);
  };
  /** Computes the shape under the draft's wishes. Until it is there, what was shown stays. */
  const change = (next: Draft) => {
    draft.value = next;
    const outcome = reader.prepare(selectionOf(next));
    pending.current = outcome;
    outcome.then(
      (prepared) => {
        if (pending.current === outcome) result.value = prepared;
      },
      (error) => pending.current === outcome && refuse(error),
    );
  };
  const show = (read: Read, name: string) => {
    empty();
    browsing.value = false;
    if (read.kind === "saved") saved.value = decodeRecord(read.content);
    else change(begun(read.offer, name, read.preview));
  };
  // One input after another may arrive while the dialog is open; the last one counts.
  const read = (input: Blob | string | FoundShapes, name: string, isWanted: () => boolean) => {
    empty();
    reading.value = 0;
    reader
      .read(input)
      .then((found) => isWanted() && show(found, name))
      .catch((error) => isWanted() && refuse(error));
  };
  const take = async (target: Side) => {
    const outcome = await pending.current;
    const from = draft.value;
    if (!outcome?.prepared || !from) return;
    taken[target] = subjectOf(from.source, from.choices[from.chosen] ?? {}, outcome.prepared);
    commit(session, target, outcome.prepared.shape);
    close();
  };

  useSignalEffect(() => {
    const request = importing.value;
    if (!request || request.input === null) return;
    const { input } = request;
    const name = typeof input === "string" ? say.pastedText : input instanceof File ? input.name : say.picture;
    read(input, name, () => importing.value === request);
  });

  // What was pressed in the gallery is gone with it: go on at the next step.
  const source = draft.value?.source;
  const ready = result.value !== null;
  useEffect(() => {
    if (source !== undefined && ready && document.activeElement === document.body) primary.current?.focus();
  }, [source, ready]);

  const Many = useSignal<FunctionComponent<ComponentProps<typeof Batch>> | null>(null);
  const many = importing.value?.many;
  const isMany = many !== undefined;
  useEffect(() => {
    if (!isMany || Many.peek()) return;
    fetched(batch.what, () => import("./Batch")).then((loaded) => {
      Many.value = loaded.Batch;
    }, refuse);
  }, [isMany]);

  const side = importing.value?.side ?? "reference";
  const wish = (input: Blob | string | null) => {
    if (input) importing.value = { side, input };
  };
  const known = (found: FoundShapes, name: string) => {
    const request = importing.value;
    read(found, name, () => importing.value === request);
  };
  const close = () => dialog.current?.close();

  if (many) {
    const Loaded = Many.value;
    return (
      <dialog
        ref={dialog}
        class="import"
        aria-labelledby="import-name"
        onClose={() => {
          importing.value = null;
        }}
      >
        <Head name={batch.title} onClose={close} />
        <div role="alert">{problem.value && <p class="refusal">{problem.value}</p>}</div>
        {Loaded ? (
          <Loaded session={session} dropped={many} accepted={ACCEPTED} onShown={close} />
        ) : (
          <p role="status">{batch.loading}</p>
        )}
      </dialog>
    );
  }
  return (
    <dialog
      ref={dialog}
      class="import"
      aria-labelledby="import-name"
      onClose={() => {
        importing.value = null;
      }}
    >
      <Head name={isGallery ? later.gallery.title : later.gallery.importing(side)} onClose={close} />
      <Sources
        onInput={wish}
        browsing={browsing.value}
        onBrowse={() => (browsing.value = !browsing.value)}
        onMany={() => {
          importing.value = { side, input: null, many: [] };
        }}
      />
      <div role="alert">{problem.value && <p class="refusal">{say.words(problem.value)}</p>}</div>
      {(reading.value !== null || (draft.value && !result.value)) && (
        <Reading
          done={reading.value}
          onStop={() => {
            reader.stop();
            empty();
          }}
        />
      )}
      {browsing.value && <Gallery onChoose={known} onProblem={withoutGallery} />}
      {!browsing.value && draft.value && result.value && (
        <>
          <div class="look">
            <ImportPreview draft={draft.value} result={result.value} side={side} />
            <ImportOptions draft={draft.value} result={result.value} onChange={change} />
          </div>
          <footer>
            {[side, ...SIDES.filter((other) => other !== side)].map((target) => (
              <button
                key={target}
                ref={target === side ? primary : undefined}
                type="button"
                class={target === side ? "primary" : undefined}
                disabled={!result.value?.prepared}
                onClick={() => take(target)}
              >
                {say.useAs(target)}
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
            known(
              { kind: "shapes", choices: [{ name, loops, placed: true, mainPart: false, smoothing: 0 }], notes: [] },
              name,
            )
          }
        />
      )}
    </dialog>
  );
}

function Head({ name, onClose }: { readonly name: string; readonly onClose: () => void }) {
  return (
    <header>
      <h2 id="import-name">{name}</h2>
      <button type="button" class="quiet" onClick={onClose}>
        {say.close}
      </button>
    </header>
  );
}

/** One step to undo, pins from landmarks included. */
function commit(session: Session, side: Side, shape: Subject["shape"]): void {
  const { present } = session;
  const { reference, template } = taken;
  const [other] = SIDES.filter((candidate) => candidate !== side);
  // Of the other side only what still stands there.
  const isThere = taken[other]?.shape === present[other];
  const { pins } = reference && template && isThere ? tied(reference, template) : { pins: [] };
  if (pins.length === 0) session.commitShape(side, shape);
  else {
    const shapes = { reference: present.reference, template: present.template, [side]: shape, pins };
    session.commitShapes(shapes, { ...present.examples, [side]: false });
  }
}

/** How far it is, and the way out: a drawing can take seconds. */
function Reading({ done, onStop }: { readonly done: number | null; readonly onStop: () => void }) {
  const percent = Math.round(100 * (done ?? 0));
  return (
    <div class="reading">
      <p role="status">{done === null ? say.preparing : say.reading}</p>
      <progress aria-label={say.name} max={100} value={percent > 0 ? percent : undefined} />
      <button type="button" onClick={onStop}>
        {say.stop}
      </button>
    </div>
  );
}

type SourcesProps = {
  readonly onInput: (input: Blob | string | null) => void;
  readonly browsing: boolean;
  readonly onBrowse: () => void;
  readonly onMany: () => void;
};

function Sources({ onInput, browsing, onBrowse, onMany }: SourcesProps) {
  return (
    <div class="sources">
      <label class="file">
        <span>{say.choose}</span>
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
        {say.gallery}
      </button>
      <button type="button" onClick={onMany}>
        {batch.open}
      </button>
      <p id="import-formats" class="help">
        {say.formats}
      </p>
      <details>
        <summary>{say.paste}</summary>
        <textarea
          rows={3}
          aria-label={say.pasteName}
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
      <p>{match ? say.savedMatch(gridName(match.status.level)) : say.savedShapes}</p>
      <footer>
        <button type="button" class="primary" onClick={() => onOpen(record)}>
          {say.openAll}
        </button>
        {record.reference.length > 0 && (
          <button type="button" onClick={() => onShape(en.sketch.names.reference, record.reference)}>
            {say.only.reference}
          </button>
        )}
        {record.template.length > 0 && (
          <button type="button" onClick={() => onShape(en.sketch.names.template, record.template)}>
            {say.only.template}
          </button>
        )}
      </footer>
    </div>
  );
}
