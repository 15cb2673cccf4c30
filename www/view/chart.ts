/** A small logarithmic chart of the energy over iterations, levels marked. */

import type { Theme } from "./palette";

export type EnergyPoint = {
  readonly level: number;
  readonly total: number;
  readonly mismatch: number;
};

export function drawEnergies(
  context: CanvasRenderingContext2D,
  width: number,
  height: number,
  ratio: number,
  colours: Theme,
  history: readonly EnergyPoint[],
): void {
  if (history.length < 2) return;
  const positive = history.flatMap((p) => [p.total, p.mismatch]).filter((value) => value > 0 && Number.isFinite(value));
  if (positive.length === 0) return;
  const top = Math.log10(Math.max(...positive));
  // Mismatch goes to zero on an easy pair; more than six decades would flatten the rest.
  const bottom = Math.max(Math.log10(Math.min(...positive)), top - 6);
  const pad = 3 * ratio;
  const x = (i: number) => pad + (i / (history.length - 1)) * (width - 2 * pad);
  const y = (value: number) => {
    const part =
      (Math.max(Math.log10(Math.max(value, Number.MIN_VALUE)), bottom) - bottom) / Math.max(top - bottom, 1e-9);
    return height - pad - part * (height - 2 * pad);
  };
  context.lineWidth = ratio;
  context.strokeStyle = colours.grid;
  context.beginPath();
  for (let i = 1; i < history.length; i += 1) {
    if (history[i].level === history[i - 1].level) continue;
    context.moveTo(x(i), 0);
    context.lineTo(x(i), height);
  }
  context.stroke();
  for (const [name, colour] of [
    ["mismatch", colours.template],
    ["total", colours.ink],
  ] as const) {
    context.beginPath();
    history.forEach((point, i) => {
      if (i === 0) context.moveTo(x(i), y(point[name]));
      else context.lineTo(x(i), y(point[name]));
    });
    context.strokeStyle = colour;
    context.lineWidth = 1.75 * ratio;
    context.lineJoin = "round";
    context.stroke();
  }
}
