import { useSignal } from "@preact/signals";
import type { Session } from "../session";
import { later } from "../words/later";

/** Everything that is on the page, as an address. */
export function CopyLink({ session }: { session: Session }) {
  const said = useSignal<"copy" | "copied" | "seeAddress">("copy");
  const copy = async () => {
    const address = session.address();
    try {
      await navigator.clipboard.writeText(address);
      said.value = "copied";
    } catch {
      // Not allowed here: the address bar holds the same link.
      history.replaceState(null, "", address);
      said.value = "seeAddress";
    }
    setTimeout(() => {
      said.value = "copy";
    }, 1600);
  };
  return (
    <button type="button" title={later.copying.help} onClick={copy}>
      {later.copying[said.value]}
    </button>
  );
}
