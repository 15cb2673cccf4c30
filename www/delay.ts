/** One thing to be done a moment from now; wanted again, the moment begins anew. */
export class Delay {
  private readonly millis: number;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(millis: number) {
    this.millis = millis;
  }

  start(work: () => void): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(work, this.millis);
  }

  stop(): void {
    clearTimeout(this.timer);
  }
}
