// SPDX-License-Identifier: Apache-2.0
import { signal } from '@preact/signals';

/** Files that were dropped where tests are expected, on their way to the page of straightness and angles. */
export const held_motions = signal<readonly File[]>([]);

/** Whether a test was refused because it is such a table: its message names the verb, in every language. */
export const is_motion = (message: string): boolean => / axiometry (straightness|angles)\b/.test(message);
