/** The morph from the identity to the match and back as a film. */

import { applyPalette, GIFEncoder, quantize } from "gifenc";
import type { Square } from "../view/framing";
import type { Theme } from "../view/palette";
import type { ResultScene } from "../view/result";
import { files } from "../words/files";
import { type Draw, paint } from "./png";

/** The scene at a part 0…1 of the deformation. */
export type SceneAt = (morph: number) => ResultScene;

export type Film = { readonly blob: Blob; readonly extension: string };

const GIF_SIDE = 480;
const GIF_STEPS = 24;
const GIF_FRAME_MILLIS = 60;
const GIF_HOLD_MILLIS = 700;

const VIDEO_SIDE = 720;
const VIDEO_MILLIS = 4000;
const VIDEO_RATE = 30;
const VIDEO_BITS_PER_SECOND = 4_000_000;

/** What browsers record, the best first. Safari has no WebM. */
const VIDEO_TYPES = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"];

/** Null where the browser records none. */
export function videoType(): string | null {
  if (typeof MediaRecorder === "undefined" || !("captureStream" in HTMLCanvasElement.prototype)) return null;
  return VIDEO_TYPES.find((type) => MediaRecorder.isTypeSupported(type)) ?? null;
}

/** Part of the deformation at a part of the film: there smoothly, a rest, back smoothly. */
function morphAt(part: number): number {
  const rise = Math.min(1, Math.min(part, 1 - part) / 0.4);
  return (1 - Math.cos(Math.PI * Math.max(0, rise))) / 2;
}

/** Paints a part 0…1 of the way onto the whole of a canvas. */
export type PaintPart = (canvas: HTMLCanvasElement, morph: number) => CanvasRenderingContext2D;

/** Records in real time, some four seconds. Null where the browser records none, or nothing. */
export async function video(sceneAt: SceneAt, square: Square, colours: Theme, draw: Draw): Promise<Film | null> {
  return filmed((canvas, morph) => paint(canvas, square, sceneAt(morph), colours, draw));
}

/** The same of whatever can be painted. */
export async function filmed(paintPart: PaintPart): Promise<Film | null> {
  const type = videoType();
  return type ? recorded(type, paintPart).catch(() => null) : null;
}

async function recorded(type: string, paintPart: PaintPart): Promise<Film | null> {
  const canvas = document.createElement("canvas");
  canvas.width = VIDEO_SIDE;
  canvas.height = VIDEO_SIDE;
  paintPart(canvas, 0);
  const stream = canvas.captureStream(VIDEO_RATE);
  const recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: VIDEO_BITS_PER_SECOND });
  const pieces: Blob[] = [];
  recorder.ondataavailable = ({ data }) => pieces.push(data);
  const stopped = new Promise<void>((resolve, reject) => {
    recorder.onstop = () => resolve();
    recorder.onerror = () => reject(new Error(files.recorder));
  });
  recorder.start();
  const begin = performance.now();
  for (let part = 0; part < 1; part = (performance.now() - begin) / VIDEO_MILLIS) {
    paintPart(canvas, morphAt(part));
    await pause(1000 / VIDEO_RATE);
  }
  recorder.stop();
  await stopped;
  for (const track of stream.getTracks()) track.stop();
  // A recorder that got no frame ends without an error and without a byte.
  if (pieces.every(({ size }) => size === 0)) return null;
  const bare = type.split(";")[0];
  return { blob: new Blob(pieces, { type: bare }), extension: bare === "video/mp4" ? "mp4" : "webm" };
}

export async function gif(sceneAt: SceneAt, square: Square, colours: Theme, draw: Draw): Promise<Film> {
  return animated((canvas, morph) => paint(canvas, square, sceneAt(morph), colours, draw));
}

/** Plays everywhere and for ever. One palette for all frames, from both ends of the morph and its middle. */
export async function animated(paintPart: PaintPart): Promise<Film> {
  const canvas = document.createElement("canvas");
  canvas.width = GIF_SIDE;
  canvas.height = GIF_SIDE;
  const pixels = (morph: number) => paintPart(canvas, morph).getImageData(0, 0, GIF_SIDE, GIF_SIDE).data;
  const typical = [0, 0.5, 1];
  const samples = new Uint8ClampedArray(typical.length * 4 * GIF_SIDE * GIF_SIDE);
  typical.forEach((morph, i) => {
    samples.set(pixels(morph), (i * samples.length) / typical.length);
  });
  const palette = quantize(samples, 256);
  const frames: Uint8Array[] = [];
  for (let step = 0; step <= GIF_STEPS; step += 1) {
    frames.push(applyPalette(pixels((1 - Math.cos((Math.PI * step) / GIF_STEPS)) / 2), palette));
    // The page stays alive between frames.
    await pause(0);
  }
  const encoder = GIFEncoder();
  const back = frames.slice(1, -1).reverse();
  [...frames, ...back].forEach((frame, i) => {
    const held = i === 0 || i === GIF_STEPS;
    encoder.writeFrame(frame, GIF_SIDE, GIF_SIDE, {
      ...(i === 0 ? { palette, repeat: 0 } : {}),
      delay: held ? GIF_HOLD_MILLIS : GIF_FRAME_MILLIS,
    });
  });
  encoder.finish();
  return { blob: new Blob([encoder.bytes()], { type: "image/gif" }), extension: "gif" };
}

function pause(millis: number): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, millis));
}
