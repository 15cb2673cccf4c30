import { AxeBuilder } from "@axe-core/playwright";
import { expect, type Page, test } from "@playwright/test";
import { areaShare, bitDisc, choose, disc, drop, file, type Loop, png, svg, svgFile, take } from "./files";
import { button, drawn, finished, value, watch } from "./handles";

const SQUARE = '<rect x="10" y="10" width="50" height="50"/>';
const BLACK = [0, 0, 0, 255] as const;
const WHITE = [255, 255, 255, 255] as const;

test.beforeEach(async ({ page }) => {
  await page.goto("./#v=1&preset=ellipse&finest=5");
});

test.describe("by the file chooser", () => {
  test("an SVG becomes the reference, and one undo takes it back", async ({ page }) => {
    const seen = watch(page);
    await choose(page, "Reference", svgFile(SQUARE));
    await expect(page.getByRole("img", { name: /^Preview: 1 loop, \d+ points/ })).toBeVisible();
    expect(areaShare(await take(page, "Reference"))).toBeCloseTo(1, 3);
    await button(page, "Match").click();
    await finished(page);
    expect(await value(page, "mismatch-max")).toBeLessThan(0.5);
    await button(page, "Undo").click();
    await expect(button(page, "Undo")).toBeDisabled();
    await expect.poll(() => page.url()).toContain("preset=ellipse");
    expect(seen.errors).toEqual([]);
  });

  test("a PNG becomes the template", async ({ page }) => {
    await choose(page, "Template", file("disc.png", "image/png", disc(BLACK, WHITE)));
    const shape = await take(page, "Template");
    expect(shape).toHaveLength(1);
    expect(areaShare(shape)).toBeCloseTo(Math.PI / 4, 2);
    await button(page, "Match").click();
    await finished(page);
    expect(await value(page, "mismatch-max")).toBeLessThan(0.5);
  });

  test("a list in JSON lets one choose", async ({ page }) => {
    const list = [
      {
        name: "first",
        points: [
          [0.3, 0.3],
          [0.7, 0.3],
          [0.7, 0.7],
          [0.3, 0.7],
        ],
      },
      {
        name: "second",
        class: "triangle",
        points: [
          [0.3, 0.3],
          [0.7, 0.3],
          [0.3, 0.7],
        ],
      },
    ];
    await choose(page, "Template", file("list.json", "application/json", JSON.stringify(list)));
    await page.getByLabel("Shape", { exact: true }).selectOption("second");
    await expect(page.getByLabel("Place")).toHaveValue("asIs");
    const [loop] = await take(page, "Template");
    expect(Math.min(...loop.map(([x]) => x))).toBeCloseTo(0.3, 4);
    expect(areaShare([loop])).toBeCloseTo(0.5, 3);
  });

  test("CSV and GeoJSON", async ({ page }) => {
    await choose(page, "Reference", file("points.csv", "text/csv", "x,y\n0,0\n4,0\n4,4\n0,4\n\n1,1\n3,1\n3,3\n1,3\n"));
    expect(areaShare(await take(page, "Reference"))).toBeCloseTo(0.75, 3);
    const ring = [
      [0, 0],
      [0.1, 0],
      [0.1, 0.1],
      [0, 0.1],
      [0, 0],
    ];
    const feature = {
      type: "Feature",
      properties: { name: "Patch" },
      geometry: { type: "Polygon", coordinates: [ring] },
    };
    await choose(page, "Template", file("patch.geojson", "", JSON.stringify(feature)));
    expect(areaShare(await take(page, "Template"))).toBeCloseTo(1, 3);
  });

  test("JPEG and WebP as the browser writes them", async ({ page }) => {
    for (const type of ["image/jpeg", "image/webp"]) {
      const address = await page.evaluate((kind) => {
        const canvas = document.createElement("canvas");
        [canvas.width, canvas.height] = [300, 200];
        const context = canvas.getContext("2d");
        if (!context) throw new Error("no 2D canvas");
        context.fillStyle = "#fff";
        context.fillRect(0, 0, 300, 200);
        context.fillStyle = "#123";
        context.fillRect(50, 50, 200, 100);
        return canvas.toDataURL(kind, 0.8);
      }, type);
      await choose(page, "Reference", file("box", type, Buffer.from(address.split(",")[1], "base64")));
      expect(areaShare(await take(page, "Reference"))).toBeCloseTo(0.5, 1);
    }
  });
});

test.describe("by drop and paste", () => {
  test("what is dropped on a panel is for that side", async ({ page }) => {
    await drop(page, "[aria-label='Template shape']", svgFile(SQUARE, "dropped.svg"));
    await expect(page.getByRole("dialog", { name: "Import a target" })).toBeVisible();
    await expect(page.getByText("From dropped.svg")).toBeVisible();
    expect(areaShare(await take(page, "Template"))).toBeCloseTo(1, 3);
    await drop(page, "[aria-label='Reference shape']", file("disc.png", "image/png", disc(WHITE, BLACK)));
    expect(areaShare(await take(page, "Reference"))).toBeCloseTo(Math.PI / 4, 2);
    const list = [
      {
        name: "one",
        points: [
          [0, 0],
          [9, 0],
          [0, 9],
        ],
      },
    ];
    await drop(page, "body", file("list.json", "application/json", JSON.stringify(list)));
    expect(areaShare(await take(page, "Reference"))).toBeCloseTo(0.5, 3);
  });

  test("a second drop while the dialog is open replaces the first", async ({ page }) => {
    await drop(page, "body", svgFile(SQUARE, "one.svg"));
    await expect(page.getByText("From one.svg")).toBeVisible();
    await drop(page, "dialog", svgFile('<circle r="9"/>', "two.svg"));
    await expect(page.getByText("From two.svg")).toBeVisible();
    expect(areaShare(await take(page, "Reference"))).toBeCloseTo(Math.PI / 4, 2);
  });

  test("pasted text and pasted pictures", async ({ page }) => {
    await paste(page, { text: svg(SQUARE) });
    await expect(page.getByText("From the pasted text")).toBeVisible();
    expect(areaShare(await take(page, "Reference"))).toBeCloseTo(1, 3);
    await paste(page, { picture: disc(BLACK, WHITE).toString("base64") });
    expect(areaShare(await take(page, "Template"))).toBeCloseTo(Math.PI / 4, 2);
  });

  test("text can be pasted into a field, as phones need it", async ({ page }) => {
    await button(page, "Import reference").click();
    await page.getByText("Paste text here").click();
    await page.getByLabel("SVG, path data, JSON or CSV text").fill("0 0\n2 0\n2 1\n0 1");
    expect(areaShare(await take(page, "Reference"))).toBeCloseTo(0.5, 3);
  });
});

async function paste(page: Page, what: { text?: string; picture?: string }): Promise<void> {
  await page.evaluate(({ text, picture }) => {
    const data = new DataTransfer();
    if (text) data.setData("text/plain", text);
    if (picture) {
      const bytes = Uint8Array.from(atob(picture), (character) => character.charCodeAt(0));
      data.items.add(new File([bytes], "image.png", { type: "image/png" }));
    }
    document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true }));
  }, what);
}

test.describe("SVG", () => {
  const ring = '<path fill-rule="RULE" d="M0 0h80v80h-80zM20 20h40v40h-40z"/>';
  const cases: readonly (readonly [string, string, number, number])[] = [
    ["even–odd leaves a hole", ring.replace("RULE", "evenodd"), 0.75, 2],
    ["non-zero fills it when both run the same way", ring.replace("RULE", "nonzero"), 1, 1],
    ["non-zero leaves it when they do not", '<path d="M0 0h80v80h-80zM20 20v40h40v-40z"/>', 0.75, 2],
    ["a turned square", `<g transform="rotate(45 50 50)"><g transform="translate(3)">${SQUARE}</g></g>`, 0.5, 1],
    ["a sheared square", `<g transform="matrix(1 0 1 1 0 0)">${SQUARE}</g>`, 0.25, 1],
    ["a transform in a style", `<g style="transform: scale(2, 1)">${SQUARE}</g>`, 0.5, 1],
    ["a circle", '<circle cx="50%" cy="30" r="2mm"/>', Math.PI / 4, 1],
    ["an ellipse", '<ellipse rx="20" ry="10"/>', Math.PI / 8, 1],
    ["round corners", '<rect width="40" height="40" rx="20"/>', Math.PI / 4, 1],
    ["a polygon", '<polygon points="0,0 40,0 0,40"/>', 0.5, 1],
    ["a polyline, closed by its fill", '<polyline points="0 0 40 0 0 40"/>', 0.5, 1],
    ["arcs", '<path d="M0 20a20 20 0 1 1 40 0a20 20 0 0 1-40 0z"/>', Math.PI / 4, 1],
    ["smooth curves", '<path d="M0 0c0 10 30 10 30 0s30-10 30 0v40h-60z"/>', 40 / 60, 1],
    ["overlapping figures unite", `${SQUARE}<rect x="35" y="10" width="75" height="50"/>`, 0.5, 1],
    [
      "use and symbol",
      '<defs><rect id="r" width="10" height="10"/><symbol id="s" viewBox="0 0 5 5"><rect width="5" height="5"/></symbol></defs>' +
        '<use href="#r" x="40"/><use xlink:href="#s" x="0" y="0" width="10" height="10"/>',
      0.08,
      2,
    ],
    [
      "an inner svg with a view box",
      `${SQUARE}<svg x="60" y="10" width="50" height="50" viewBox="0 0 1 1"><rect width="1" height="1"/></svg>`,
      0.5,
      1,
    ],
    [
      "rules of a style sheet",
      `<style>.a { fill: none } #b { display: none }</style><line class="a" stroke="red" x2="9"/><path class="a" d="M0 0h99v9"/><rect id="b" width="99" height="9"/>${SQUARE}`,
      1,
      1,
    ],
    ["closed outlines without a fill", '<path fill="none" stroke="red" d="M0 0h40v20h-40z"/>', 0.5, 1],
    [
      "what is not painted where it stands",
      `<clipPath id="c"><circle r="90"/></clipPath><mask id="m"><circle r="80"/></mask>${SQUARE}`,
      1,
      1,
    ],
    [
      "paper behind everything is left out",
      `<rect width="100" height="100" fill="#fff"/><circle cx="50" cy="50" r="20"/>`,
      Math.PI / 4,
      1,
    ],
  ];
  for (const [title, content, area, loops] of cases) {
    test(title, async ({ page }) => {
      await choose(page, "Reference", svgFile(content));
      const shape = await take(page, "Reference");
      expect(shape).toHaveLength(loops);
      expect(areaShare(shape)).toBeCloseTo(area, 2);
    });
  }

  test("y points down in the drawing and up in the box", async ({ page }) => {
    await choose(page, "Reference", svgFile('<polygon points="0,0 40,0 0,40"/>'));
    const [loop] = await take(page, "Reference");
    // The right angle is at the upper left.
    expect(nearest(loop, 0.2, 0.8)).toBeLessThan(1e-3);
    expect(nearest(loop, 0.2, 0.2)).toBeLessThan(1e-3);
    expect(nearest(loop, 0.8, 0.2)).toBeGreaterThan(0.3);
  });

  test("one figure of several can be chosen", async ({ page }) => {
    await choose(page, "Reference", svgFile(`${SQUARE}<circle id="moon" cx="80" cy="80" r="9"/>`));
    await page.getByLabel("Shape", { exact: true }).selectOption("moon");
    expect(areaShare(await take(page, "Reference"))).toBeCloseTo(Math.PI / 4, 2);
  });

  for (const [rule, told] of [
    [":nth-child(2) { fill: none }", true],
    ["@media screen { rect { display: none } }", true],
    [":nth-child(2) { opacity: 0.5 }", false],
    ["@media print { rect { display: none } } @font-face { src: url(a.woff) } rect { stroke: red }", false],
  ] as const) {
    test(`of the style sheet “${rule}” ${told ? "it is told that it is left out" : "there is nothing to tell"}`, async ({
      page,
    }) => {
      await choose(page, "Reference", svgFile(`<style>${rule}</style>${SQUARE}`));
      await expect(page.getByRole("img", { name: /^Preview/ })).toBeVisible();
      await expect(page.getByText("Some rules of the drawing's style sheet are left out")).toHaveCount(told ? 1 : 0);
    });
  }

  test("neither scripts run nor references are followed", async ({ page }) => {
    await page.waitForLoadState("networkidle");
    const seen = watch(page);
    const hostile =
      `<script>window.ran = 1</script><style>@import url(/style.css); rect { background: url(/rule.png) }</style>` +
      `<image href="/picture.png" onload="window.ran = 1" onerror="window.ran = 1" width="9" height="9"/>` +
      `<use href="/other.svg#a"/><g onload="window.ran = 1">${SQUARE}</g><foreignObject><img xmlns="http://www.w3.org/1999/xhtml" src="/frame.png" onerror="window.ran = 1"/></foreignObject>`;
    await choose(page, "Reference", svgFile(hostile));
    await expect(page.getByText("Pictures inside the drawing are left out")).toBeVisible();
    await expect(page.getByText("Parts kept in other files are left out")).toBeVisible();
    expect(areaShare(await take(page, "Reference"))).toBeCloseTo(1, 3);
    expect(await page.evaluate(() => "ran" in window)).toBe(false);
    expect(seen.requests.filter((address) => /style\.css$|\.png|other\.svg/.test(address))).toEqual([]);
    expect(seen.errors).toEqual([]);
  });
});

test.describe("pictures", () => {
  test("transparency decides where there is some", async ({ page }) => {
    await choose(page, "Reference", file("clear.png", "image/png", disc([255, 255, 255, 255], [255, 255, 255, 0])));
    expect(areaShare(await take(page, "Reference"))).toBeCloseTo(Math.PI / 4, 2);
  });

  test("parts, holes, sides and threshold can be chosen", async ({ page }) => {
    // A ring and, lighter, a bar beside it.
    const picture = png(200, (x, y) => {
      const r = Math.hypot(x - 70, y - 99.5);
      if (r < 60 && r > 30) return [20, 20, 20, 255];
      return x > 150 && x < 180 && y > 40 && y < 160 ? [150, 150, 150, 255] : WHITE;
    });
    await choose(page, "Reference", file("ring.png", "image/png", picture));
    const preview = page.getByRole("img", { name: /^Preview/ });
    await page.getByLabel("Threshold").fill("60");
    await expect(preview).toHaveAccessibleName(/3 loops/);
    await page.getByLabel("Parts", { exact: true }).selectOption("largest");
    await expect(preview).toHaveAccessibleName(/2 loops/);
    await page.getByLabel("Holes", { exact: true }).selectOption("fill");
    await expect(preview).toHaveAccessibleName(/1 loop,/);
    await page.getByLabel("Parts", { exact: true }).selectOption("all");
    await page.getByLabel("Holes", { exact: true }).selectOption("keep");
    await page.getByLabel("Threshold").fill("180");
    await expect(preview).toHaveAccessibleName(/2 loops/);
    await page.getByLabel("Inside is").selectOption("light");
    await expect(page.getByText("The shape reaches the picture's edge and is cut there.")).toBeVisible();
    await page.getByLabel("Inside is").selectOption("dark");
    await page.getByLabel("Threshold").fill("254");
    await expect(page.getByText("Nothing is inside at this threshold; move the slider.")).toBeVisible();
    await expect(button(page, "Use as reference")).toBeDisabled();
    await button(page, "Automatic threshold").click();
    await expect(button(page, "Use as reference")).toBeEnabled();
  });

  test("fifty megapixels are read while the page goes on", async ({ page }) => {
    await button(page, "Import reference").click();
    await page.evaluate(() => {
      Object.assign(window, { beats: 0 });
      const beat = () => {
        Reflect.set(window, "beats", Reflect.get(window, "beats") + 1);
        requestAnimationFrame(beat);
      };
      requestAnimationFrame(beat);
    });
    const before = await page.evaluate(() => Reflect.get(window, "beats"));
    await page.getByLabel("Choose a file").setInputFiles({ ...file("large.png", "image/png", bitDisc(8192, 6144)) });
    await expect(page.getByText("The picture of 8192 × 6144 pixels is read at 640 × 480.")).toBeVisible({
      timeout: 30_000,
    });
    // On the page's own thread the decoding would leave no frame but the first and the last.
    expect((await page.evaluate(() => Reflect.get(window, "beats"))) - before).toBeGreaterThan(8);
    const shape = await take(page, "Reference");
    expect(shape).toHaveLength(1);
    expect(areaShare(shape)).toBeCloseTo(Math.PI / 4, 2);
  });
});

test.describe("rubbish is refused with a reason, and the shapes stay", () => {
  const uniform = png(50, () => [120, 120, 120, 255]);
  const cases: readonly (readonly [string, Parameters<typeof file>, RegExp])[] = [
    [
      "a broken SVG",
      ["a.svg", "image/svg+xml", svg("<g><rect/>")],
      /The SVG is broken \(line \d+.*save or copy it again/,
    ],
    [
      "an SVG of open lines",
      ["a.svg", "image/svg+xml", svg('<path fill="none" stroke="red" d="M0 0L9 9"/>')],
      /only open lines/,
    ],
    ["an empty SVG", ["a.svg", "image/svg+xml", svg("")], /no paths and no basic shapes/],
    ["a drawing that uses itself", ["a.svg", "image/svg+xml", svg('<g id="a"><use href="#a"/></g>')], /uses itself/],
    ["broken path data", ["a.svg", "image/svg+xml", svg('<path d="M0 0L9"/>')], /Path data cannot be read/],
    ["a picture that is cut off", ["a.png", "image/png", disc(BLACK, WHITE).subarray(0, 60)], /cannot be decoded/],
    ["a picture of one colour", ["a.png", "image/png", uniform], /nearly uniform: there is no outline/],
    ["a PDF", ["a.pdf", "application/pdf", "%PDF-1.7\n"], /This is a PDF; export the drawing as SVG/],
    ["an archive", ["a.zip", "application/zip", "PK\x03\x04abc"], /archive/],
    ["a binary file", ["a.bin", "", Buffer.from([1, 0, 2, 0])], /binary file of an unknown kind/],
    ["a web page", ["a.html", "text/html", "<!doctype html><html><svg></svg></html>"], /web page/],
    ["prose", ["a.txt", "text/plain", "Dear reader"], /none of SVG, PNG, JPEG/],
    ["nothing", ["a.txt", "text/plain", ""], /The file is empty/],
    ["broken JSON", ["a.json", "application/json", "{"], /The JSON is broken/],
    ["a table with words", ["a.csv", "text/csv", "1,2\n3,x\n"], /Line 2: “x” is not a number/],
    ["another page's match", ["a.json", "application/json", '{"format":"thinshell","version":9}'], /version 9/],
  ];
  for (const [title, given, message] of cases) {
    test(title, async ({ page }) => {
      const seen = watch(page);
      await choose(page, "Reference", file(...given));
      await expect(page.getByRole("dialog").getByRole("alert")).toContainText(message);
      await expect(button(page, "Use as reference")).toHaveCount(0);
      // Something better may follow at once.
      await page.getByLabel("Choose a file").setInputFiles({ ...svgFile(SQUARE) });
      await expect(page.getByRole("dialog").getByRole("alert")).toBeEmpty();
      await button(page, "Close").click();
      expect(page.url()).toContain("preset=ellipse");
      await expect(button(page, "Undo")).toBeDisabled();
      // Of broken XML the browser makes a page with styles of its own, which the policy refuses it.
      const own = title === "a broken SVG" ? /^Applying inline style violates/ : /^$/;
      expect(seen.errors.filter((error) => !own.test(error))).toEqual([]);
    });
  }
});

test("the gallery has real silhouettes, with credits, from this server only", async ({ page, baseURL }) => {
  await page.waitForLoadState("networkidle");
  const seen = watch(page);
  await button(page, "Import target").click();
  await button(page, "Gallery").click();
  const things = page.getByRole("region", { name: "Things" }).getByRole("button");
  const countries = page.getByRole("region", { name: "Countries" }).getByRole("button");
  await expect(countries.first()).toBeVisible();
  expect(await countries.count()).toBeGreaterThanOrEqual(25);
  expect((await things.count()) + (await countries.count())).toBeGreaterThanOrEqual(60);
  await expect(page.getByText("From Phosphor Icons (MIT licence).")).toBeVisible();
  await expect(page.getByText(/From Natural Earth, through world-atlas \(public domain/)).toBeVisible();
  const paths = await page
    .locator(".gallery path")
    .evaluateAll((all) => all.map((path) => path.getAttribute("d") ?? ""));
  expect(paths.length).toBeGreaterThanOrEqual(60);
  expect(paths.every((path) => path.length > 60)).toBe(true);
  expect(seen.requests.every((address) => address.startsWith(baseURL ?? "") || /^(blob|data):/.test(address))).toBe(
    true,
  );

  await button(page, "Italy").click();
  const italy = await take(page, "Template");
  expect(italy).toHaveLength(1);
  // The mainland fills about a quarter of the square around it.
  expect(areaShare(italy)).toBeGreaterThan(0.15);
  expect(areaShare(italy)).toBeLessThan(0.35);

  await button(page, "Import reference").click();
  await button(page, "Gallery").click();
  await button(page, "Heart").click();
  await take(page, "Reference");
  await button(page, "Match").click();
  await finished(page);
  expect(seen.errors).toEqual([]);
});

test("a gallery that cannot be fetched says so", async ({ page }) => {
  await button(page, "Import target").click();
  await page.route("**/gallery-*.js", (route) => route.abort());
  await button(page, "Gallery").click();
  await expect(page.getByRole("dialog").getByRole("alert")).toContainText("The gallery could not be loaded");
});

test("everything goes by the keyboard", async ({ page }) => {
  const opener = button(page, "Import reference");
  await opener.focus();
  await page.keyboard.press("Enter");
  const dialog = page.getByRole("dialog", { name: "Import a reference" });
  await expect(dialog).toBeVisible();
  for (let i = 0; i < 12; i += 1) {
    await page.keyboard.press("Tab");
    // Nothing behind the dialog is reached; the browser's own frame may be, where focus is on the body.
    expect(
      await page.evaluate(
        () => document.activeElement === document.body || document.activeElement?.closest("dialog") !== null,
      ),
    ).toBe(true);
  }
  await page.keyboard.press("Escape");
  await expect(dialog).toHaveCount(0);
  await expect(opener).toBeFocused();
  await opener.press("Enter");
  await button(page, "Gallery").press("Enter");
  await button(page, "Heart").press("Enter");
  await expect(button(page, "Use as reference")).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(dialog).toHaveCount(0);
  await expect.poll(() => drawn(page, "Reference")).toBeTruthy();
});

for (const colorScheme of ["light", "dark"] as const) {
  for (const [width, height] of [
    [1280, 800],
    [390, 844],
  ]) {
    test.describe(`${colorScheme}, ${width} pixels`, () => {
      test.use({ colorScheme, viewport: { width, height } });

      test("the dialog has no accessibility violation and fits", async ({ page }) => {
        const check = async () => {
          expect((await new AxeBuilder({ page }).include("dialog").analyze()).violations).toEqual([]);
          const wide = await page.evaluate(() => {
            const dialog = document.querySelector("dialog");
            return Math.max(document.documentElement.scrollWidth, dialog?.getBoundingClientRect().right ?? 0);
          });
          expect(wide).toBeLessThanOrEqual(width);
          const inner = await page.evaluate(() => {
            const dialog = document.querySelector("dialog");
            return (dialog?.scrollWidth ?? 1) - (dialog?.clientWidth ?? 0);
          });
          expect(inner).toBeLessThanOrEqual(0);
        };
        await choose(page, "Reference", file("a.txt", "text/plain", "Dear reader"));
        await expect(page.getByRole("dialog").getByRole("alert")).not.toBeEmpty();
        await check();
        await page.getByLabel("Choose a file").setInputFiles({ ...file("disc.png", "image/png", disc(BLACK, WHITE)) });
        await expect(page.getByLabel("Threshold")).toBeVisible();
        await check();
        await button(page, "Gallery").click();
        await expect(button(page, "Italy")).toBeVisible();
        await check();
      });
    });
  }
}

function nearest(loop: Loop, x: number, y: number): number {
  return Math.min(...loop.map(([u, v]) => Math.hypot(u - x, v - y)));
}
