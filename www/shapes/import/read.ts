/** Texts that are no drawings, judged by their content and not by a name. */

import { readCsv } from "./csv";
import { type Found, ImportError } from "./found";
import { readJson } from "./json";
import { readTpsShapes } from "./tps";

/** How far into a text its kind shows. */
const HEAD = 400;

/** A word of TPS comes first, even where it is the wrong one, save for remarks. */
const TPS = /^(?:(?:#|\/\/).*\s*)*(?:LM3?|CURVES|OUTLINES|POINTS|IMAGE|ID|SCALE|COMMENT|VARIABLES)\s*=/i;

/** Throws an `ImportError` for whatever is none of JSON, GeoJSON, TPS and CSV. */
export function readText(text: string): Found {
  const start = text.replace(/^\uFEFF/, "").trimStart();
  if (start === "") throw new ImportError("The text is empty.");
  if (/^[{[]/.test(start)) return readJson(start);
  if (TPS.test(start)) return readTpsShapes(text);
  const [line] = start.slice(0, HEAD).split("\n", 1);
  const named = /\bx\b/i.test(line) && /\by\b/i.test(line);
  if (/^[#"\s]*[-+\d.]/.test(start.slice(0, HEAD)) || named) return readCsv(start);
  throw new ImportError(
    "This is none of SVG, PNG, JPEG, WebP, JSON, GeoJSON, TPS and CSV; choose a drawing, a picture or a list of points.",
  );
}
