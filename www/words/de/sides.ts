/** Die beiden Formen in ihren Fällen. */

import type { Side } from "../sides";

type Cases = Readonly<Record<Side, string>>;

export const DER: Cases = { reference: "die Referenz", template: "das Ziel" };
export const DES: Cases = { reference: "der Referenz", template: "des Ziels" };
export const DEM: Cases = { reference: "der Referenz", template: "dem Ziel" };

export function capital(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}
