/** Files made for the tests, and the ways they come into the page. */

import { deflateSync } from "node:zlib";
import { expect, type Page } from "@playwright/test";
import { button, drawn, loops, SIDES, type Side } from "./handles";

export type File = { readonly name: string; readonly mimeType: string; readonly buffer: Buffer };

export function file(name: string, mimeType: string, content: string | Buffer): File {
  return { name, mimeType, buffer: Buffer.from(content as string) };
}

export function svgFile(content: string, name = "drawing.svg"): File {
  return file(name, "image/svg+xml", svg(content));
}

export function svg(content: string, attributes = 'viewBox="0 0 100 100"'): string {
  return `<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" ${attributes}>${content}</svg>`;
}

/** An 8-bit RGBA picture. */
export function png(side: number, pixel: (x: number, y: number) => readonly [number, number, number, number]): Buffer {
  const row = 1 + 4 * side;
  const raw = Buffer.alloc(row * side);
  for (let y = 0; y < side; y += 1) {
    for (let x = 0; x < side; x += 1) raw.set(pixel(x, y), y * row + 1 + 4 * x);
  }
  return pngOf(side, side, 8, 6, raw);
}

/** A black disc on white, one bit a pixel, so that large pictures are small files. */
export function bitDisc(width: number, height: number): Buffer {
  const row = 1 + width / 8;
  const raw = Buffer.alloc(row * height, 0xff);
  const radius = 0.3 * height;
  for (let y = 0; y < height; y += 1) {
    raw[y * row] = 0;
    const half = Math.sqrt(Math.max(0, radius ** 2 - (y - height / 2) ** 2));
    const [from, to] = [Math.ceil((width / 2 - half) / 8), Math.floor((width / 2 + half) / 8)];
    if (to > from) raw.fill(0, y * row + 1 + from, y * row + 1 + to);
  }
  return pngOf(width, height, 1, 0, raw);
}

function pngOf(width: number, height: number, depth: number, kind: number, raw: Buffer): Buffer {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([depth, kind, 0, 0, 0], 8);
  return Buffer.concat([
    Buffer.from("\x89PNG\r\n\x1a\n", "latin1"),
    chunk("IHDR", header),
    chunk("IDAT", deflateSync(raw)),
    chunk("IEND", Buffer.alloc(0)),
  ]);
}

function chunk(kind: string, data: Buffer): Buffer {
  const body = Buffer.concat([Buffer.from(kind, "latin1"), data]);
  const length = Buffer.alloc(4);
  length.writeUInt32BE(data.length);
  const check = Buffer.alloc(4);
  check.writeUInt32BE(crc(body));
  return Buffer.concat([length, body, check]);
}

function crc(bytes: Buffer): number {
  let value = 0xffffffff;
  for (const byte of bytes) {
    value ^= byte;
    for (let bit = 0; bit < 8; bit += 1) value = value & 1 ? (value >>> 1) ^ 0xedb88320 : value >>> 1;
  }
  return (value ^ 0xffffffff) >>> 0;
}

/** A disc of the given ink on the given paper, in the middle of a square picture. */
export function disc(ink: readonly [number, number, number, number], paper: readonly [number, number, number, number]) {
  return png(200, (x, y) => (Math.hypot(x - 99.5, y - 99.5) < 60 ? ink : paper));
}

/** Opens the dialog for one side and chooses the file. */
export async function choose(page: Page, side: Side, chosen: File): Promise<void> {
  await button(page, `Import ${SIDES[side]}`).click();
  await page.getByLabel("Choose a file").setInputFiles({ ...chosen });
}

/** Drops the file on the element that the selector finds. */
export async function drop(page: Page, selector: string, dropped: File): Promise<void> {
  const transfer = await page.evaluateHandle(
    ({ name, mimeType, content }) => {
      const bytes = Uint8Array.from(atob(content), (character) => character.charCodeAt(0));
      const data = new DataTransfer();
      data.items.add(new File([bytes], name, { type: mimeType }));
      return data;
    },
    { name: dropped.name, mimeType: dropped.mimeType, content: dropped.buffer.toString("base64") },
  );
  const marked = page.locator(":root[data-dropping]");
  await page.dispatchEvent(selector, "dragover", { dataTransfer: transfer });
  await expect(marked).toHaveCount(1);
  await page.dispatchEvent(selector, "drop", { dataTransfer: transfer });
  await expect(marked).toHaveCount(0);
}

export type Loop = readonly (readonly [number, number])[];

/** Takes what the dialog shows as the given side's shape, and returns that as the address holds it. */
export async function take(page: Page, side: Side): Promise<Loop[]> {
  const before = drawn(page, side);
  await button(page, `Use as ${SIDES[side]}`).click();
  await expect(page.getByRole("dialog")).toHaveCount(0);
  // The address follows an edit after a moment.
  await expect.poll(() => drawn(page, side)).not.toBe(before);
  return loops(drawn(page, side));
}

/** Enclosed area, holes taken off, in squares of the longer side of the box around the shape. */
export function areaShare(shape: readonly Loop[]): number {
  let area = 0;
  for (const loop of shape) {
    loop.forEach(([x, y], i) => {
      const [u, v] = loop[(i + 1) % loop.length];
      area += (x * v - u * y) / 2;
    });
  }
  const points = shape.flat();
  const span = (axis: 0 | 1) => {
    const values = points.map((point) => point[axis]);
    return Math.max(...values) - Math.min(...values);
  };
  return area / Math.max(span(0), span(1)) ** 2;
}
