/** Filled icons of Phosphor whose outline says what they are. */

const FILES = import.meta.glob<string>(
  "/node_modules/@phosphor-icons/core/assets/fill/{acorn,airplane,anchor,bell,bird,bone,butterfly,cactus,carrot,clover,club,crown,diamond,dog,drop,egg,feather,fish-simple,flame,footprints,ghost,guitar,hammer,hand,heart,hoodie,horse,key,leaf,lightning,moon,pants,paw-print,puzzle-piece,rocket,shield,sock,star,tree,t-shirt,umbrella,wrench}-fill.svg",
  { query: "?raw", import: "default", eager: true },
);

export const ICONS: readonly { readonly name: string; readonly svg: string }[] = Object.entries(FILES)
  .map(([path, svg]) => ({ name: nameOf(path), svg }))
  .sort((a, b) => a.name.localeCompare(b.name));

function nameOf(path: string): string {
  const word = path.replace(/^.*\/(.*)-fill\.svg$/, "$1").replaceAll("-", " ");
  return word.charAt(0).toUpperCase() + word.slice(1);
}
