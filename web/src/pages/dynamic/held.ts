// SPDX-License-Identifier: Apache-2.0
import { signal } from '@preact/signals';

/** A recording that was dropped where tests are expected, on its way to the page of motion. */
export const held_recording = signal<File | null>(null);
