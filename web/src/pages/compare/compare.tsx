// SPDX-License-Identifier: Apache-2.0
// Up to eight tests over each other: before and after compensation, this year and last year.
import { useMemo, useState } from 'preact/hooks';
import { use_get } from '../../api/use';
import type { Test, Vocabulary } from '../../api/types';
import { Chart, Swatch, type ChartPlace } from '../../components/chart/chart';
import { FailureNotice } from '../../components/failure';
import { narrow } from '../../components/narrow';
import { test_date } from '../../components/test_date';
import { VerdictMark } from '../../components/verdict';
import { Withdrawn } from '../../components/withdrawn';
import { keep_focus } from '../../focus';
import { texts } from '../../i18n/texts';
import { fixed, position_unit, shortest, unit_sign } from '../../numbers';
import { go, place } from '../../router';
import { decimal, language } from '../../settings';
import { common_stretch, curves, interpolated, look_of, type Curve, type Curves, type Datum } from './curves';
import { Picker } from './picker';
import { SideBySide } from './side_by_side';
import { use_tests } from './use_tests';
import './compare.css';
import '../test/test.css';
import { colon, semicolon } from '../../i18n/colon';

const t = texts({
  title: 'Compare tests',
  chart: 'Mean deviations',
  name: 'Mean deviations of the compared tests over position',
  curve: 'Curve',
  mean: 'x̄', up: 'x̄↑', down: 'x̄↓', both: 'x̄↑ and x̄↓',
  datum: 'Zero',
  own: 'as measured',
  start: 'where all begin',
  middle: 'mean over the common travel',
  tests: 'Compared tests',
  remove: 'Remove {title}',
  reference: 'Make it the reference',
  reference_of: 'Make it the reference: {title}',
  is_reference: 'reference',
  show: 'Show {title}',
  empty: 'Choose tests to lay over each other: before and after a compensation, this year and last year.',
  other_unit: '{title} has deviations in {unit} and is not in the chart.',
  left_out: 'At most {n} tests are compared; not shown: {list}.',
  between: '≈: between the targets of that test',
  apart: 'These tests have no stretch of the axis in common: their curves stand as measured.',
});

const list_of = (text: string | null): number[] =>
  [...new Set((text ?? '').split(',').filter((word) => /^\d{1,15}$/.test(word.trim())).map(Number))];

const most_compared = 8;

interface Choice { tests: readonly number[]; left_out: readonly number[]; curve: Curve; datum: Datum }

function chosen(query: URLSearchParams): Choice {
  const one = <T extends string>(key: string, allowed: readonly T[]): T => allowed.find((word) => word === query.get(key)) ?? (allowed[0] as T);
  const asked = list_of(query.get('tests'));
  return { tests: asked.slice(0, most_compared), left_out: asked.slice(most_compared), curve: one('curve', ['mean', 'up', 'down', 'both']), datum: one('datum', ['own', 'start', 'middle']) };
}

/** The address says all, so that a comparison can be sent to somebody. */
function put(choice: Omit<Choice, 'left_out'>): void {
  const rest = `${choice.curve === 'mean' ? '' : `&curve=${choice.curve}`}${choice.datum === 'own' ? '' : `&datum=${choice.datum}`}`;
  go(`/compare?tests=${choice.tests.join(',')}${rest}`, 'replace');
  keep_focus();
}

export function ComparePage() {
  const choice = chosen(place.value.query);
  const loaded = use_tests(choice.tests);
  const vocabulary = use_get<Vocabulary>('/api/vocabulary').data;
  const [hidden, set_hidden] = useState<ReadonlySet<number>>(new Set<number>());
  const tests = loaded.flatMap(({ test }) => (test ? [test] : []));
  const first = tests[0] ?? null;
  const alike = tests.filter((test) => test.result.unit === first?.result.unit);
  const others = tests.filter((test) => !alike.includes(test));
  const remove = (id: number) => put({ ...choice, tests: choice.tests.filter((one) => one !== id) });
  const toggle = (id: number) => {
    const next = new Set(hidden);
    if (!next.delete(id)) next.add(id);
    set_hidden(next);
  };
  return (
    <>
      <h1 tabIndex={-1}>{t('title')}</h1>
      {loaded.filter(({ error }) => error !== null).map(({ id, error }) => error && <FailureNotice key={id} error={error} />)}
      {choice.tests.length === 0 && <p class="quiet">{t('empty')}</p>}
      {choice.left_out.length > 0 && <p class="notice caution">{t('left_out', { n: most_compared, list: choice.left_out.join(', ') })}</p>}
      <div class={`compare ${tests.length === 0 ? 'empty' : ''}`}>
        {tests.length > 0 && (
          <div class="stack curves">
            <Overlay tests={alike} choice={choice} hidden={hidden} />
            {others.map((test) => <p key={test.id} class="notice caution">{t('other_unit', { title: test.title, unit: unit_sign(test.result.unit) })}</p>)}
          </div>
        )}
        {tests.length > 0 && (
          <section class="panel chosen">
            <header><h2>{t('tests')}</h2></header>
            <ol>
              {[...alike, ...others].map((test, n) => (
                <Chosen key={test.id} test={test} n={n} shown={!hidden.has(test.id)} toggle={() => toggle(test.id)} remove={() => remove(test.id)}
                        refer={() => put({ ...choice, tests: [test.id, ...choice.tests.filter((id) => id !== test.id)] })} />
              ))}
            </ol>
          </section>
        )}
        {tests.length > 0 && <SideBySide tests={[...alike, ...others]} vocabulary={vocabulary} />}
        <Picker chosen={choice.tests} first={first} add={(id) => put({ ...choice, tests: [...choice.tests, id] })} />
      </div>
    </>
  );
}

function Chosen({ test, n, shown, toggle, remove, refer }: {
  test: Test; n: number; shown: boolean; toggle: () => void; remove: () => void; refer: () => void;
}) {
  const { title } = test;
  const date = test.result.metadata.test?.date;
  const facts = [test.machine?.name, test.axis?.name, date && test_date(test)].filter((part): part is string => typeof part === 'string' && part !== '');
  return (
    <li>
      <label class="show" title={t('show', { title })}>
        <input type="checkbox" checked={shown} onChange={toggle} aria-label={t('show', { title })} /><Swatch series={look_of(n)} />
      </label>
      <div>
        <a href={`/tests/${test.id}`}>{title}</a> {test.verdict !== null && <VerdictMark verdict={test.verdict} short />}
        {' '}<Withdrawn test={test} />{' '}
        {n === 0 ? <span class="small is-reference">{t('is_reference')}</span>
          : <button type="button" class="link small no-print" aria-label={t('reference_of', { title })} onClick={refer}>{t('reference')}</button>}
        <div class="small quiet">{facts.map((fact, i) => <span key={i}>{i > 0 && ' · '}<span class="fact">{fact}</span></span>)}</div>
      </div>
      <button type="button" class="plain small no-print" aria-label={t('remove', { title })} onClick={remove}>×</button>
    </li>
  );
}

/** More curves have more room, about as much as their names take beside them. */
const chart_height = (curves: number): number => (curves > 5 && !narrow.value ? 520 : 440);

function Overlay({ tests, choice, hidden }: { tests: readonly Test[]; choice: Choice; hidden: ReadonlySet<number> }) {
  const list = tests.map((test) => `${test.id}:${test.version}`).join();
  const model = useMemo(() => curves(tests, choice.curve, choice.datum, hidden), [list, choice.curve, choice.datum, hidden, language.value, decimal.value]);
  return (
    <section class="panel chart-panel">
      <header>
        <h2>{t('chart')}</h2>
        <div class="row no-print">
          <div class="segments" role="group" aria-label={t('curve')}>
            {(['mean', 'up', 'down', 'both'] as const).map((curve) => (
              <button key={curve} type="button" class="small" aria-pressed={choice.curve === curve} onClick={() => put({ ...choice, curve })}>{t(curve)}</button>
            ))}
          </div>
          <label class="small">{t('datum')}
            <select value={choice.datum} onChange={(event) => put({ ...choice, datum: event.currentTarget.value as Datum })}>
              {(['own', 'start', 'middle'] as const).map((datum) => <option key={datum} value={datum}>{t(datum)}</option>)}
            </select>
          </label>
        </div>
      </header>
      {choice.datum !== 'own' && common_stretch(tests) === null && <p class="notice caution">{t('apart')}</p>}
      <Chart {...model} name={t('name')} height={chart_height(tests.length)} tip={(at) => <Tip model={model} tests={tests} at={at} />} spoken={(at) => spoken(model, tests, at)} />
    </section>
  );
}

/** At one position: of every visible curve its value, or what lies between two of its targets. */
function values_at(model: Curves, at: ChartPlace) {
  const x = model.x[at.index] ?? 0;
  return model.series.flatMap((series, i) => {
    const own = series.values[at.index];
    const exact = typeof own === 'number';
    const value = exact ? own : interpolated((model.of[i] as Curves['of'][number]).points, x);
    return series.hidden || value === null ? [] : [{ series, i, value, exact }];
  });
}

function Tip({ model, tests, at }: { model: Curves; tests: readonly Test[]; at: ChartPlace }) {
  const kind = tests[0]?.result.axis.kind ?? 'linear';
  const unit = unit_sign(tests[0]?.result.unit ?? 'um');
  const rows = values_at(model, at);
  return (
    <>
      <div class="head">{shortest(model.x[at.index])} {position_unit(kind)}</div>
      <table><tbody>
        {rows.map(({ series, i, value, exact }) => (
          <tr key={series.key} class={i === at.series ? 'strong' : ''}>
            <td><Swatch series={series} /> {series.label}</td><td class="number">{exact ? '' : '≈ '}{fixed(value, 2)} {unit}</td>
          </tr>
        ))}
      </tbody></table>
      {rows.some(({ exact }) => !exact) && <div class="quiet">{t('between')}</div>}
    </>
  );
}

function spoken(model: Curves, tests: readonly Test[], at: ChartPlace): string {
  const kind = tests[0]?.result.axis.kind ?? 'linear';
  const rows = values_at(model, at).filter(({ i }) => at.series === null || i === at.series);
  return `${shortest(model.x[at.index])} ${position_unit(kind)}${colon()} ${rows.map(({ series, value, exact }) => `${series.label} ${exact ? '' : '≈ '}${fixed(value, 2)}`).join(semicolon())}`;
}
