/** Fig. 4: circle to ellipse, the deformed grids of volume energy alone and of the thin shell. */

import { cells, type Experiment, small, table } from "./experiment";
import { ringStretch } from "./measure";
import { circle, ellipse } from "./shapes";
import { circleToEllipse, HALF_AXES, RADIUS, SHELL, VOLUME, VOLUME_CORNERS } from "./strain";
import { panels } from "./svg";

export const gridsExperiment: Experiment = {
  id: "grids",
  title: "Fig. 4: the deformed grids",
  paper:
    "The circle's match with the ellipse by volume energy alone, and by the thin shell. Volume energy pulls the grid out near the tips and leaves the rest; the shell spreads the stretch evenly along the curve.",
  setup:
    "The shapes and settings of Table 1 on 65² nodes, volume energy with the vertex share θ = 0 and 0.25. Every second grid line is drawn; ticks join points of the circle, equally spaced, with their partners.",
  example: () => ({ reference: circle(RADIUS), template: ellipse(...HALF_AXES), settings: { ...SHELL, finest: 6 } }),
  hasShortForm: false,
  async run(context) {
    const level = 6;
    const variants = [
      { title: "Volume only, θ = 0", settings: VOLUME },
      { title: "Volume only, θ = 0.25", settings: VOLUME_CORNERS },
      { title: "Thin shell", settings: SHELL },
    ];
    const ends = [];
    for (const [i, { title, settings }] of variants.entries()) {
      await context.progress(i / variants.length, title);
      const { end } = await circleToEllipse(context, settings, level);
      ends.push({ title, end, stretch: ringStretch(level, end.deformation, RADIUS) });
    }
    return [
      {
        kind: "figure",
        name: "grids",
        caption: "Left and middle: volume energy alone. Right: the thin shell. Orange: the ellipse.",
        svg: panels(
          ends.map(({ title, end, stretch }) => ({
            title,
            note: `stretch ${stretch.mean.toFixed(2)} ± ${stretch.deviation.toFixed(2)}`,
            level,
            deformation: end.deformation,
            template: end.curves.template,
            reference: end.curves.reference,
            matched: end.curves.matched,
            ticks: true,
          })),
          3,
          300,
        ),
      },
      table(
        ["", "stretch, mean", "deviation", "max mismatch, cells", "least det Dφ"],
        ends.map(({ title, end, stretch }) => [
          title,
          stretch.mean.toFixed(3),
          stretch.deviation.toFixed(3),
          cells(end.status.mismatch.max),
          small(end.status.leastDeterminant),
        ]),
      ),
    ];
  },
};
