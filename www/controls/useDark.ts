import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";

/** Whether the reader's scheme is dark, as it changes. */
export function useDark() {
  const dark = useSignal(matchMedia("(prefers-color-scheme: dark)").matches);
  useEffect(() => {
    const query = matchMedia("(prefers-color-scheme: dark)");
    const change = () => {
      dark.value = query.matches;
    };
    query.addEventListener("change", change);
    return () => query.removeEventListener("change", change);
  }, [dark]);
  return dark;
}
