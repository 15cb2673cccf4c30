import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Collection, Silhouette } from "../gallery";
import { prepared } from "../shapes/import/fit";
import type { Found } from "../shapes/import/found";

type Thumbnail = Silhouette & { readonly path: string };
type Shown = Omit<Collection, "silhouettes"> & { readonly silhouettes: readonly Thumbnail[] };

type Props = {
  readonly onChoose: (found: Found, name: string) => void;
  readonly onProblem: (problem: unknown) => void;
};

/** Silhouettes to take, with their credits; fetched when it is opened. */
export function Gallery({ onChoose, onProblem }: Props) {
  const shown = useSignal<readonly Shown[] | null>(null);
  useEffect(() => {
    import("../gallery").then(
      ({ collections }) => {
        shown.value = collections().map((collection) => ({
          ...collection,
          silhouettes: collection.silhouettes.map((silhouette) => ({ ...silhouette, path: pathOf(silhouette.found) })),
        }));
      },
      () => onProblem(new Error("The gallery could not be loaded; check the connection and open it again.")),
    );
    // Once for each opening.
  }, [shown]);

  if (!shown.value) return <p role="status">Loading the gallery …</p>;
  return (
    <div class="gallery">
      {shown.value.map(({ title, source, address, licence, silhouettes }) => (
        <section key={title} aria-label={title}>
          <h3>{title}</h3>
          <ul>
            {silhouettes.map(({ name, found, path }) => (
              <li key={name}>
                <button type="button" onClick={() => onChoose(found, `${name}, ${source}`)}>
                  <svg viewBox="0.16 0.16 0.68 0.68" aria-hidden="true">
                    <path d={path} />
                  </svg>
                  <span>{name}</span>
                </button>
              </li>
            ))}
          </ul>
          <p class="help">
            From <a href={address}>{source}</a> ({licence}).
          </p>
        </section>
      ))}
    </div>
  );
}

function pathOf(found: Found): string {
  if (found.kind !== "shapes") return "";
  const [choice] = found.choices;
  const { shape } = prepared(choice.loops, {
    parts: choice.mainPart ? "largest" : "all",
    holes: "keep",
    placement: "fit",
    smoothing: choice.smoothing,
  });
  return shape
    .map((loop) => {
      let text = "";
      for (let i = 0; i < loop.length; i += 4) {
        text += `${i === 0 ? "M" : "L"}${loop[i].toFixed(3)} ${(1 - loop[i + 1]).toFixed(3)}`;
      }
      return `${text}Z`;
    })
    .join("");
}
