/**
 * How long it takes from the hand to the drawn picture: from the time stamp of the event that an update was made from to
 * the end of the drawing of its first frame.
 */
export class Latency {
  private readonly report: (from: number) => void;
  /** Of the update under way, until its first frame is there. */
  private asked: number | null = null;
  /** Of the frame that is to be drawn next. */
  private received: number | null = null;

  constructor(report: (from: number) => void = measured) {
    this.report = report;
  }

  /** An update has gone out for the event of this time. */
  ask(at: number): void {
    this.asked = at;
  }

  /** A frame has come; only an update's first answers it. */
  receive(): void {
    this.received = this.asked;
    this.asked = null;
  }

  /** The frame that came last has been drawn. */
  drawn(): void {
    if (this.received !== null) this.report(this.received);
    this.received = null;
  }

  /** Whatever comes next answers no event. */
  forget(): void {
    this.asked = null;
  }
}

function measured(start: number): void {
  performance.measure("live-frame", { start, end: performance.now() });
  // Observers have it; kept in the page's timeline, every frame would cost memory for good.
  performance.clearMeasures("live-frame");
}
