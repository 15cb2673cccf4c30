import { useSignal } from "@preact/signals";
import { isPaused, isWorking } from "../phase";
import { space as say } from "../words/space";
import { START } from "./camera";
import { PinActions } from "./Pins";
import { swapped } from "./pins";
import type { SpaceSession } from "./session";
import type { Ways } from "./ways";

type Properties = { readonly session: SpaceSession; readonly ways: Ways };

export function Actions({ session, ways }: Properties) {
  const phase = session.phase.value;
  const [working, paused] = [isWorking(phase), isPaused(phase)];
  const { actions } = say;
  const { reference, template, pins } = session.step.value;
  return (
    <div class="toolbar">
      <div class="group">
        <button type="button" class="primary" onClick={() => session.start()}>
          {actions.match}
        </button>
        <button
          type="button"
          class="switch"
          role="switch"
          aria-checked={session.live.value}
          title={actions.liveHelp}
          onClick={() => session.setLive(!session.live.value)}
        >
          {actions.live}
        </button>
        <button type="button" disabled={!working} onClick={() => (paused ? session.resume() : session.pause())}>
          {paused ? actions.resume : actions.pause}
        </button>
        <button type="button" disabled={!working} onClick={() => session.cancel()}>
          {actions.cancel}
        </button>
      </div>
      <div class="group">
        <button type="button" disabled={!session.canUndo.value} onClick={() => session.undo()}>
          {actions.undo}
        </button>
        <button type="button" disabled={!session.canRedo.value} onClick={() => session.redo()}>
          {actions.redo}
        </button>
        <button
          type="button"
          title={actions.swapHelp}
          onClick={() => session.commit({ reference: template, template: reference, pins: swapped(pins) })}
        >
          {actions.swap}
        </button>
        <button
          type="button"
          disabled={session.pose.value === START}
          onClick={() => {
            session.pose.value = START;
          }}
        >
          {actions.camera}
        </button>
        <PinActions session={session} />
        <CopyLink ways={ways} />
      </div>
    </div>
  );
}

function CopyLink({ ways }: { ways: Ways }) {
  const said = useSignal<string>(say.actions.link);
  const copy = async () => {
    const address = ways.address();
    try {
      await navigator.clipboard.writeText(address);
      said.value = say.actions.copied;
    } catch {
      // Not allowed here: the address bar holds the same link.
      said.value = say.actions.address;
    }
    setTimeout(() => {
      said.value = say.actions.link;
    }, 1600);
  };
  return (
    <button type="button" title={say.actions.linkHelp} onClick={copy}>
      {said}
    </button>
  );
}
