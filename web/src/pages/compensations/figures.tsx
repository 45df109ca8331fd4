// SPDX-License-Identifier: Apache-2.0
import type { CompensationKnown, CompensationResult, Parameter, ParameterNumbers, Shown, Test } from '../../api/types';
import { Aligned, most_decimals } from '../../components/aligned';
import { sentence } from '../../components/findings';
import { Formula } from '../../components/formula';
import { ParameterSymbol } from '../../components/symbol';
import { DataTable, type Column } from '../../components/table';
import { VerdictMark } from '../../components/verdict';
import { absent, decimals_for, decimals_of, fixed, unit_sign } from '../../numbers';
import { limit_words, plain_symbol } from '../test/figures_text';
import { LimitBar } from '../test/limit_bar';
import { shown_parameters } from './result';
import { t } from './texts';

/** As on the page of the test; where that has no such figure, two digits of its A or E, but one decimal at least. */
export function decimals_in(values: ParameterNumbers, parameter: Parameter, shown: readonly Shown[]): number {
  const row = shown.find((one) => one.parameter === parameter);
  if (row && /\d/.test(row.value)) return decimals_of(row.value);
  const size = values.A ?? values.A_up ?? values.A_down ?? values.E ?? values.E_up ?? values.E_down ?? 0;
  return size > 0 ? Math.min(Math.max(decimals_for(size, 2), 1), 6) : 1;
}

interface Row { parameter: Parameter; decimals: number; limit: Shown | null }

/** Figures before, predicted and measured again beside each other. A verdict stands only at what was measured. */
export function FigureTable({ result, test, retest = null }: { result: CompensationResult; test: Test | null; retest?: Test | null }) {
  const shown = test?.shown ?? [];
  const rows: Row[] = shown_parameters(result.before).map((parameter) => ({
    parameter, decimals: decimals_in(result.before, parameter, shown), limit: shown.find((row) => row.parameter === parameter && row.limit !== null) ?? null,
  }));
  const most = most_decimals(rows.map(({ decimals }) => fixed(0, decimals)));
  const number = ({ decimals }: Row, value: number | null | undefined) =>
    (typeof value === 'number' ? <Aligned text={fixed(value, decimals)} decimals={most} /> : absent);
  const of = (key: string, head: string, values: ParameterNumbers | undefined, look = ''): Column<Row>[] =>
    (values ? [{ key, head, number: true, class: look, cell: (row) => number(row, values[row.parameter]) }] : []);
  const mark = (row: Row, from: Test | null) => {
    const judged = from?.shown.find((one) => one.parameter === row.parameter);
    return judged && judged.limit !== null ? <VerdictMark verdict={judged.verdict} short /> : null;
  };
  const measured = (key: string, head: string, values: ParameterNumbers, from: Test | null): Column<Row> =>
    ({ key, head, number: true, cell: (row) => <span class="judged">{mark(row, from)} {number(row, values[row.parameter])}</span> });
  const limited = rows.some(({ limit }) => limit !== null);
  const expected = result.expected_retest;
  return (
    <>
      <DataTable<Row> caption={t('figures')} rows={rows} row_key={({ parameter }) => parameter} columns={[
        { key: 'parameter', head: <span class="visually-hidden">{t('parameter')}</span>, row_head: true, cell: ({ parameter }) => <ParameterSymbol parameter={parameter} /> },
        measured('before', t('before'), result.before, test),
        ...of('predicted', t('predicted'), result.predicted),
        ...of('percent_95', t('percent_95'), expected?.percent_95),
        ...(result.retest ? [measured('retest', t('retest'), result.retest.parameters, retest)] : []),
        ...of('scatter', t('scatter'), result.scatter, 'wide-only'),
        ...(limited ? [
          { key: 'limit', head: t('limit'), cell: ({ limit }: Row) => (limit?.limit == null ? '' : <span class="number">{limit_words(limit.limit, limit.source)}</span>) },
          { key: 'bar', head: <span class="visually-hidden">{t('against')}</span>, class: 'bar-cell', cell: (row: Row) => <Bar row={row} result={result} /> },
        ] : []),
      ]} />
      <p class="small quiet foot">{foot_text(result, shown)}</p>
      <KnownNotes notes={result.known_to_within?.notes ?? []} />
    </>
  );
}

/** Predicted, up to what 95 % of re-tests show less than; measured again, where that is there. */
function Bar({ row: { parameter, limit }, result }: { row: Row; result: CompensationResult }) {
  const again = result.retest?.parameters[parameter];
  const value = again ?? result.predicted[parameter];
  const most = again == null ? result.expected_retest?.percent_95[parameter] : null;
  if (limit === null || typeof value !== 'number') return null;
  return <LimitBar value={value} low={typeof most === 'number' ? value : null} high={most ?? null} limit={limit.limit} tone="none" />;
}

/** As the report says it: nothing of the places between where nothing is known of the targets. */
function known_text({ at_targets, anywhere, zero }: CompensationKnown, unit: string): string[] {
  if (at_targets === null) return [t('known_not')];
  return [
    t('known_at', { at: fixed(at_targets, 2), zero: fixed(zero, 2), unit }),
    anywhere === null ? t('known_not_between') : t('known_anywhere', { anywhere: fixed(anywhere, 2), unit }),
  ];
}

/** What of it does not count, was assumed, or is not known. */
function KnownNotes({ notes }: { notes: readonly string[] }) {
  if (notes.length === 0) return null;
  return (
    <div class="small quiet foot">
      <p>{t('known_notes')}:</p>
      <ul>{notes.map((note) => <li key={note}><Formula text={sentence(note)} /></li>)}</ul>
    </div>
  );
}

function foot_text(result: CompensationResult, shown: readonly Shown[]): string {
  const parts = [t('units', { unit: unit_sign(result.unit) }), t('predicted_how')];
  if (result.expected_retest) parts.push(t('percent_95_how', { n: result.expected_retest.trials }));
  if (result.known_to_within) parts.push(...known_text(result.known_to_within, unit_sign(result.unit)));
  parts.push(t('scatter_how'));
  const E = shown_parameters(result.before).find((parameter) => parameter.startsWith('E'));
  const [fitted, interpolated] = E === undefined ? [] : [result.least_squares[E], result.interpolated[E]];
  if (E !== undefined && typeof fitted === 'number' && typeof interpolated === 'number') {
    const decimals = decimals_in(result.before, E, shown) + 1;
    parts.push(t('methods', { symbol: plain_symbol(E), fitted: fixed(fitted, decimals), interpolated: fixed(interpolated, decimals), unit: unit_sign(result.unit) }));
  }
  if (result.smoothing !== null) parts.push(t('smoothed'));
  return parts.join(' ');
}

