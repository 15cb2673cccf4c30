/** When the page is there and has nothing else to do. */
export function whenIdle(work: () => void): void {
  const plan = () => {
    if ("requestIdleCallback" in window) requestIdleCallback(work);
    else setTimeout(work, 1000);
  };
  if (document.readyState === "complete") plan();
  else addEventListener("load", plan, { once: true });
}
