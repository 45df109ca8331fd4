// SPDX-License-Identifier: Apache-2.0
import { signal } from '@preact/signals';

/** Files that were dropped where tests are expected, on their way to the page of straightness and angles. */
export const held_motions = signal<readonly File[]>([]);
