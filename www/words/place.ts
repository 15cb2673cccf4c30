/** A place in the box, for those who hear it: the lower left corner is 0, 0. */
export function place({ x, y }: { readonly x: number; readonly y: number }): string {
  const short = (value: number) => String(Number(value.toFixed(3)));
  return `${short(x)} across, ${short(y)} up`;
}
