// SPDX-License-Identifier: Apache-2.0
import { effect, signal } from '@preact/signals';
import type { Language } from '../api/types';
import { language } from '../settings';

/** English. Where one text has two meanings, a second word tells which this is. */
type Row = string | readonly [english: string, meaning: string];
type Values = Record<string, string | number>;

/** Other languages are a file of pairs each, which language_pairs.mjs takes from those of the program. */
type Pairs = typeof import('./de.json');
const files: Record<Exclude<Language, 'en'>, () => Promise<{ default: Pairs }>> = {
  de: () => import('./de.json'),
  fr: () => import('./fr.json'),
};

/** What a row is found by: the English text, in square brackets the meaning where it has one. */
type Key<R extends Row> = R extends readonly [infer English extends string, infer Meaning extends string] ? `${English} [${Meaning}]` : R;
/** The rows, or for one without a pair its key, so that the type checker refuses it and names what is missing. */
type Translated<Rows extends Record<string, Row>> = {
  [K in keyof Rows]: [Exclude<Key<Rows[K]>, keyof Pairs>] extends [never] ? Rows[K] : { without_a_pair: Key<Rows[K]> };
};

/** A translator writes plain spaces; before these marks and within guillemets French does not break a line. */
const unbroken = (text: string): string => text.replace(/ (?=[:;?!%»])/g, '\u00a0').replace(/« /g, '«\u00a0');

/** The texts that are shown: those of the language once they have come, until then those before. */
const shown = signal<{ language: Language; texts: ReadonlyMap<string, string> }>({ language: 'en', texts: new Map() });
async function come(wanted: Language): Promise<void> {
  const pairs: Readonly<Record<string, string>> = wanted === 'en' ? {} : (await files[wanted]()).default;
  const texts = new Map(Object.entries(pairs).map(([english, other]) => [english, wanted === 'fr' ? unbroken(other) : other]));
  if (language.peek() === wanted) shown.value = { language: wanted, texts };
}
let coming: Promise<void> = Promise.resolve();
effect(() => {
  coming = come(language.value).catch(() => undefined);
});

/** When the language that this browser was left in can be read. */
export const language_known = (): Promise<void> => coming;

function text_of(row: Row): string {
  const [english, meaning] = typeof row === 'string' ? [row] : row;
  return shown.value.texts.get(meaning === undefined ? english : `${english} [${meaning}]`) ?? english;
}

/** French counts nothing as one thing: "0 essai". */
const is_one = (value: string | number): boolean => String(value) === '1' || (shown.value.language === 'fr' && String(value) === '0');

/**
 * The texts of one page; {name} is replaced by a value, {name|test|tests} by the first word where that value is one and
 * else by the second. Reading one while a component is drawn makes it follow the language.
 */
export function texts<const Rows extends Record<string, Row>>(rows: Rows & Translated<Rows>): (key: keyof Rows, values?: Values) => string {
  return (key, values = {}) => {
    const text = text_of(rows[key]);
    return text.replace(/\{(\w+)(?:\|([^|}]*)\|([^}]*))?\}/g, (place, name: string, one?: string, many?: string) => {
      const value = values[name];
      if (value === undefined) return place;
      return one === undefined ? String(value) : String(is_one(value) ? one : many);
    });
  };
}
