/** Keeps nothing: what is drawn in a frame is no session of the page, and what the page keeps is not for the frame. */

import { Memory } from "../memory/memory";
import { Sessions } from "../memory/sessions";

const NOWHERE = (): Storage => {
  throw new Error("a frame keeps nothing");
};

export class Forgetful extends Memory {
  constructor() {
    super(new Sessions(NOWHERE), { id: "frame" });
  }

  override keep(): void {}

  /** The address is the other page's choice. */
  override remember(): void {}
}
