import { useComputed } from "@preact/signals";
import type { Session, Side } from "../session";
import { said } from "../tools/tool";
import { exchange } from "../words/tools";
import { Menu } from "./Menu";

const OTHER = { reference: "template", template: "reference" } as const;

/** Swaps the two shapes, or makes one of them what the other is. */
export function Exchange({ session }: { session: Session }) {
  const isEmpty = useComputed(() => {
    const { reference, template } = session.shapes.value;
    return { reference: reference.length === 0, template: template.length === 0 };
  });
  const swap = () => {
    const { reference, template, pins, examples } = session.present;
    session.commitShapes(
      {
        reference: template,
        template: reference,
        pins: pins.map((pin) => ({ reference: pin.template, template: pin.reference })),
      },
      { reference: examples.template, template: examples.reference },
    );
    said.value = exchange.swapped(pins.length);
  };
  /** Pins lead to what is gone then. */
  const copy = (from: Side) => {
    const { pins, examples, [from]: shape } = session.present;
    session.commitShapes(
      { reference: shape, template: shape, pins: [] },
      { reference: examples[from], template: examples[from] },
    );
    said.value = exchange.copied(from, pins.length);
    if (pins.length > 0) session.problem.value = exchange.pinsDropped(OTHER[from], pins.length);
  };
  return (
    <Menu
      kind="exchange"
      name={exchange.name}
      label={
        <svg viewBox="0 0 20 16" aria-hidden="true">
          <path d="M3 5h13M12.5 1.5 16 5l-3.5 3.5M17 11H4M7.5 7.5 4 11l3.5 3.5" />
        </svg>
      }
    >
      <li>
        <button type="button" disabled={isEmpty.value.reference && isEmpty.value.template} onClick={swap}>
          {exchange.swap}
        </button>
      </li>
      {(["reference", "template"] as const).map((from) => (
        <li key={from}>
          <button type="button" disabled={isEmpty.value[from]} onClick={() => copy(from)}>
            {exchange.copy(from)}
          </button>
        </li>
      ))}
    </Menu>
  );
}
