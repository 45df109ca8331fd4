// SPDX-License-Identifier: Apache-2.0
import { signal } from '@preact/signals';

/** A file that was dropped where tests are expected, on its way to the page that looks at tables. */
export const held_table = signal<File | null>(null);
