/** A symbol of the formulas beside the word for it, an index after a low line. */
export function Sign({ text }: { text: string }) {
  const [letter, index] = text.split("_");
  return (
    <span class="symbol" aria-hidden="true">
      {letter}
      {index && <sub>{index}</sub>}
    </span>
  );
}
