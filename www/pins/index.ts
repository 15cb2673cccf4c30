/** All that is about pins: fetched when the first is to be set, or when there are some. */

export { Actions, guide } from "./Actions";
export { drawPinMarks, drawPins, pinMarks } from "./draw";
export { carried, followed } from "./places";
export { Report } from "./Report";
export { PinTool } from "./tool";
