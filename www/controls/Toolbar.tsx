import { useSignal } from "@preact/signals";
import { isFollowing, isPaused, isWorking } from "../phase";
import type { Session } from "../session";
import { Exchange } from "./Exchange";

/** Everything that is done with a press. */
export function Toolbar({ session }: { session: Session }) {
  const phase = session.phase.value;
  const working = isWorking(phase);
  const paused = isPaused(phase);
  const { reference, template } = session.shapes.value;
  return (
    <div class="toolbar">
      <div class="group">
        <button type="button" class="primary" onClick={() => session.start()}>
          Match
        </button>
        <button
          type="button"
          class="switch"
          role="switch"
          aria-checked={session.live.value}
          title="The match follows your hand while you change a shape or a setting"
          onClick={() => session.setLive(!session.live.value)}
        >
          Live
        </button>
        <button type="button" disabled={!working} onClick={() => (paused ? session.resume() : session.pause())}>
          {paused ? "Resume" : "Pause"}
        </button>
        <button type="button" disabled={!working && !isFollowing(phase)} onClick={() => session.cancel()}>
          Cancel
        </button>
      </div>
      <div class="group">
        <button type="button" disabled={!session.canUndo.value} onClick={() => session.undo()}>
          Undo
        </button>
        <button type="button" disabled={!session.canRedo.value} onClick={() => session.redo()}>
          Redo
        </button>
        <button
          type="button"
          disabled={reference.length === 0 && template.length === 0}
          title="Scale and centre both shapes"
          onClick={() => session.fit()}
        >
          Fit
        </button>
        <Exchange session={session} />
        <CopyLink session={session} />
      </div>
    </div>
  );
}

function CopyLink({ session }: { session: Session }) {
  const said = useSignal("Copy link");
  const copy = async () => {
    const address = session.address();
    try {
      await navigator.clipboard.writeText(address);
      said.value = "Copied";
    } catch {
      // Not allowed here: the address bar holds the same link.
      history.replaceState(null, "", address);
      said.value = "See address bar";
    }
    setTimeout(() => {
      said.value = "Copy link";
    }, 1600);
  };
  return (
    <button type="button" title="A link that brings back everything: shapes, pins, settings, view" onClick={copy}>
      {said}
    </button>
  );
}

export function Problem({ session }: { session: Session }) {
  const text = session.problem.value;
  const notice = session.notice.value;
  const question = session.question.value;
  return (
    <div role="alert">
      {question && (
        <div class="problem">
          <p class="text">{question.words}</p>
          {question.ways.map(({ label, go }) => (
            <button key={label} type="button" onClick={go}>
              {label}
            </button>
          ))}
          <button type="button" class="quiet" onClick={() => session.dismiss()}>
            Draw again
          </button>
        </div>
      )}
      {text && <Said text={text} dismiss={() => session.dismiss()} />}
      {notice && (
        <Said
          text={notice}
          dismiss={() => {
            session.notice.value = null;
          }}
        />
      )}
    </div>
  );
}

function Said({ text, dismiss }: { text: string; dismiss: () => void }) {
  return (
    <div class="problem">
      <p class="text">{text}</p>
      <button type="button" class="quiet" onClick={dismiss}>
        Dismiss
      </button>
    </div>
  );
}
