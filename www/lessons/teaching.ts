/** Whether what is for the teacher is shown. */

import { signal } from "@preact/signals";

export const teaching = signal(false);
