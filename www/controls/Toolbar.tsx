import { isFollowing, isPaused, isWorking } from "../phase";
import type { Session } from "../session";
import { hands } from "../tools/tool";
import { en } from "../words/en";

/** Everything that is done with a press. */
export function Toolbar({ session }: { session: Session }) {
  const phase = session.phase.value;
  const working = isWorking(phase);
  const paused = isPaused(phase);
  const { reference, template } = session.shapes.value;
  // Comes with what draws.
  const { Exchange, CopyLink } = hands.value ?? {};
  return (
    <div class="toolbar">
      <div class="group">
        <button type="button" class="primary" onClick={() => session.start()}>
          {en.actions.match}
        </button>
        <button
          type="button"
          class="switch"
          role="switch"
          aria-checked={session.live.value}
          title={en.actions.liveHelp}
          onClick={() => session.setLive(!session.live.value)}
        >
          {en.actions.live}
        </button>
        <button type="button" disabled={!working} onClick={() => (paused ? session.resume() : session.pause())}>
          {paused ? en.actions.resume : en.actions.pause}
        </button>
        <button type="button" disabled={!working && !isFollowing(phase)} onClick={() => session.cancel()}>
          {en.actions.cancel}
        </button>
      </div>
      <div class="group">
        <button type="button" disabled={!session.canUndo.value} onClick={() => session.undo()}>
          {en.actions.undo}
        </button>
        <button type="button" disabled={!session.canRedo.value} onClick={() => session.redo()}>
          {en.actions.redo}
        </button>
        <button
          type="button"
          disabled={reference.length === 0 && template.length === 0}
          title={hands.value?.hint("fit")}
          onClick={() => session.fit()}
        >
          {en.actions.fit}
        </button>
        {Exchange && <Exchange session={session} />}
        {CopyLink && <CopyLink session={session} />}
      </div>
    </div>
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
            {en.actions.drawAgain}
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
        {en.actions.dismiss}
      </button>
    </div>
  );
}
