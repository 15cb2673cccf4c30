/** Drawings and lists made to keep a page from answering: it goes on, and they are read, simplified or refused. */

import { expect, type Page, test } from "@playwright/test";
import { choose, type File, file, svg, svgFile, take } from "./files";
import { button, watch } from "./handles";

/** The same numbers every time. */
function random(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

function scribble(points: number, next: () => number, size: number): string {
  const [x, y] = [(100 - size) * next(), (100 - size) * next()];
  const at = () => `${(x + size * next()).toFixed(2)} ${(y + size * next()).toFixed(2)}`;
  return `M${Array.from({ length: points }, at).join("L")}Z`;
}

function comb(teeth: number): string {
  const tooth = (k: number) => `${k} 0 ${k + 0.5} 0 ${k + 0.5} 40 ${k + 0.9} 40`;
  return `<polygon points="${Array.from({ length: teeth }, (_, k) => tooth(k)).join(" ")} ${teeth} 0 ${teeth} -0.001 0 -0.001"/>`;
}

function doubled(times: number): string {
  const uses = Array.from(
    { length: times },
    (_, k) => `<g id="g${k + 1}"><use href="#g${k}"/><use href="#g${k}" x="${k}"/></g>`,
  );
  return `<defs><rect id="g0" width="1" height="1"/>${uses.join("")}</defs><use href="#g${times}"/>`;
}

const next = random(7);
const OPEN = "{".repeat(100_000);

/** Everything that is read, whatever it costs. */
const READ: readonly (readonly [string, File])[] = [
  ["a comb of 220 teeth", svgFile(comb(220))],
  [
    "20,000 random paths",
    svgFile(Array.from({ length: 20_000 }, () => `<path d="${scribble(5, next, 10)}"/>`).join("")),
  ],
  ["one path that crosses itself everywhere", svgFile(`<path d="${scribble(30_000, next, 99)}"/>`)],
  [
    "a style sheet nested a hundred thousand deep",
    svgFile(`<style>g ${OPEN.replaceAll("{", "{ g ")}</style><rect width="9" height="9"/>`),
  ],
  [
    "a list of 60,000 points in every direction",
    file("a.csv", "text/csv", Array.from({ length: 60_000 }, () => `${next()},${next()}`).join("\n")),
  ],
];

/** Everything that is more than anybody draws. */
const REFUSED: readonly (readonly [string, File, RegExp])[] = [
  ["use nested 2^16 times", svgFile(doubled(16)), /more than 50000 elements, each use of one counted; simplify it/],
  [
    "a million path commands",
    svgFile(`<path d="M0 0${"l1 1".repeat(1_000_000)}"/>`),
    /more than 300000 path commands; simplify its paths first/,
  ],
  ["a million elements", svgFile("<g/>".repeat(1_000_000)), /more than 50000 elements/],
  [
    "a transform of a million letters",
    svgFile(`<g transform="${"a".repeat(1_000_000)}"><rect width="9" height="9"/></g>`),
    /The transform “a+…” cannot be read/,
  ],
  [
    "entities of entities",
    file(
      "a.svg",
      "image/svg+xml",
      `<!DOCTYPE svg [<!ENTITY a "xx"><!ENTITY b "&a;&a;"><!ENTITY c "&b;&b;">]>${svg('<path d="&c;"/>')}`,
    ),
    /abbreviates its text by entities; save it as plain SVG/,
  ],
  [
    "a style sheet of ten thousand rules",
    svgFile(`<style>${".a{fill:none}".repeat(10_000)}</style><rect width="9" height="9"/>`),
    /a style sheet of too many rules/,
  ],
  ["JSON nested a million deep", file("a.json", "application/json", "[".repeat(1_000_000)), /The JSON is broken/],
];

/** How long a beat takes on the average, in milliseconds, from when a file is chosen until it is shown or refused. */
async function beats(page: Page): Promise<() => Promise<number>> {
  await page.evaluate(() => {
    const begin = () => {
      let count = 0;
      const since = performance.now();
      const beat = setInterval(() => {
        count += 1;
      }, 0);
      const end = new MutationObserver(() => {
        if (!document.querySelector("dialog [role=img], dialog [role=alert]:not(:empty)")) return;
        clearInterval(beat);
        end.disconnect();
        Reflect.set(window, "beats", (performance.now() - since) / (count + 1));
      });
      end.observe(document, { subtree: true, childList: true, characterData: true });
    };
    document.addEventListener("change", begin, { capture: true, once: true });
  });
  return async () => {
    await page.waitForFunction(() => "beats" in window);
    return page.evaluate(() => Reflect.get(window, "beats"));
  };
}

/** Every 4 ms where nothing else is done. One block of work lets through no more than what comes before and after it. */
const SELDOM = 150;

test.beforeEach(async ({ page }) => {
  await page.goto("./#v=1&preset=ellipse&finest=5");
});

for (const [title, given] of READ) {
  test(`${title}: read while the page goes on`, async ({ page }) => {
    test.slow();
    const count = await beats(page);
    await choose(page, "Reference", given);
    await expect(page.getByRole("img", { name: /^Preview: \d+ loops?, \d+ points/ })).toBeVisible({ timeout: 120_000 });
    expect(await count()).toBeLessThan(SELDOM);
    const shape = await take(page, "Reference");
    expect(shape.length).toBeGreaterThan(0);
    expect(shape.length).toBeLessThanOrEqual(60);
    for (const loop of shape) expect(loop.length).toBeLessThanOrEqual(600);
  });
}

for (const [title, given, message] of REFUSED) {
  test(`${title}: refused with a reason, while the page goes on`, async ({ page }) => {
    const seen = watch(page);
    const count = await beats(page);
    await choose(page, "Reference", given);
    await expect(page.getByRole("dialog").getByRole("alert")).toContainText(message, { timeout: 45_000 });
    expect(await count()).toBeLessThan(SELDOM);
    // Something better may follow at once.
    await page.getByLabel("Choose a file").setInputFiles({ ...svgFile('<rect width="9" height="9"/>') });
    await take(page, "Reference");
    expect(seen.errors).toEqual([]);
  });
}

test("a reading that takes long shows how far it is, and can be stopped", async ({ page }) => {
  const long = READ.find(([title]) => title === "20,000 random paths");
  if (!long) throw new Error("the list has no such drawing");
  await choose(page, "Reference", long[1]);
  await expect(page.getByRole("progressbar", { name: "Import" })).toBeVisible();
  await button(page, "Stop").click();
  await expect(page.getByRole("progressbar", { name: "Import" })).toHaveCount(0);
  await expect.poll(() => page.workers().length).toBe(1);
  await page.getByLabel("Choose a file").setInputFiles({ ...svgFile('<rect width="9" height="9"/>') });
  expect(await take(page, "Reference")).toHaveLength(1);
});
