/** The page of lessons: the list of them, and the one that the address names, step by step. */

import LESSONS from "virtual:lessons";
import { useSignal } from "@preact/signals";
import { render } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { listenForLanguage, sayAbove } from "../controls/changeLanguage";
import { fetched } from "../controls/fetched";
import { begin, readFile } from "../controls/language";
import { lessons as say } from "../words/lessons";
import type { Lesson } from "./lesson";
import { Notes } from "./Notes";
import { StepView } from "./StepView";
import { teaching } from "./teaching";
import "../style.css";
import "./page.css";

type Place = { readonly id: string; readonly step: number };

/** `#bending/3`: a lesson and its step, from 1. */
function placeIn(hash: string): Place | null {
  const [, id, step] = /^#([a-z-]+)(?:\/(\d+))?$/.exec(hash) ?? [];
  return id === undefined || id === "all" ? null : { id, step: Math.max(1, Number(step ?? 1)) };
}

function App() {
  const place = useSignal(placeIn(location.hash));
  useEffect(() => {
    const look = () => {
      place.value = placeIn(location.hash);
    };
    addEventListener("hashchange", look);
    return () => removeEventListener("hashchange", look);
  }, [place]);
  return place.value ? <Opened key={place.value.id} place={place.value} /> : <List />;
}

function List() {
  return (
    <>
      <Teaching />
      <ol class="lessons">
        {LESSONS.map(({ id, title, about, minutes }) => (
          <li key={id}>
            <a href={`#${id}`} lang="en">
              {title}
            </a>
            <p lang="en">{about}</p>
            <p class="minutes">{say.minutes(minutes)}</p>
          </li>
        ))}
      </ol>
    </>
  );
}

function Teaching() {
  return (
    <label class="teaching">
      <input
        type="checkbox"
        checked={teaching.value}
        onChange={(event) => {
          teaching.value = event.currentTarget.checked;
        }}
      />
      {say.teacher}
    </label>
  );
}

/** The lesson's text comes when it is opened. */
function Opened({ place }: { place: Place }) {
  const lesson = useSignal<Lesson | null>(null);
  const problem = useSignal<string | null>(null);
  useEffect(() => {
    const listed = LESSONS.find(({ id }) => id === place.id);
    if (!listed) problem.value = say.unknown(place.id);
    else {
      fetched(say.part, listed.load).then(
        (part) => {
          lesson.value = part.default;
        },
        (error: Error) => {
          problem.value = error.message;
        },
      );
    }
  }, [place.id, lesson, problem]);
  return (
    <>
      <p class="up">
        <a href="#all">{say.list}</a>
        <Teaching />
      </p>
      <div role="alert">{problem.value && <p class="problem">{problem.value}</p>}</div>
      {lesson.value && <Shown lesson={lesson.value} step={Math.min(place.step, lesson.value.steps.length)} />}
    </>
  );
}

function Shown({ lesson, step }: { lesson: Lesson; step: number }) {
  const heading = useRef<HTMLHeadingElement>(null);
  const begun = useRef(false);
  const { id, title, notes, steps } = lesson;
  // Whoever goes on by keyboard or by ear goes on at the new step.
  useEffect(() => {
    if (begun.current) heading.current?.focus();
    begun.current = step > 0;
  }, [step]);
  const count = steps.length;
  return (
    <article class="lesson">
      <h2 lang="en">{title}</h2>
      {teaching.value && notes && step === 1 && <Notes html={notes} />}
      <nav aria-label={say.steps}>
        <ol>
          {steps.map(({ title }, index) => (
            <li key={title}>
              <a
                href={`#${id}/${index + 1}`}
                aria-current={index + 1 === step ? "step" : undefined}
                aria-label={say.step(index + 1, count)}
              >
                {index + 1}
              </a>
            </li>
          ))}
        </ol>
      </nav>
      <StepView key={`${id}/${step}`} step={steps[step - 1]} heading={heading} />
      <p class="ways">
        {step > 1 && (
          <a class="as-button" href={`#${id}/${step - 1}`}>
            {say.previous}
          </a>
        )}
        <span>{say.step(step, count)}</span>
        <a class="as-button next" href={step < count ? `#${id}/${step + 1}` : "#all"}>
          {step < count ? say.next : say.end}
        </a>
      </p>
    </article>
  );
}

const root = document.getElementById("lessons");
if (!root) throw new Error("lessons.html has no #lessons");
readFile("lessonsFile", "h1, .promise, footer p");
const refuse = sayAbove(root);
const show = () => {
  root.replaceChildren();
  render(<App />, root);
  listenForLanguage(refuse);
};
begin().catch(refuse).then(show);
