// SPDX-License-Identifier: Apache-2.0
import { language } from '../settings';

type Row = readonly [english: string, german: string];
type Values = Record<string, string | number>;

/**
 * The texts of one page, English and German side by side; {name} is replaced by a value, {name|test|tests} by the first
 * word where that value is 1 and else by the second. Reading one while a component is drawn makes it follow the language.
 */
export function texts<Rows extends Record<string, Row>>(rows: Rows): (key: keyof Rows, values?: Values) => string {
  return (key, values = {}) => {
    const row = rows[key] as Row;
    const text = row[language.value === 'de' ? 1 : 0];
    return text.replace(/\{(\w+)(?:\|([^|}]*)\|([^}]*))?\}/g, (place, name: string, one?: string, many?: string) => {
      if (!(name in values)) return place;
      return one === undefined ? String(values[name]) : String(String(values[name]) === '1' ? one : many);
    });
  };
}
