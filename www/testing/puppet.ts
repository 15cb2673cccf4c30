/** A worker for tests: notes what it is told and says what it is told to say. */

import type { Engine } from "../engine";
import type { FrameReply, Reply, Request, Status } from "../protocol";

export class Puppet {
  readonly told: Request[] = [];
  ended = false;
  onmessage: ((event: { data: Reply }) => void) | null = null;
  onerror: ((event: { message: string; preventDefault(): void }) => void) | null = null;

  postMessage(request: Request): void {
    this.told.push(request);
  }

  terminate(): void {
    this.ended = true;
  }

  say(reply: Reply): void {
    this.onmessage?.({ data: reply });
  }

  break(message = ""): void {
    this.onerror?.({ message, preventDefault: () => {} });
  }

  /** A frame of the run that it was last told of. */
  frame(finished: boolean, mismatch = 0.1): void {
    const run = this.lastRun;
    if (run < 0) throw new Error("no run has been asked for");
    const status = { finished, level: 5, iteration: 1, mismatch: { max: mismatch, mean: 0 } } as Status;
    const curves = { reference: [], template: [], matched: [] };
    const deformation = new Float64Array(2);
    this.say({ kind: "frame", run, status, deformation, curves, trail: [], rest: null } satisfies FrameReply);
  }

  refuse(message: string): void {
    this.say({ kind: "refused", run: this.lastRun, message });
  }

  get starts(): Request[] {
    return this.told.filter(({ kind }) => kind === "start");
  }

  get lastRun(): number {
    const last = this.told.findLast((request) => "run" in request);
    return last && "run" in last ? last.run : -1;
  }
}

/** An engine of puppets; the list grows with each worker that is made. */
export function puppetEngine(module: Engine["module"] = () => Promise.resolve({} as WebAssembly.Module)) {
  const puppets: Puppet[] = [];
  const spawn = () => {
    const puppet = new Puppet();
    puppets.push(puppet);
    return puppet as unknown as Worker;
  };
  return { engine: { module, spawn } as Engine, puppets };
}
