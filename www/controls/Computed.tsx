import type { Status } from "../protocol";
import { en } from "../words/en";
import { later } from "../words/later";

/** What computed the last step, in words; files of before do not tell. */
export function computedBy({ backend = "cpu" }: Partial<Pick<Status, "backend">>): string {
  const [, who, told] = /^(cpu|gpu)(?:: (.*))?$/s.exec(backend) ?? [];
  const { card } = later;
  if (who === "gpu") return card.gpu(told ?? "");
  return told ? card.because(card.cpu, en.solver.words(told)) : card.cpu;
}

/** A line of a status, where there was a choice: that the processor computes goes without saying. */
export function Computed({ status }: { readonly status: Status }) {
  if ((status.backend ?? "cpu") === "cpu") return null;
  return (
    <div class="computed">
      <dt>{later.card.by}</dt>
      <dd>
        <data data-name="backend" value={status.backend}>
          {computedBy(status)}
        </data>
      </dd>
    </div>
  );
}
