import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Collection } from "../gallery";
import type { FoundShapes } from "../shapes/import/found";
import { imports as say } from "../words/imports";
import { fetched } from "./fetched";

type Props = {
  readonly onChoose: (found: FoundShapes, name: string) => void;
  readonly onProblem: (problem: unknown) => void;
};

/** Silhouettes to take, with their credits; fetched when it is opened. */
export function Gallery({ onChoose, onProblem }: Props) {
  const shown = useSignal<readonly Collection[] | null>(null);
  useEffect(() => {
    fetched(say.galleryWhat, () => import("../gallery"))
      .then(({ collections }) => {
        shown.value = collections();
      })
      .catch(onProblem);
    // Once for each opening.
  }, [shown]);

  if (!shown.value)
    return (
      <p class="awaited" role="status">
        {say.galleryLoading}
      </p>
    );
  return (
    <div class="gallery">
      {shown.value.map(({ title, source, address, licence, silhouettes }) => (
        <section key={title} aria-label={title}>
          <h3>{title}</h3>
          <ul>
            {silhouettes.map(({ name: english, found, path }) => {
              const name = say.silhouette(english);
              return (
                <li key={english}>
                  <button type="button" onClick={() => onChoose(found, `${name}, ${source}`)}>
                    <svg viewBox="0.16 0.16 0.68 0.68" aria-hidden="true">
                      <path d={path} />
                    </svg>
                    <span>{name}</span>
                  </button>
                </li>
              );
            })}
          </ul>
          <p class="help">
            {say.sourceFrom} <a href={address}>{source}</a> ({licence}).
          </p>
        </section>
      ))}
    </div>
  );
}
