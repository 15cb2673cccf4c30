/**
 * `<thin-shell-match>`: two shapes and their match in any page. docs/element.md says how it is used.
 *
 *     <thin-shell-match state="v=2&preset=letters" controls="view morph numbers"></thin-shell-match>
 */

import { computed, effect, signal } from "@preact/signals";
import { numbersOf } from "../embed/report";
import { asSentence } from "../run";
import type { Chosen } from "../settings";
import base from "../style/base.css?inline";
import style from "./element.css?inline";
import { type GivenLoop, type GivenPin, type GivenPoint, Matching } from "./matching";
import { morphSlider, picture, viewPicker, words } from "./parts";
import type * as Declared from "./thin-shell-match";

export const TAG = "thin-shell-match";
const CONTROLS = ["view", "morph", "numbers"];
/** What may have been set before the module had come, and then stands in the way of the class's own. */
const PROPERTIES = ["reference", "template", "pins", "settings", "view", "morph"] as const;

const sheet = new CSSStyleSheet();
// What is of the page's root there is of the element here.
sheet.replaceSync(base.replaceAll(":root", ":host").replaceAll("body {", ".none {") + style);

export class ThinShellMatch extends HTMLElement {
  static readonly observedAttributes = ["state", "view", "morph", "controls"];

  readonly #matching = new Matching();
  readonly #root: ShadowRoot;
  /** What is wrong with what has been given, by its name: until that is given anew. */
  readonly #wrong = signal<Readonly<Record<string, string>>>({});
  readonly #problem = computed(() => Object.values(this.#wrong.value)[0] ?? this.#matching.problem.value);
  /** What ends with the parts that are shown, and what with the element's stay in the page. */
  #parts: (() => void)[] = [];
  #stops: (() => void)[] = [];
  #waiting = false;

  constructor() {
    super();
    this.#root = this.attachShadow({ mode: "open" });
    this.#root.adoptedStyleSheets = [sheet];
  }

  connectedCallback(): void {
    for (const name of PROPERTIES) {
      if (!Object.hasOwn(this, name)) continue;
      const value = Reflect.get(this, name);
      Reflect.deleteProperty(this, name);
      this.#try(name, () => Reflect.set(this, name, value));
    }
    this.#build();
    this.#stops = [
      this.#matching.whenFinal(() => this.#tell("match", this.report)),
      effect(() => {
        const problem = this.#problem.value;
        if (problem) this.#tell("problem", problem);
      }),
    ];
    this.#soon();
  }

  disconnectedCallback(): void {
    for (const stop of [...this.#stops.splice(0), ...this.#parts.splice(0)]) stop();
    this.#root.replaceChildren();
    this.#matching.dispose();
  }

  attributeChangedCallback(name: string, _: string | null, value: string | null): void {
    this.#try(name, () => {
      if (name === "state" && value !== null) {
        this.#matching.set(value);
        this.#soon();
      } else if (name === "view") this.#matching.setView(value ?? "grid");
      else if (name === "morph") this.#matching.setMorph(value?.trim() === "" ? Number.NaN : Number(value ?? 1));
      else if (name === "controls") {
        if (this.isConnected) this.#build();
        this.#wanted(true);
      }
    });
  }

  /** Loops of a side: x y x y …, or lists of points. Throws a sentence where they are none. */
  set reference(loops: readonly GivenLoop[]) {
    this.#matching.setShape("reference", loops);
    this.#given("reference");
  }

  get reference(): readonly GivenLoop[] {
    return this.#matching.shapes.peek().reference;
  }

  set template(loops: readonly GivenLoop[]) {
    this.#matching.setShape("template", loops);
    this.#given("template");
  }

  get template(): readonly GivenLoop[] {
    return this.#matching.shapes.peek().template;
  }

  set pins(pins: readonly GivenPin[]) {
    this.#matching.setPins(pins);
    this.#given("pins");
  }

  get pins(): readonly GivenPin[] {
    return this.#matching.shapes.peek().pins.map(({ reference: p, template: q }) => [p.x, p.y, q.x, q.y]);
  }

  set settings(settings: Chosen) {
    this.#matching.setSettings(settings);
    this.#given("settings");
  }

  get settings(): Chosen {
    return this.#matching.settings.peek();
  }

  set view(name: string) {
    this.#matching.setView(name);
    this.#right("view");
  }

  get view(): string {
    return this.#matching.view.peek();
  }

  /** 0 shows the identity, 1 the match. */
  set morph(part: number) {
    this.#matching.setMorph(part);
    this.#right("morph");
  }

  get morph(): number {
    return this.#matching.morph.peek();
  }

  /** The numbers of the final match of what is given now; null before. */
  get report() {
    const match = this.#matching.final.peek();
    return match && numbersOf(match.status);
  }

  get problem(): string | null {
    return this.#problem.peek();
  }

  /** φ at points [x, y] of the box; null without a match. */
  map(points: readonly GivenPoint[]): [number, number][] | null {
    return this.#matching.map(points);
  }

  #given(name: string): void {
    this.#right(name);
    this.#soon();
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

  #right(name: string): void {
    const { [name]: _, ...others } = this.#wrong.peek();
    this.#wrong.value = others;
  }

  #try(name: string, change: () => void): void {
    try {
      change();
      this.#right(name);
    } catch (error) {
      // Of a property, by its name.
      const problem = asSentence(error instanceof Error ? error.message : String(error));
      this.#wrong.value = { ...this.#wrong.peek(), [name]: problem };
    }
  }

  /** The controls that are asked for; those that there are not are a problem where that is to be said. */
  #wanted(isStrict: boolean): readonly string[] {
    const wanted = (this.getAttribute("controls") ?? CONTROLS.join(" ")).split(/\s+/).filter(Boolean);
    const other = wanted.find((name) => !CONTROLS.includes(name));
    if (isStrict && other !== undefined)
      throw new Error(`there is no control “${other}”; there are ${CONTROLS.join(", ")}`);
    return wanted;
  }

  #build(): void {
    for (const stop of this.#parts.splice(0)) stop();
    const wanted = this.#wanted(false);
    this.#root.replaceChildren();
    this.#parts = [
      picture(this.#root, this.#matching),
      ...(wanted.includes("view") ? [viewPicker(this.#root, this.#matching)] : []),
      ...(wanted.includes("morph") ? [morphSlider(this.#root, this.#matching)] : []),
      words(this.#root, this.#matching, this.#problem, wanted.includes("numbers")),
    ];
  }
}

/** Once a page, however often the module comes. */
export function define(): void {
  if (!customElements.get(TAG)) customElements.define(TAG, ThinShellMatch satisfies typeof Declared.ThinShellMatch);
}
