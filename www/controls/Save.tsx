import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { Draw, Format } from "../export";
import type { Session } from "../session";
import { bandwidth } from "../settings";
import { fetched } from "./fetched";
import { draw, limitOf } from "./viewing";

const FORMATS: readonly { readonly format: Format; readonly label: string; readonly needsMatch: boolean }[] = [
  { format: "png", label: "Picture (PNG)", needsMatch: false },
  { format: "svg", label: "Drawing (SVG)", needsMatch: false },
  { format: "json", label: "Everything (JSON)", needsMatch: false },
  { format: "csv", label: "Matched points (CSV)", needsMatch: true },
  { format: "video", label: "Morph as video (WebM)", needsMatch: true },
  { format: "gif", label: "Morph as GIF", needsMatch: true },
];

/** The formats in which a match can be taken away. */
export function Save({ session }: { session: Session }) {
  const menu = useRef<HTMLDetailsElement>(null);
  const busy = useSignal<string | null>(null);

  useEffect(() => {
    const close = (event: Event) => {
      const target = event.target;
      if (target instanceof Node && menu.current?.contains(target)) return;
      menu.current?.removeAttribute("open");
    };
    addEventListener("pointerdown", close);
    return () => removeEventListener("pointerdown", close);
  }, []);

  const save = async (format: Format, label: string) => {
    menu.current?.removeAttribute("open");
    menu.current?.querySelector("summary")?.focus();
    busy.value = label;
    try {
      const { saved, download } = await fetched("What saves files", () => import("../export"));
      const match = session.match.value;
      const width = bandwidth(session.settings.value);
      const saving = { ...session.shapes.value, settings: session.settings.value, bandwidth: width, match };
      const limit = limitOf(match && { ...match, level: match.status.level }, width);
      const drawn: Draw = (context, frame, colours, scene) => draw(context, frame, colours, scene, limit);
      const file = await saved(saving, format, session.morph.value, drawn);
      download(file);
      if (file.note) session.problem.value = file.note;
    } catch (error) {
      const why = error instanceof Error ? error.message : String(error);
      session.problem.value = `${label} could not be saved. ${why}`;
    } finally {
      busy.value = null;
    }
  };

  const matched = session.match.value !== null;
  return (
    <details
      ref={menu}
      class="save"
      onKeyDown={(event) => {
        if (event.key !== "Escape") return;
        menu.current?.removeAttribute("open");
        menu.current?.querySelector("summary")?.focus();
      }}
    >
      <summary aria-busy={busy.value !== null}>{busy.value ? "Saving …" : "Save"}</summary>
      <ul>
        {FORMATS.map(({ format, label, needsMatch }) => (
          <li key={format}>
            <button
              type="button"
              disabled={busy.value !== null || (needsMatch && !matched)}
              onClick={() => save(format, label)}
            >
              {label}
            </button>
          </li>
        ))}
      </ul>
    </details>
  );
}
