/** What a file or a text is, judged by its content. */

import { ImportError } from "./found";

type Kind = "picture" | "text" | { readonly refusal: string };

const PICTURES: readonly (readonly [number, string])[] = [
  [0, "\x89PNG\r\n\x1a\n"],
  [0, "\xff\xd8\xff"],
  [8, "WEBP"],
  [0, "GIF8"],
  [0, "BM"],
  [4, "ftypavif"],
];

const REFUSED: readonly (readonly [string, string])[] = [
  ["%PDF", "This is a PDF; export the drawing as SVG, or the page as PNG."],
  ["PK\x03\x04", "This is an archive or an office document; take the picture or the drawing out of it."],
  ["\x1f\x8b", "This is a compressed file; unpack it first (an .svgz becomes an .svg)."],
  ["%!PS", "This is PostScript; export the drawing as SVG."],
  ["II*\0", "This is a TIFF picture, which browsers do not read; save it as PNG."],
  ["MM\0*", "This is a TIFF picture, which browsers do not read; save it as PNG."],
  ["8BPS", "This is a Photoshop file; export it as PNG."],
];

/** By a file's first bytes, each as a letter. */
export function kindOf(head: string): Kind {
  if (PICTURES.some(([at, magic]) => head.startsWith(magic, at))) return "picture";
  const refused = REFUSED.find(([magic]) => head.startsWith(magic));
  if (refused) return { refusal: refused[1] };
  if (head.includes("\0")) {
    return { refusal: "This is a binary file of an unknown kind; choose an SVG, a picture, JSON or CSV." };
  }
  return "text";
}

/** A drawing's text, whole, or a text of another kind. Throws for markup that is no drawing. */
export function textIn(text: string): { readonly kind: "drawing" | "text"; readonly text: string } {
  const given = text.replace(/^\uFEFF/, "").trimStart();
  if (isPathData(given)) {
    return { kind: "drawing", text: `<svg xmlns="http://www.w3.org/2000/svg"><path d="${given}"/></svg>` };
  }
  if (!given.startsWith("<")) return { kind: "text", text: given };
  if (/<svg[\s>]/i.test(given) && !/^<(!doctype\s+)?html/i.test(given)) return { kind: "drawing", text: given };
  throw new ImportError("This is a web page or other markup, not a drawing; import the SVG itself.");
}

/** What drawing programs copy as the `d` of a path: it begins with a move and holds nothing but commands and numbers. */
export function isPathData(text: string): boolean {
  return /^[Mm][\s,]*[-+.\d][\d\s.,eE+\-MmLlHhVvCcSsQqTtAaZz]*$/.test(text);
}
