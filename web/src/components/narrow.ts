// SPDX-License-Identifier: Apache-2.0
import { signal } from '@preact/signals';

const asked = matchMedia('(max-width: 640px)');

/** Whether the page is as narrow as on a phone: the same edge as in the styles. */
export const narrow = signal(asked.matches);
asked.addEventListener('change', () => { narrow.value = asked.matches; });
