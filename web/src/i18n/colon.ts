// SPDX-License-Identifier: Apache-2.0
// Marks between texts that a page joins itself.
import { language } from '../settings';

const space_before = (): string => (language.value === 'fr' ? '\u00a0' : '');

/** Behind a title: French has a space before it. */
export const colon = (): string => `${space_before()}:`;

/** Between the items of a list, likewise. */
export const semicolon = (): string => `${space_before()}; `;
