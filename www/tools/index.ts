/** The tools beyond pencil and pins, and what is done to one curve: fetched when the first is wanted. */

export { Actions, guide } from "./Actions";
export { Circle } from "./circle";
export { drawChosen } from "./draw";
export { Mirror } from "./mirror";
export { Points } from "./points";
export { Polygon } from "./polygon";
