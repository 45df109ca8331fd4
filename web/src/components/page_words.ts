// SPDX-License-Identifier: Apache-2.0
// Sentences of the program on a page: what the command line calls by a flag is there called as the field for it.
import { useEffect } from 'preact/hooks';
import { texts } from '../i18n/texts';

const t = texts({ quoted: '“{text}”' });

/** The label of a field, as a sentence names it. */
export const field_named = (label: string): string => t('quoted', { text: label });

type Words = (text: string) => string;
type LabelOf = (flag: string) => string | undefined;

/** Flags in brackets, "(--zero, --datum)", without those for which the page has no field: the sentence stands without them. */
const without_others = (text: string, label_of: LabelOf): string =>
  text.replace(/ \((--[a-z-]+(?:, --[a-z-]+)*)\)/g, (_, list: string) => {
    const own = list.split(', ').filter((flag) => label_of(flag.slice(2)) !== undefined);
    return own.length === 0 ? '' : ` (${own.join(', ')})`;
  });

/** Of flags by the labels of their fields, or of a flag with its word, as "stops position", by that of a choice; others stay as they are. */
export const words_by = (label_of: LabelOf): Words => (text) =>
  without_others(text, label_of).replace(/--([a-z]+(?:-[a-z]+)*)(?: ([a-z]+(?:-[a-z]+)*)\b)?/g, (all, flag: string, word?: string) => {
    const choice = word === undefined ? undefined : label_of(`${flag} ${word}`);
    if (choice !== undefined) return field_named(choice);
    const label = label_of(flag);
    return label === undefined ? all : `${field_named(label)}${word === undefined ? '' : ` ${word}`}`;
  });

const as_told: Words = words_by(() => undefined);
let spoken: Words = as_told;

/** As the page that is shown speaks. */
export const page_words: Words = (text) => spoken(text);

/** Has all that a page shows speak so, for as long as the page is shown. Called before anything of it is drawn. */
export function use_page_words(words: Words): void {
  spoken = words;
  useEffect(() => () => { if (spoken === words) spoken = as_told; }, [words]);
}
