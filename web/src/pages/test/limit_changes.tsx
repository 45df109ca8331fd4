// SPDX-License-Identifier: Apache-2.0
// Before a version is saved: what becomes of the limits, and which verdicts turn.
import type { Evaluated, LimitSource, Shown } from '../../api/types';
import { ParameterSymbol } from '../../components/symbol';
import { method_title } from '../../components/uncertainty';
import { VerdictMark } from '../../components/verdict';
import { texts } from '../../i18n/texts';
import { limit_words, plain_symbol, shown_of, uncertainty_words } from './figures_text';
import { record_method } from './record_choice';

const t = texts({
  title: 'Limits and verdicts',
  none: 'No limit changes, and no verdict turns.',
  added: 'a limit of {now}, where there was none',
  replaces: '{now} takes the place of {was}',
  restated: '{now}, as {was} says too',
  back: '{was} is dropped; {now} holds again',
  dropped: '{was} is dropped; no limit is left',
  unchanged: 'Limits that stay: {list}',
  record: 'Uncertainty of record: {was} → {now}',
  no_record: ['none', 'nothing'],
  becomes: 'becomes',
  together: 'All together',
});

/** Who gives way to whom, the first to all others. */
const ranks: readonly LimitSource[] = ['axis', 'table', 'test', 'entered', 'user'];
const rank = (row: Shown): number => (row.source === null ? -1 : ranks.indexOf(row.source));

/** What becomes of the limit of one parameter; null where it stays. */
function limit_change(was: Shown, now: Shown): string | null {
  if (was.limit === now.limit && was.source === now.source) return null;
  const words = {
    was: was.limit === null ? '' : `${limit_words(was.limit, was.source)}`,
    now: now.limit === null ? '' : `${limit_words(now.limit, now.source)}`,
  };
  if (was.limit === null) return t('added', words);
  if (now.limit === null) return t('dropped', words);
  if (rank(now) < rank(was)) return t('back', words);
  return t(now.limit === was.limit ? 'restated' : 'replaces', words);
}

const figure = (row: Shown): string => [row.value, uncertainty_words(row)].filter((part) => part !== '').join(' ');

export function LimitChanges({ before, after }: { before: Evaluated; after: Evaluated }) {
  const pairs = after.shown.flatMap((now) => {
    const was = shown_of(before, now.parameter);
    return was ? [{ was, now, change: limit_change(was, now), turns: was.verdict !== now.verdict }] : [];
  });
  const changed = pairs.filter(({ change, turns }) => change !== null || turns);
  const stay = pairs.filter(({ now, change }) => now.limit !== null && change === null);
  const methods = [record_method(before), record_method(after)].map((method) => (method === null ? t('no_record') : method_title(method)));
  const whole = before.verdict !== after.verdict;
  return (
    <section class="limit-changes" aria-label={t('title')}>
      <h3>{t('title')}</h3>
      {methods[0] !== methods[1] && <p>{t('record', { was: methods[0] as string, now: methods[1] as string })}</p>}
      {changed.length === 0 && !whole && <p class="quiet">{t('none')}</p>}
      {(changed.length > 0 || whole) && (
        <ul>
          {changed.map(({ was, now, change, turns }) => (
            <li key={now.parameter}>
              <ParameterSymbol parameter={now.parameter} /> <span class="number quiet">{figure(now)} {now.unit}</span>{': '}
              {change}{change !== null && turns && '; '}
              {turns && <Turn was={was.verdict} now={now.verdict} />}
            </li>
          ))}
          {whole && <li><strong>{t('together')}</strong>{': '}<Turn was={before.verdict} now={after.verdict} /></li>}
        </ul>
      )}
      {changed.some(({ change }) => change !== null) && stay.length > 0 && (
        <p class="small quiet">{t('unchanged', { list: stay.map(({ now }) => `${plain_symbol(now.parameter)} ${limit_words(now.limit as number, now.source)}`).join(', ') })}</p>
      )}
    </section>
  );
}

function Turn({ was, now }: { was: Evaluated['verdict']; now: Evaluated['verdict'] }) {
  return (
    <span class="turn"><VerdictMark verdict={was} /> <span aria-hidden="true">→</span><span class="visually-hidden"> {t('becomes')} </span> <VerdictMark verdict={now} /></span>
  );
}
