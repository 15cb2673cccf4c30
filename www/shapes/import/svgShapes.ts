/** SVG's basic shapes as path data. */

/** Reads a length of an element; `direction` says what percentages are of. */
export type Length = (element: Element, name: string, direction: "width" | "height" | "diagonal") => number;

/** Null for elements that are no basic shape; empty for those that paint nothing. */
export function basicShape(element: Element, length: Length): string | null {
  switch (element.localName.toLowerCase()) {
    case "rect":
      return rectangle(element, length);
    case "circle": {
      const r = length(element, "r", "diagonal");
      return oval(length(element, "cx", "width"), length(element, "cy", "height"), r, r);
    }
    case "ellipse":
      return oval(
        length(element, "cx", "width"),
        length(element, "cy", "height"),
        length(element, "rx", "width"),
        length(element, "ry", "height"),
      );
    case "polygon":
      return corners(element, "Z");
    case "polyline":
      return corners(element, "");
    default:
      return null;
  }
}

function rectangle(element: Element, length: Length): string {
  const width = length(element, "width", "width");
  const height = length(element, "height", "height");
  if (!(width > 0 && height > 0)) return "";
  const x = length(element, "x", "width");
  const y = length(element, "y", "height");
  // One radius stands for both, and neither exceeds half a side.
  const named = (name: string) => element.hasAttribute(name);
  const across = length(element, named("rx") ? "rx" : "ry", named("rx") ? "width" : "height");
  const up = length(element, named("ry") ? "ry" : "rx", named("ry") ? "height" : "width");
  const rx = Math.min(across, width / 2);
  const ry = Math.min(up, height / 2);
  if (!(rx > 0 && ry > 0)) return `M${x} ${y}h${width}v${height}h${-width}Z`;
  const arc = (dx: number, dy: number) => `a${rx} ${ry} 0 0 1 ${dx} ${dy}`;
  return (
    `M${x + rx} ${y}h${width - 2 * rx}${arc(rx, ry)}v${height - 2 * ry}${arc(-rx, ry)}` +
    `h${2 * rx - width}${arc(-rx, -ry)}v${2 * ry - height}${arc(rx, -ry)}Z`
  );
}

function oval(x: number, y: number, rx: number, ry: number): string {
  if (!(rx > 0 && ry > 0)) return "";
  return `M${x - rx} ${y}a${rx} ${ry} 0 1 0 ${2 * rx} 0a${rx} ${ry} 0 1 0 ${-2 * rx} 0Z`;
}

function corners(element: Element, end: string): string {
  const numbers = (element.getAttribute("points") ?? "").match(/[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?/gi) ?? [];
  const even = numbers.slice(0, numbers.length - (numbers.length % 2));
  return even.length >= 6 ? `M${even.join(" ")}${end}` : "";
}
