import { useEffect, useRef } from "preact/hooks";
import { framing, seenOf } from "../view/framing";
import { theme } from "../view/palette";
import { drawResult, type ResultScene } from "../view/result";

/** Side in CSS pixels. */
const SIDE = 96;

/** A small picture of two shapes and, where there is one, their match; drawn once, and again in another scheme. */
export function Thumbnail({ scene }: { readonly scene: ResultScene }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const draw = () => {
      const context = canvas.current?.getContext("2d");
      if (!context) return;
      const side = SIDE * devicePixelRatio;
      context.canvas.width = side;
      context.canvas.height = side;
      const { left, bottom, size } = framing(seenOf(scene));
      const frame = { left, bottom, scale: side / size, width: side, height: side, ratio: devicePixelRatio / 2 };
      drawResult(context, frame, theme(), scene);
    };
    draw();
    const scheme = matchMedia("(prefers-color-scheme: dark)");
    scheme.addEventListener("change", draw);
    return () => scheme.removeEventListener("change", draw);
  }, []);
  return <canvas ref={canvas} />;
}
