/** What the settings are chosen to be: every choice is one step to undo, and some are matched with at once. */

import { type Chosen, FIELDS, type SettingField, sameSettings, withSetting } from "../settings";
import type { Edits, Step } from "./edits";

/** What choices come to. */
export type Consequences = {
  /** Nothing can be matched with nothing. */
  readonly isEmpty: boolean;
  commit(step: Step): void;
  /** While a slider is still moving, with the time of its event. */
  preview(step: Step, at: number): void;
  /** What was previewed has been taken back. */
  restored(): void;
  /** A match is asked for, unless one follows by itself. */
  match(): void;
};

export class Choices {
  private readonly edits: Pick<Edits, "present" | "moves" | "restore">;
  private readonly page: Consequences;

  constructor(edits: Pick<Edits, "present" | "moves" | "restore">, page: Consequences) {
    this.edits = edits;
    this.page = page;
  }

  /** The setting while its slider is still moving. */
  preview(field: SettingField, value: number, at: number): void {
    this.page.preview(this.step(this.changed(field, value)), at);
  }

  /** One step to undo, unless it is what it was. */
  change(field: SettingField, value: number | string | boolean): void {
    this.choose(this.changed(field, value));
  }

  /** Chooses a value and matches with it. */
  tryOut(field: SettingField, value: number): void {
    this.change(field, value);
    if (!this.page.isEmpty) this.page.match();
  }

  /** Takes a grid of this level for the finest and matches on it. */
  matchOn(level: number): void {
    const finest = FIELDS.find((field) => field.name === "finest");
    if (finest) this.change(finest, level);
    this.page.match();
  }

  reset(): void {
    this.choose({});
  }

  private choose(settings: Chosen): void {
    if (!sameSettings(settings, this.edits.present.settings)) this.page.commit(this.step(settings));
    else if (this.edits.moves) {
      this.edits.restore();
      this.page.restored();
    }
  }

  private changed(field: SettingField, value: number | string | boolean): Chosen {
    return withSetting(this.edits.present.settings, field, value);
  }

  private step(settings: Chosen): Step {
    return { ...this.edits.present, settings };
  }
}
