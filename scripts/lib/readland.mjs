// A second reader of TPS files, for tests alone, made from the description of the format and of what geomorph's
// `readland.tps` does with it, and of nothing that the page's own reader is made of: lines with "=" tell, all others are
// coordinates, of which each specimen has p pairs, times its scale where every specimen has one.

/** @typedef {{ id: string, image: string, points: [number, number][] }} Landmarks */

/**
 * @param {string} text
 * @returns {Landmarks[]}
 */
export function readland(text) {
  const lines = text.split("\n").filter((line) => line.trim() !== "");
  const told = (/** @type {string} */ word) =>
    lines.filter((line) => line.toUpperCase().startsWith(`${word}=`)).map((line) => line.slice(word.length + 1).trim());
  const counts = told("LM").map(Number);
  const [p] = counts;
  if (p === undefined || p === 0 || counts.some((count) => count !== p))
    throw new Error(`the numbers of landmarks are ${counts.join(", ")}`);
  const scales = told("SCALE")
    .filter((word) => word !== "")
    .map(Number);
  const pairs = lines
    .filter((line) => !line.includes("="))
    .map((line) => {
      const words = line.trim().split(/\s+/).map(Number);
      if (words.length !== 2 || words.some(Number.isNaN)) throw new Error(`“${line}” is no point`);
      return words;
    });
  if (pairs.length !== p * counts.length)
    throw new Error(`${pairs.length} points are no ${counts.length} specimens of ${p}`);
  const [ids, images] = [told("ID"), told("IMAGE")];
  return counts.map((_, n) => {
    const scale = scales.length === counts.length ? (scales[n] ?? 1) : 1;
    const own = pairs.slice(n * p, (n + 1) * p);
    return {
      id: ids.length === counts.length ? (ids[n] ?? "") : "",
      image: images.length === counts.length ? (images[n] ?? "") : "",
      points: own.map(([x = 0, y = 0]) => [scale * x, scale * y]),
    };
  });
}
