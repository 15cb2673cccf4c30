import { useSignal } from "@preact/signals";
import type { RefObject } from "preact";
import { useMemo, useRef } from "preact/hooks";
import { FIELDS } from "../settings";
import { lessons as say } from "../words/lessons";
import { decimals } from "../words/numbers";
import type { Check, Outcome } from "./checks";
import { addressOf, ask, checked } from "./frame";
import type { Step } from "./lesson";
import { Notes } from "./Notes";
import { teaching } from "./teaching";

/** What has come of a press of Check. */
type Result =
  | { readonly kind: "outcomes"; readonly outcomes: readonly Outcome[] }
  | { readonly kind: "told"; readonly words: string };

/** One step; its texts are HTML made of the lesson’s file while the page was built. Its text with what is to be predicted and done, beside the live picture. */
export function StepView({ step, heading }: { step: Step; heading: RefObject<HTMLHeadingElement | null> }) {
  const frame = useRef<HTMLIFrameElement>(null);
  const { title, html, predict, task, notes } = step;
  const address = useMemo(() => addressOf(step.frame, step.state), [step]);
  const begins = useSignal(0);
  const show = (state: string) => {
    const target = frame.current?.contentWindow;
    // Where the frame is not there to hear it, its address tells it.
    if (target)
      ask(target, { kind: "set", state }).catch(() => frame.current?.setAttribute("src", addressOf(step.frame, state)));
  };
  return (
    <div class="step">
      <div class="text">
        <h3 ref={heading} tabIndex={-1} lang="en" dangerouslySetInnerHTML={{ __html: title }} />
        <Prose html={html} />
        {predict && <Predict predict={predict} show={show} />}
        {task && <Task task={task} given={step.state} frame={frame} />}
        {teaching.value && (notes || task) && (
          <div>
            {notes && <Notes html={notes} />}
            {task && (
              <button type="button" onClick={() => show(task.solution)}>
                {say.solution}
              </button>
            )}
          </div>
        )}
      </div>
      <div class="live">
        <iframe key={begins.value} ref={frame} src={address} title={say.frame(plain(title))} allow="clipboard-write" />
        <button
          type="button"
          class="quiet"
          onClick={() => {
            begins.value += 1;
          }}
        >
          {say.again}
        </button>
      </div>
    </div>
  );
}

function Prose({ html }: { html: string }) {
  return <div class="prose" lang="en" dangerouslySetInnerHTML={{ __html: html }} />;
}

type Asking = { readonly predict: NonNullable<Step["predict"]>; readonly show: (state: string) => void };

function Predict({ predict: { question, answer, reveal }, show }: Asking) {
  const open = useSignal(false);
  return (
    <section class="predict" aria-label={say.predict}>
      <h4>{say.predict}</h4>
      <Prose html={question} />
      <button
        type="button"
        aria-expanded={open.value}
        onClick={() => {
          open.value = !open.value;
          if (open.value && reveal !== null) show(reveal);
        }}
      >
        {say.answer}
      </button>
      <div aria-live="polite">{open.value && <Prose html={answer} />}</div>
    </section>
  );
}

type Doing = {
  readonly task: NonNullable<Step["task"]>;
  readonly given: string;
  readonly frame: RefObject<HTMLIFrameElement | null>;
};

function Task({ task: { html, checks }, given, frame }: Doing) {
  const result = useSignal<Result | null>(null);
  const check = async () => {
    const target = frame.current?.contentWindow;
    try {
      if (!target) throw new Error("no frame");
      const outcomes = await checked(target, checks, given);
      result.value = outcomes ? { kind: "outcomes", outcomes } : { kind: "told", words: say.unmatched };
    } catch {
      result.value = { kind: "told", words: say.silent };
    }
  };
  return (
    <section class="task" aria-label={say.task}>
      <h4>{say.task}</h4>
      <Prose html={html} />
      <button type="button" class="primary" onClick={() => void check()}>
        {say.check}
      </button>
      <div role="status">{result.value && <Checked result={result.value} checks={checks} />}</div>
    </section>
  );
}

function Checked({ result, checks }: { result: Result; checks: readonly Check[] }) {
  if (result.kind === "told") return <p>{result.words}</p>;
  const { outcomes } = result;
  const right = outcomes.every(({ holds }) => holds);
  return (
    <>
      <p class={right ? "right" : "wrong"}>{right ? say.checked.right : say.checked.wrong}</p>
      <ul>
        {checks.map((check, index) => (
          <li key={JSON.stringify(check)} class={outcomes[index].holds ? "right" : "wrong"}>
            {wordsOf(check, outcomes[index])}
          </li>
        ))}
      </ul>
    </>
  );
}

function wordsOf(check: Check, { found }: Outcome): string {
  const value = (one: number | string | boolean) => (typeof one === "number" ? decimals(one) : say.value(one));
  switch (check.kind) {
    case "shapes":
      return `${say.shapes}: ${say.value(found)}`;
    case "point":
      return say.holds(say.point(...check.from), say.off(Number(found)), say.signs["<="], decimals(check.within));
    case "pins":
      return say.holds(say.pins, String(found), say.signs[check.sign], String(check.value));
    case "setting": {
      const label = FIELDS.find(({ name }) => name === check.name)?.label ?? check.name;
      return say.holds(label, value(found), say.signs[check.sign], value(check.value));
    }
    case "number":
      return say.holds(say.numbers[check.name], value(found), say.signs[check.sign], value(check.value));
  }
}

/** A title's words, for what takes no formulas. */
function plain(html: string): string {
  return html.replace(/<[^>]*>/g, "");
}
