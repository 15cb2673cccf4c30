/**
 * `<thin-shell-match>`: two shapes and their match in any page. docs/element.md says how it is used.
 *
 *     <thin-shell-match state="v=2&preset=letters" controls="view morph numbers"></thin-shell-match>
 */

import { effect } from "@preact/signals";
import { numbersOf } from "../embed/report";
import { bandwidth, type Chosen } from "../settings";
import base from "../style/base.css?inline";
import { Surface } from "../view/canvas";
import { framing, type Square } from "../view/framing";
import { VIEWS } from "../view/names";
import { pattern } from "../view/picture";
import { drawMissed, drawResult, type ResultScene } from "../view/result";
import { missedBy } from "../view/unreached";
import { drawView, limitOf } from "../view/views";
import { en } from "../words/en";
import { resultState } from "../words/said";
import style from "./element.css?inline";
import { type GivenLoop, type GivenPin, Matching } from "./matching";

export const TAG = "thin-shell-match";
const CONTROLS = ["view", "morph", "numbers"];

const sheet = new CSSStyleSheet();
// What is of the page's root there is of the element here.
sheet.replaceSync(base.replaceAll(":root", ":host").replaceAll("body {", ".none {") + style);

export class ThinShellMatch extends HTMLElement {
  static readonly observedAttributes = ["state", "view", "morph", "controls"];

  readonly #matching = new Matching();
  readonly #root: ShadowRoot;
  #stops: (() => void)[] = [];
  #waiting = false;

  constructor() {
    super();
    this.#root = this.attachShadow({ mode: "open" });
    this.#root.adoptedStyleSheets = [sheet];
  }

  connectedCallback(): void {
    this.#build();
    this.#stops.push(this.#matching.whenFinal(() => this.#tell("match", this.report)));
    this.#stops.push(
      effect(() => {
        const problem = this.#matching.problem.value;
        if (problem) this.#tell("problem", problem);
      }),
    );
    this.#soon();
  }

  disconnectedCallback(): void {
    for (const stop of this.#stops) stop();
    this.#stops = [];
    this.#root.replaceChildren();
    this.#matching.dispose();
  }

  attributeChangedCallback(name: string, _: string | null, value: string | null): void {
    this.#try(() => {
      if (name === "state" && value !== null) {
        this.#matching.set(value);
        this.#soon();
      } else if (name === "view") this.#matching.setView(value ?? "grid");
      else if (name === "morph") this.morph = Number(value ?? 1);
      else if (name === "controls" && this.isConnected) this.#build();
    });
  }

  /** Loops of a side: x y x y …, or lists of points. Throws a sentence where they are none. */
  set reference(loops: readonly GivenLoop[]) {
    this.#matching.setShape("reference", loops);
    this.#soon();
  }

  get reference(): readonly GivenLoop[] {
    return this.#matching.shapes.peek().reference;
  }

  set template(loops: readonly GivenLoop[]) {
    this.#matching.setShape("template", loops);
    this.#soon();
  }

  get template(): readonly GivenLoop[] {
    return this.#matching.shapes.peek().template;
  }

  set pins(pins: readonly GivenPin[]) {
    this.#matching.setPins(pins);
    this.#soon();
  }

  set settings(settings: Chosen) {
    this.#matching.settings.value = { ...settings };
    this.#soon();
  }

  set view(name: string) {
    this.#matching.setView(name);
  }

  /** 0 shows the identity, 1 the match. */
  set morph(part: number) {
    if (part >= 0 && part <= 1) this.#matching.morph.value = part;
  }

  /** The numbers of the final match of what is given now; null before. */
  get report() {
    const match = this.#matching.final.peek();
    return match && numbersOf(match.status);
  }

  get problem(): string | null {
    return this.#matching.problem.peek();
  }

  /** φ at points [x, y] of the box; null without a match. */
  map(points: readonly (readonly [number, number])[]): [number, number][] | null {
    return this.#matching.map(points);
  }

  /** Several changes of one moment are one run. */
  #soon(): void {
    if (this.#waiting || !this.isConnected) return;
    this.#waiting = true;
    queueMicrotask(() => {
      this.#waiting = false;
      if (this.isConnected) this.#matching.start();
    });
  }

  #tell(name: string, detail: unknown): void {
    this.dispatchEvent(new CustomEvent(name, { detail, bubbles: true, composed: true }));
  }

  #try(change: () => void): void {
    try {
      change();
    } catch (error) {
      const why = error instanceof Error ? error.message : String(error);
      this.#matching.problem.value = `${why.charAt(0).toUpperCase()}${why.slice(1)}.`;
    }
  }

  #build(): void {
    for (const stop of this.#stops.splice(0)) stop();
    const wanted = (this.getAttribute("controls") ?? CONTROLS.join(" ")).split(/\s+/);
    const canvas = document.createElement("canvas");
    canvas.setAttribute("role", "img");
    const place = document.createElement("div");
    place.className = "surface";
    place.append(canvas);
    this.#root.replaceChildren(place);
    if (wanted.includes("view")) this.#root.append(this.#viewPicker());
    if (wanted.includes("morph")) this.#root.append(this.#morphSlider());
    this.#root.append(this.#words(wanted.includes("numbers")));
    this.#draw(canvas);
  }

  #draw(canvas: HTMLCanvasElement): void {
    const { shapes, settings, view, morph, match, phase } = this.#matching;
    let square: Square | null = null;
    const seen = () => {
      const { reference, template } = shapes.peek();
      square = framing([...reference, ...template], square);
      return square;
    };
    const surface = new Surface(canvas, seen, (context, frame, colours) => {
      const found = match.peek();
      const shown = found && { ...found, level: found.status.level };
      const width = bandwidth(settings.peek());
      const missed = missedBy(found);
      const scene: ResultScene = { ...shapes.peek(), match: shown, morph: morph.peek(), bandwidth: width, missed };
      const name = view.peek();
      if (name === "grid" || !shown) drawResult(context, frame, colours, scene);
      else {
        const limit = limitOf(name, shown, width) || 1;
        drawView(name, context, frame, colours, { ...scene, match: shown, limit, picture: pattern() });
        if (name !== "pullback") drawMissed(context, frame, colours, missed);
      }
    });
    this.#stops.push(
      effect(() => {
        for (const value of [shapes, settings, view, morph]) value.value;
        const status = match.value?.status ?? null;
        canvas.setAttribute("aria-label", resultState({ phase: phase.value, status, stale: false }));
        surface.invalidate();
      }),
      () => surface.dispose(),
    );
  }

  #viewPicker(): HTMLElement {
    const select = document.createElement("select");
    select.setAttribute("aria-label", "View");
    for (const view of VIEWS) select.add(new Option(en.views[view], view));
    select.onchange = () => this.#matching.setView(select.value);
    this.#stops.push(
      effect(() => {
        select.value = this.#matching.view.value;
      }),
    );
    return select;
  }

  #morphSlider(): HTMLElement {
    const slider = document.createElement("input");
    Object.assign(slider, { type: "range", min: "0", max: "1", step: "0.01" });
    slider.setAttribute("aria-label", "Morph");
    slider.oninput = () => {
      this.morph = slider.valueAsNumber;
    };
    this.#stops.push(
      effect(() => {
        slider.value = String(this.#matching.morph.value);
        slider.disabled = this.#matching.match.value === null;
      }),
    );
    return slider;
  }

  /** What is wrong is said in any case, the rest where it is wanted. */
  #words(isWanted: boolean): HTMLElement {
    const line = document.createElement("p");
    line.setAttribute("role", "status");
    this.#stops.push(
      effect(() => {
        const { problem, match, phase } = this.#matching;
        const status = match.value?.status;
        const said = status?.verdict ?? resultState({ phase: phase.value, status: status ?? null, stale: false });
        line.textContent = problem.value ?? (isWanted ? said : "");
        line.className = problem.value ? "problem" : "";
      }),
    );
    return line;
  }
}

/** Once a page, however often the module comes. */
export function define(): void {
  if (!customElements.get(TAG)) customElements.define(TAG, ThinShellMatch);
}
