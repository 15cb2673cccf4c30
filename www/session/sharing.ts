/** What a link says of the session, beside what has been drawn and chosen: the view and the morph. Signals; no DOM. */

import type { Signal } from "@preact/signals";
import { addressOf, reason } from "../link/open";
import { encode, type Saved } from "../link/text";
import type { Step } from "./edits";
import type { Looks } from "./looks";

export class Sharing {
  private readonly looks: Looks;
  private readonly morph: Signal<number>;
  private readonly problem: Signal<string | null>;

  constructor(looks: Looks, morph: Signal<number>, problem: Signal<string | null>) {
    this.looks = looks;
    this.morph = morph;
    this.problem = problem;
  }

  /** What brings back everything. */
  link(step: Step): string {
    return encode({ ...step, view: this.looks.view.value, morph: this.morph.value });
  }

  /** The same as an address of this page. */
  address(step: Step): string {
    const url = new URL(addressOf(this.link(step)));
    // Whoever opens it reads it in a language of theirs.
    url.searchParams.delete("lang");
    return url.href;
  }

  /** Looks at what is shown as a link has it. */
  look({ view, morph }: Pick<Saved, "view" | "morph">): void {
    this.morph.value = morph;
    if (view === this.looks.view.peek()) return;
    this.looks.choose(view).catch((error) => {
      this.problem.value = reason(error);
    });
  }
}
