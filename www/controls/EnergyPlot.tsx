import { effect, useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import uPlot from "uplot";
import plotStyle from "uplot/dist/uPlot.min.css?inline";
import type { Iteration } from "../protocol";
import type { Session } from "../session";
import { matchAt } from "../view/past";
import { en } from "../words/en";
import { language } from "../words/language";
import { later } from "../words/later";
import { decimals, power } from "../words/numbers";
import { gridName } from "../words/said";
import { adopt } from "./adopt";
import style from "./energyPlot.css?inline";
import { past } from "./viewing";

adopt(plotStyle);
adopt(style);

const HEIGHT = 240;

/** Dashes besides colours, for eyes and printers that tell no colours apart. */
const TERMS = [
  { name: "total", colour: "ink", dash: [] },
  { name: "membrane", colour: "reference", dash: [8, 3] },
  { name: "bending", colour: "bending", dash: [2, 3] },
  { name: "mismatch", colour: "template", dash: [] },
  { name: "volume", colour: "volume", dash: [8, 3, 2, 3] },
] as const;

/** All terms of the energy over all iterations, logarithmic, with a line where a finer grid begins. */
export function EnergyPlot({ session }: { session: Session }) {
  const spoken = language.value;
  const place = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = place.current;
    if (!element) return;
    let plot: uPlot | null = null;
    const make = () => {
      plot?.destroy();
      plot = new uPlot(
        options(element, () => session.energies.peek()),
        columns(session.energies.peek()),
        element,
      );
    };
    make();
    const stop = effect(() => plot?.setData(columns(session.energies.value)));
    const resizes = new ResizeObserver(() => plot?.setSize({ width: element.clientWidth, height: HEIGHT }));
    resizes.observe(element);
    const scheme = matchMedia("(prefers-color-scheme: dark)");
    scheme.addEventListener("change", make);
    return () => {
      stop();
      resizes.disconnect();
      scheme.removeEventListener("change", make);
      plot?.destroy();
    };
    // What the plot says is its own.
  }, [session, spoken]);
  return (
    <figure class="energy-plot">
      <div ref={place} role="img" aria-label={later.energies.title} />
      {session.energies.value.length === 0 && <p>{later.energies.none}</p>}
      <Scrubber session={session} />
    </figure>
  );
}

/** Goes back to any iteration, with the picture of it in the result's place. */
function Scrubber({ session }: { session: Session }) {
  const at = useSignal<number | null>(null);
  const trail = session.energies.value;
  const frame = session.match.value;
  useEffect(() => {
    // Another run, or more of this one: its end is what is shown.
    void trail;
    at.value = null;
    past.value = null;
    return () => {
      past.value = null;
    };
  }, [trail, at]);
  if (!frame || !trail.some(({ kept }) => kept)) return null;
  const show = (index: number) => {
    const last = index >= trail.length - 1;
    // Of late iterations not all are kept: then the last one before it that is.
    const shown = trail.slice(0, index + 1).findLast(({ kept }) => kept);
    const match = last || !shown ? null : matchAt(shown, frame.curves);
    at.value = match && index;
    past.value = match && { match, words: later.past.at(index + 1, trail.length, gridName(trail[index].level)) };
  };
  const index = at.value ?? trail.length - 1;
  return (
    <label class="scrubber">
      {later.past.name}
      <input
        type="range"
        min={0}
        max={trail.length - 1}
        value={index}
        aria-valuetext={later.past.at(index + 1, trail.length, gridName(trail[index].level))}
        onInput={(event) => show(event.currentTarget.valueAsNumber)}
      />
      <output>
        {index + 1} / {trail.length}
      </output>
    </label>
  );
}

/** A logarithm has no place for a term that is left out. */
export function columns(history: readonly Iteration[]): uPlot.AlignedData {
  return [
    history.map((_, i) => i + 1),
    ...TERMS.map(({ name }) => history.map((iteration) => (iteration[name] > 0 ? iteration[name] : null))),
  ];
}

function options(element: HTMLElement, history: () => readonly Iteration[]): uPlot.Options {
  const style = getComputedStyle(element);
  const colour = (name: string) => style.getPropertyValue(`--${name}`).trim();
  const font = `12px ${style.fontFamily}`;
  const axis = { stroke: colour("muted"), grid: { stroke: colour("frame"), width: 1 }, ticks: { show: false }, font };
  return {
    width: element.clientWidth,
    height: HEIGHT,
    scales: { x: { time: false }, y: { distr: 3 } },
    axes: [
      { ...axis, size: 28, label: later.energies.axis, labelFont: font, labelSize: 18 },
      {
        ...axis,
        size: 46,
        grid: { ...axis.grid, filter: (_, splits) => splits.map((value) => (power(value) === null ? null : value)) },
        values: (_, splits) => splits.map((value) => power(value) ?? ""),
      },
    ],
    series: [
      { label: later.energies.iteration, value: (_, value) => (value === null ? "–" : String(value)) },
      ...TERMS.map(({ name, colour: own, dash }) => ({
        label: name === "total" ? later.energies.total : en.terms.names[name],
        stroke: colour(own),
        dash: [...dash],
        width: 1.75,
        points: { show: false },
        value: (_: uPlot, value: number | null) => (value === null ? "–" : decimals(value)),
      })),
    ],
    hooks: { draw: [(plot) => markLevels(plot, history(), colour("muted"), font)] },
  };
}

function markLevels(plot: uPlot, history: readonly Iteration[], stroke: string, font: string): void {
  const { ctx, bbox } = plot;
  ctx.save();
  ctx.strokeStyle = stroke;
  ctx.fillStyle = stroke;
  ctx.lineWidth = devicePixelRatio;
  ctx.font = font.replace("12px", `${11 * devicePixelRatio}px`);
  ctx.textAlign = "left";
  history.forEach(({ level }, i) => {
    if (i > 0 && history[i - 1].level === level) return;
    const x = plot.valToPos(i + (i > 0 ? 0.5 : 1), "x", true);
    ctx.setLineDash([3 * devicePixelRatio, 3 * devicePixelRatio]);
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    ctx.fillText(`${2 ** level + 1}²`, x + 4 * devicePixelRatio, bbox.top + bbox.height - 5 * devicePixelRatio);
  });
  ctx.restore();
}
