/** What a file is, judged by its content and not by its name, and who reads it. */

import { readCsv } from "./csv";
import { type Found, ImportError } from "./found";
import { readImage } from "./image";
import { readJson } from "./json";
import { readSvg } from "./svg";

export type { Choice, Found, Picture } from "./found";
export { ImportError } from "./found";

/** Larger files than these are no outlines. */
const MOST_TEXT = 40e6;
const MOST_PICTURE = 400e6;

export type Read = Found & { readonly preview?: ImageBitmap };

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

/** Throws an `ImportError` for whatever is neither of SVG, picture, JSON, GeoJSON and CSV. */
export async function readFile(file: Blob): Promise<Read> {
  if (file.size === 0) throw new ImportError("The file is empty.");
  const head = String.fromCharCode(...new Uint8Array(await file.slice(0, 64).arrayBuffer()));
  const kind = kindOf(head);
  if (typeof kind === "object") throw new ImportError(kind.refusal);
  if (kind === "picture") {
    if (file.size > MOST_PICTURE) throw new ImportError("The picture has more than 400 MB; make it smaller.");
    const { picture, preview, notes } = await readImage(file);
    return { kind: "picture", picture, preview, notes };
  }
  if (file.size > MOST_TEXT) throw new ImportError("The file has more than 40 MB; simplify the drawing first.");
  return readText(await file.text());
}

export function readText(text: string): Found {
  const start = text.replace(/^\uFEFF/, "").trimStart();
  if (start === "") throw new ImportError("The text is empty.");
  if (/^[{[]/.test(start)) return readJson(start);
  if (start.startsWith("<")) {
    if (/<svg[\s>]/i.test(start) && !/^<(!doctype\s+)?html/i.test(start)) return readSvg(start);
    throw new ImportError("This is a web page or other markup, not a drawing; import the SVG itself.");
  }
  if (/^[#"\s]*[-+\d.]/.test(start) || /^[^\n]*\bx\b[^\n]*\by\b/i.test(start)) return readCsv(start);
  throw new ImportError(
    "This is none of SVG, PNG, JPEG, WebP, JSON, GeoJSON and CSV; choose a drawing, a picture or a list of points.",
  );
}

function kindOf(head: string): Kind {
  if (PICTURES.some(([at, magic]) => head.startsWith(magic, at))) return "picture";
  const refused = REFUSED.find(([magic]) => head.startsWith(magic));
  if (refused) return { refusal: refused[1] };
  if (head.includes("\0")) {
    return { refusal: "This is a binary file of an unknown kind; choose an SVG, a picture, JSON or CSV." };
  }
  return "text";
}
