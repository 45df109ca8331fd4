// SPDX-License-Identifier: Apache-2.0
// The languages of the program, as the description of its API lists them; the type checker refuses one without a name.
import type { Language } from '../api/types';

/** As the readers of each call it. */
export const own_names: Readonly<Record<Language, string>> = { en: 'English', de: 'Deutsch', fr: 'Français' };

export const languages = Object.keys(own_names) as Language[];
export const language_choices = Object.entries(own_names) as [Language, string][];

/** "fr-CH" is French; English for what the program does not speak. */
export function language_of(tag: string): Language {
  const primary = tag.toLowerCase().split('-')[0];
  return languages.find((one) => one === primary) ?? 'en';
}
