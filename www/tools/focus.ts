/** The keyboard goes to a sketch surface: whoever has pressed a button that is gone by that goes on there. */
export function focusOn(side: "reference" | "template"): void {
  document.getElementById(`${side}-surface`)?.focus({ preventScroll: true });
}
