/** All that is about pins: fetched when the first is to be set, or when there are some. */

export { Actions, guide } from "./Actions";
export { drawPinMarks, drawPins, pinMarks } from "./draw";
export { PinHand } from "./hand";
export { carried } from "./places";
export { Report } from "./Report";
