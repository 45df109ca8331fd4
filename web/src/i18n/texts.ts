// SPDX-License-Identifier: Apache-2.0
import { effect, signal } from '@preact/signals';
import { language } from '../settings';

type FrenchPairs = typeof import('./fr.json');

/** German stands beside its English. Where one English text has two meanings, a third word tells which this is. */
type Row = readonly [english: string, german: string, meaning?: string];
type Values = Record<string, string | number>;

/** Other languages are a file of pairs each: English, in square brackets the meaning where a row has one, to the other. */
type Key<R extends Row> = R extends readonly [infer English extends string, string, infer Meaning extends string]
  ? `${English} [${Meaning}]` : R[0];
type Missing<R extends Row> = Exclude<Key<R>, keyof FrenchPairs>;
/** The rows, or for one without a pair its key, so that the type checker refuses it and names what is missing. */
type Translated<Rows extends Record<string, Row>> = {
  [K in keyof Rows]: [Missing<Rows[K]>] extends [never] ? Rows[K] : { missing_in_fr_json: Missing<Rows[K]> };
};

/** A translator writes plain spaces; before these marks and within guillemets French does not break a line. */
const unbroken = (text: string): string => text.replace(/ (?=[:;?!%»])/g, '\u00a0').replace(/« /g, '«\u00a0');

/** Comes when French is first chosen; English until then. */
const french = signal<ReadonlyMap<string, string> | null>(null);
const french_come = async (): Promise<void> => {
  const pairs = (await import('./fr.json')).default;
  french.value = new Map(Object.entries(pairs).map(([english, other]) => [english, unbroken(other)]));
};
let coming: Promise<void> = Promise.resolve();
effect(() => {
  if (language.value === 'fr' && french.peek() === null) coming = french_come().catch(() => undefined);
});

/** When the language that this browser was left in can be read. */
export const language_known = (): Promise<void> => coming;

function text_of(row: Row): string {
  if (language.value === 'fr') return french.value?.get(row[2] === undefined ? row[0] : `${row[0]} [${row[2]}]`) ?? row[0];
  return row[language.value === 'de' ? 1 : 0];
}

/** French counts nothing as one thing: "0 essai". */
const is_one = (value: string | number): boolean => String(value) === '1' || (language.value === 'fr' && String(value) === '0');

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
