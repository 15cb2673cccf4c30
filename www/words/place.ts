import { page } from "./language";
import { written } from "./numbers";

export const words = page("place", { at: (x: string, y: string) => `${x} across, ${y} up` });

/** A place in the box, for those who hear it: the lower left corner is 0, 0. */
export function place({ x, y }: { readonly x: number; readonly y: number }): string {
  const short = (value: number) => written(String(Number(value.toFixed(3))));
  return words.at(short(x), short(y));
}
