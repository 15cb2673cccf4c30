import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";

type Properties = {
  readonly kind: string;
  /** What the button shows, and its name where that is a picture. */
  readonly label: ComponentChildren;
  readonly name?: string;
  readonly busy?: boolean;
  readonly children: ComponentChildren;
};

/** A button that opens a list of others. A press of one of them, outside, or Escape closes it; the focus comes back. */
export function Menu({ kind, label, name, busy = false, children }: Properties) {
  const menu = useRef<HTMLDetailsElement>(null);
  const close = () => {
    menu.current?.removeAttribute("open");
    menu.current?.querySelector("summary")?.focus();
  };
  useEffect(() => {
    const leave = ({ target }: Event) => {
      if (!(target instanceof Node && menu.current?.contains(target))) menu.current?.removeAttribute("open");
    };
    addEventListener("pointerdown", leave);
    return () => removeEventListener("pointerdown", leave);
  }, []);
  return (
    <details
      ref={menu}
      class={`menu ${kind}`}
      onKeyDown={(event) => event.key === "Escape" && close()}
      onClick={({ target }) => target instanceof Element && target.closest("li button") && close()}
    >
      <summary class="as-button" aria-busy={busy} aria-label={name} title={name}>
        {label}
      </summary>
      <ul>{children}</ul>
    </details>
  );
}
