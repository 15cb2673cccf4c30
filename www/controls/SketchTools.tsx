import { useEffect } from "preact/hooks";
import { chosen, kit } from "../pins/kit";
import type { Session } from "../session";
import { kit as further } from "../tools/kit";
import { choose, said, type ToolName, tool } from "../tools/tool";
import { words } from "../words/tools";

const TOOLS: readonly ToolName[] = ["draw", "circle", "polygon", "mirror", "points", "pin"];

/** What the hand does on both surfaces, with a sentence on what comes next. */
export function SketchTools({ session }: { session: Session }) {
  const take = (wanted: ToolName) => {
    choose(wanted).catch((problem: Error) => {
      session.problem.value = problem.message;
    });
  };
  // What undo takes away cannot be chosen.
  const count = session.shapes.value.pins.length;
  useEffect(() => {
    if (chosen.value !== null && chosen.value >= count) chosen.value = null;
  }, [count]);
  const Actions = (tool.value === "pin" ? kit : further).value?.Actions;
  return (
    <div class="sketch-tools">
      {/* biome-ignore lint/a11y/useSemanticElements: a fieldset would be one more frame around the buttons */}
      <div class="segments" role="group" aria-label={words.group}>
        {TOOLS.map((own) => (
          <button
            key={own}
            type="button"
            title={words[own].help}
            aria-pressed={tool.value === own}
            onClick={() => take(own)}
          >
            {words[own].label}
          </button>
        ))}
      </div>
      <p class="guide">{guide(session)}</p>
      {Actions && <Actions session={session} />}
      <p class="unseen" aria-live="polite">
        {said}
      </p>
    </div>
  );
}

/** What can be done next. */
function guide(session: Session): string {
  if (tool.value === "pin" && kit.value) return kit.value.guide(session);
  const said = tool.value !== "draw" && further.value?.guide();
  if (said) return said;
  const { reference, template } = session.shapes.value;
  return reference.length === 0 || template.length === 0 ? words.drawFirst : words.drawOn;
}
