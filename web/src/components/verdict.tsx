// SPDX-License-Identifier: Apache-2.0
import type { Verdict } from '../api/types';
import { texts } from '../i18n/texts';

const t = texts({
  conforms: 'conforms',
  does_not: 'does not conform',
  undecided: 'undecided',
  none: 'no tolerance',
});

const shapes = {
  good: 'M2.5 7.5l3 3 6-7',
  bad: 'M3 3l8 8M11 3l-8 8',
  caution: 'M2.5 7h9',
  none: 'M4 7a3 3 0 1 0 6 0a3 3 0 1 0-6 0',
};

export type Tone = keyof typeof shapes;

/** A word with the sign of its tone; the word stays readable for all, also where only the sign is shown. */
export function Mark({ tone, word, short = false }: { tone: Tone; word: string; short?: boolean }) {
  return (
    <span class={`mark ${tone} ${short ? 'short' : ''}`} title={short ? word : undefined}>
      <svg width="14" height="14" viewBox="0 0 14 14" aria-hidden="true">
        <path d={shapes[tone]} fill="none" stroke="currentColor" stroke-width={tone === 'none' ? 1.25 : 2} stroke-linecap="round" />
      </svg>
      <span class={short ? 'visually-hidden' : ''}>{word}</span>
    </span>
  );
}

const tones = { conforms: 'good', 'does not conform': 'bad', undecided: 'caution' } as const;
const words = { conforms: 'conforms', 'does not conform': 'does_not', undecided: 'undecided' } as const;

export function VerdictMark({ verdict, short = false }: { verdict: Verdict | null; short?: boolean }) {
  return <Mark tone={verdict === null ? 'none' : tones[verdict]} word={t(verdict === null ? 'none' : words[verdict])} short={short} />;
}
