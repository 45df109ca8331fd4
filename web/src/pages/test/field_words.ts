// SPDX-License-Identifier: Apache-2.0
// Values of metadata in words, with their units.
import type { Evaluated, Field, Vocabulary } from '../../api/types';
import { all_methods, method_title, method_word } from '../../components/uncertainty';
import { texts } from '../../i18n/texts';
import { count } from '../../numbers';
import { field_unit, is_recording, numbers_in, stated_text, typed_text } from './field_value';

const t = texts({
  not_given: 'not given',
  yes: 'yes',
  no: 'no',
  linear: 'linear',
  quadratic: 'root of the squares',
  unknown: 'unknown: whatever the readings allow',
  white: 'white: from reading to reading',
  drift: 'drift: slowly',
  'random-walk': 'random walk: in steps that add up',
  recorded: '{n} numbers',
  rotary: 'rotary',
  'this-test': 'this test',
  'this-machine': 'this machine',
});

const own_words = ['yes', 'no', 'linear', 'rotary', 'this-test', 'this-machine', 'quadratic', 'unknown', 'white', 'drift', 'random-walk'] as const;

/** A choice in words: cycles and rules have titles in the vocabulary. */
function choice_title(vocabulary: Vocabulary, choice: string): string {
  const own = own_words.find((word) => word === choice);
  if (own !== undefined) return t(own);
  const method = all_methods.find((one) => method_word(one) === choice);
  if (method !== undefined) return method_title(method);
  return [...vocabulary.cycles, ...vocabulary.rules].find((one) => one.id === choice)?.title ?? choice;
}

/** A value that a change or a file states, as people read it. */
export function value_words(field: Field, text: string, vocabulary: Vocabulary): string {
  if (field.type === 'choice' || field.type === 'boolean') return choice_title(vocabulary, text);
  return is_recording(field, text) ? t('recorded', { n: count(numbers_in(text)) }) : typed_text(field, text);
}

/** "3.4 µm/m"; "not given" where there is nothing. */
export function value_with_unit(field: Field, text: string, vocabulary: Vocabulary, kind: 'linear' | 'rotary'): string {
  if (text === '') return t('not_given');
  return [value_words(field, text, vocabulary), field_unit(field, kind)].filter((part) => part !== '').join('\u00a0');
}

/** What holds of a field that no change names: what the file states, else what the archive lends. */
export function unchanged_text(field: Field, stated: Record<string, unknown>, { from_archive }: Evaluated): string {
  const own = stated_text(field, stated);
  if (own !== '') return own;
  const lent = from_archive?.instruments.find((one) => one.inputs[field.key] !== undefined)?.inputs[field.key];
  const limit = from_archive?.axis?.limits.find((one) => field.key === `tolerance.${one.parameter}`);
  return lent ?? (limit ? String(limit.value) : '');
}
