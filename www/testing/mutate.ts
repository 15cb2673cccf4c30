/** Damage to links, the same every time. */

/** Numbers from 0 to 1. */
export function seeded(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

const LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.=&%+~:/?#'\"<> \u0000é💥";

const HOSTILE = [
  "<img src=x onerror=\"Reflect.set(window,'injected',1)\">",
  "</script><script>Reflect.set(window,'injected',1)</script>",
  "javascript:Reflect.set(window,'injected',1)",
  "__proto__[injected]=1",
  "constructor.prototype.injected",
  "%",
  "%00",
  "%E0%A4%A",
  "1e309",
  "-0",
  "NaN",
  "A".repeat(5000),
  ".".repeat(3000),
];

/** A text with one to three places changed, cut out, doubled, or filled with what does harm elsewhere. */
export function mutate(text: string, random: () => number): string {
  let out = text;
  const times = 1 + Math.floor(3 * random());
  for (let i = 0; i < times; i += 1) {
    const at = Math.floor(random() * out.length);
    const end = at + Math.floor(random() * 12);
    const letters = [...LETTERS];
    const letter = letters[Math.floor(random() * letters.length)];
    const hostile = HOSTILE[Math.floor(random() * HOSTILE.length)];
    const kind = Math.floor(random() * 7);
    if (kind <= 1) out = out.slice(0, at) + letter + out.slice(at + 1);
    else if (kind === 2) out = out.slice(0, at) + out.slice(end);
    else if (kind === 3) out = out.slice(0, at);
    else if (kind === 4) out = out.slice(0, end) + out.slice(at);
    else if (kind === 5) out = out.slice(0, at) + hostile + out.slice(end);
    else out = out.replace(/=[^&]*/, `=${hostile}`);
  }
  return out;
}
