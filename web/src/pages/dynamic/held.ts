// SPDX-License-Identifier: Apache-2.0
import { signal } from '@preact/signals';

/** A recording that was dropped where tests are expected, on its way to the page of motion. */
export const held_recording = signal<File | null>(null);

/** Whether a test was refused because it is such a recording: its message names the verb, in every language. */
export const is_recording = (message: string): boolean => / \S?axiometry dynamic\b/.test(message);
