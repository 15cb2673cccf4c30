import { lessons as say } from "../words/lessons";

/** What is for the teacher alone. */
export function Notes({ html }: { html: string }) {
  return (
    <div class="notes">
      <h3>{say.forTeacher}</h3>
      <div lang="en" dangerouslySetInnerHTML={{ __html: html }} />
    </div>
  );
}
