// SPDX-License-Identifier: Apache-2.0
import { Fragment } from 'preact';
import type { Method, Parameter, Test, Vocabulary } from '../../api/types';
import { Swatch } from '../../components/chart/chart';
import { Aligned, most_decimals } from '../../components/aligned';
import { narrow } from '../../components/narrow';
import { ParameterSymbol } from '../../components/symbol';
import { method_title, method_with_coverage } from '../../components/uncertainty';
import { VerdictMark } from '../../components/verdict';
import { texts } from '../../i18n/texts';
import { absent, decimals_of, fixed, unit_sign } from '../../numbers';
import { printing } from '../../settings';
import { all_parameters, main_parameters } from '../test/figures_text';
import { record_method } from '../test/record_choice';
import { look_of } from './curves';

const t = texts({
  title: 'Parameters side by side',
  parameter: 'Parameter',
  value: 'Value ± U',
  difference: 'Difference',
  first: 'reference',
  beyond: 'larger than the combined uncertainty',
  within: 'within the combined uncertainty',
  unknown: 'no uncertainty is stated',
  better: 'smaller',
  worse: 'larger',
  several: 'These tests state their uncertainties by different methods: {list}. Each is held against the other as its own method states it.',
  uncorrected: 'An effect that was neither corrected nor is in the uncertainty acts on {list}: what differs may be that effect, however it is marked.',
  other_travel: 'The targets of {list} do not span what those of the first test span: A, E and M of an axis grow with its travel.',
  incomplete: 'The uncertainty of {list} is incomplete and too small, since nothing was given of some of its contributors: differences held against it may be marked as larger than the combined uncertainty that are not.',
  no_method: 'no uncertainty',
  with_interval: 'Value, interval',
  value_only: 'Value',
  legend: 'Differences to the first test. Strong: larger than the combined uncertainty √(U₁² + U₂²), of intervals their half widths, with ▲ or ▼ where the parameter has no sign of its own. Quiet: within it. With a question mark: a test states no uncertainty. Errors that both tests have in common would make the true bound smaller; the scatter of the approaches, which only the uncertainty of this machine holds, would make it larger.',
});

const most_beside_on_paper = 3;  // tests whose differences stand in columns of their own
const longest_on_a_line = 18;  // letters of a title that is not broken

interface Cell { value: number; text: string; half_width: number | null; U: string; interval: string }

function cell_of(test: Test, parameter: Parameter): Cell | null {
  const shown = test.shown.find((row) => row.parameter === parameter);
  const value = test.result.parameters[parameter];
  if (!shown || value === null || value === undefined) return null;
  const { low, high } = shown;
  return { value, text: shown.value, half_width: low === null || high === null ? null : (high - low) / 2, U: shown.U, interval: shown.interval };
}

const head_of = (method: Method | null): string => t(method === null ? 'value_only' : method === 'monte_carlo' ? 'with_interval' : 'value');

/** From the first target to the last, mm or °. */
function span_of({ result: { positions } }: Test): number {
  const targets = positions.map(({ target }) => target);
  return Math.max(...targets) - Math.min(...targets);
}

/** The parameters of all tests, with differences to the first one and whether they mean anything. */
export function SideBySide({ tests, vocabulary }: { tests: readonly Test[]; vocabulary: Vocabulary | null }) {
  const present = all_parameters.filter((parameter) => tests.some((test) => cell_of(test, parameter) !== null));
  const reference = tests[0];
  if (!reference) return null;
  const decimals = most_decimals(tests.flatMap((test) => test.shown.map((row) => row.value)));
  const main = main_parameters(reference.result);
  const methods = tests.map((test) => record_method(test));
  const named = methods.map((method) => (method === null ? t('no_method') : method_title(method)));
  const with_coverage = tests.map((test, n) => (methods[n] ? method_with_coverage(test, methods[n]) : t('no_method')));
  const several = new Set(methods.filter((method) => method !== null)).size > 1;
  const incomplete = tests.filter((test) => test.result.findings.some((finding) => finding.id === 'uncertainty-stated') &&
    test.shown.some((row) => row.low !== null));
  const uncorrected = tests.filter(({ result }) => result.claims?.some(({ missing }) => missing.some(({ id }) => id === 'uncorrected-effect')));
  const other_travel = tests.filter((test) => Math.abs(span_of(test) - span_of(reference)) > 0.01 * span_of(reference));
  const stacked = narrow.value || (printing.value && tests.length > most_beside_on_paper);
  return (
    <section class={`panel flush parameters-table ${tests.length > 5 ? 'many' : ''}`}>
      <header><h2>{t('title')}</h2></header>
      <div class="table-frame" tabIndex={0} role="region" aria-label={t('title')}>
        <table class={`side-by-side ${stacked ? 'stacked' : ''}`}>
          <thead>
            <tr>
              <th scope="col" rowSpan={2}><span class={stacked ? 'visually-hidden' : ''}>{t('parameter')}</span></th>
              {tests.map((test, n) => (
                <th key={test.id} scope="colgroup" colSpan={n === 0 || stacked ? 1 : 2} class="test-name">
                  <span class={test.title.length <= longest_on_a_line ? 'one-line' : ''}><Swatch series={look_of(n)} /> {test.title}</span>
                  <span class="by-method quiet small">{with_coverage[n]}</span>
                </th>
              ))}
            </tr>
            <tr>
              {tests.map((test, n) => (
                <Fragment key={test.id}>
                  <th scope="col" class="number value">{head_of(methods[n] ?? null)},{stacked ? <br /> : ' '}{unit_sign(test.result.unit)}</th>
                  {n > 0 && !stacked && <th scope="col" class="number">{t('difference')}</th>}
                </Fragment>
              ))}
            </tr>
          </thead>
          <tbody>
            {present.map((parameter) => (
              <tr key={parameter} class={main.includes(parameter) ? 'main' : ''}>
                <th scope="row" title={vocabulary?.parameters.find((one) => one.key === parameter)?.title}><ParameterSymbol parameter={parameter} /></th>
                {tests.map((test, n) => (
                  <Fragment key={test.id}>
                    <td class="number value">
                      <Value test={test} parameter={parameter} decimals={decimals} stacked={stacked} />
                      {n > 0 && stacked && <div class="below"><Difference to={reference} test={test} parameter={parameter} column={decimals} /></div>}
                    </td>
                    {n > 0 && !stacked && <td class="number"><Difference to={reference} test={test} parameter={parameter} column={decimals} /></td>}
                  </Fragment>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      {several && <p class="small foot several">{t('several', { list: [...new Set(named)].join(', ') })}</p>}
      {tests.length > 1 && uncorrected.length > 0 && <p class="small foot uncorrected">{t('uncorrected', { list: uncorrected.map((test) => test.title).join(', ') })}</p>}
      {other_travel.length > 0 && <p class="small foot other-travel">{t('other_travel', { list: other_travel.map((test) => test.title).join(', ') })}</p>}
      {tests.length > 1 && incomplete.length > 0 && <p class="small foot incomplete">{t('incomplete', { list: incomplete.map((test) => test.title).join(', ') })}</p>}
      {tests.length > 1 && <p class="small quiet foot">{t('legend')}</p>}
    </section>
  );
}

function Value({ test, parameter, decimals, stacked }: { test: Test; parameter: Parameter; decimals: number; stacked: boolean }) {
  const cell = cell_of(test, parameter);
  const shown = test.shown.find((row) => row.parameter === parameter);
  if (cell === null) return <>{absent}</>;
  const uncertainty = cell.U !== '' ? <span class="quiet uncertainty"> ± <Aligned text={cell.U} decimals={decimals} /></span>
    : cell.interval !== '' && <span class="quiet uncertainty"> ({cell.interval})</span>;
  return (
    <>
      <Aligned text={cell.text} decimals={decimals} />
      {!stacked && uncertainty}
      <span class="slot">{shown && shown.limit !== null && <VerdictMark verdict={shown.verdict} short />}</span>
      {stacked && uncertainty}
    </>
  );
}

function Difference({ to, test, parameter, column }: { to: Test; test: Test; parameter: Parameter; column: number }) {
  const [a, b] = [cell_of(to, parameter), cell_of(test, parameter)];
  if (a === null || b === null || to.result.unit !== test.result.unit) return <>{absent}</>;
  // Only the mean reversal has a sign, which a mark for larger and smaller would contradict.
  // Rounded numbers are subtracted only on the screen: the difference is that of the exact values.
  const difference = b.value - a.value;
  const change = parameter === 'B_mean' ? null : difference < 0 ? { sign: '▼', word: t('better') } : { sign: '▲', word: t('worse') };
  const figure = `${difference > 0 ? '+' : ''}${fixed(difference, Math.min(decimals_of(a.text), decimals_of(b.text)))}`;
  const text = <Aligned text={figure} decimals={column} />;
  if (a.half_width === null || b.half_width === null) return <span class="unsure" title={t('unknown')}>{text}<span class="sign quiet">?<span class="visually-hidden"> {t('unknown')}</span></span></span>;
  const beyond = Math.abs(difference) > Math.hypot(a.half_width, b.half_width);
  if (!beyond) return <span class="quiet" title={t('within')}>{text}<span class="sign" /><span class="visually-hidden"> {t('within')}</span></span>;
  return (
    <strong title={`${change ? `${change.word}; ` : ''}${t('beyond')}`}>
      {text}<span class="sign" aria-hidden="true">{change?.sign}</span><span class="visually-hidden"> {t('beyond')}</span>
    </strong>
  );
}
