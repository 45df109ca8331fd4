// SPDX-License-Identifier: Apache-2.0
import type { Evaluated, MonteCarloOutput, Parameter, Verdict, Vocabulary } from '../../api/types';
import { Aligned, most_decimals } from '../../components/aligned';
import { ParameterSymbol } from '../../components/symbol';
import { VerdictMark } from '../../components/verdict';
import { texts } from '../../i18n/texts';
import { absent, decimals_of, fixed, parsed, shortest } from '../../numbers';
import { main_parameters, type Shown } from './figures_text';
import { LimitBar } from './limit_bar';
import type { TestState } from './state';

const t = texts({
  glance: ['At a glance', 'Auf einen Blick'],
  annex_a: ['Annex A', 'Anhang A'],
  title: ['Parameters', 'Kennwerte'],
  parameter: ['Parameter', 'Kennwert'],
  name: ['Name', 'Benennung'],
  value: ['Value', 'Wert'],
  limit: ['Limit', 'Grenzwert'],
  against: ['Value against limit', 'Wert und Grenzwert'],
  verdict: ['Verdict', 'Entscheidung'],
  kept: ['kept', 'gespeichert'],
  of_limit: ['limit {limit}', 'Grenzwert {limit}'],
  A: ['positioning error', 'Positioniergenauigkeit'],
  E: ['systematic error', 'syst. Abweichung'],
  R: ['repeatability', 'Wiederholpräzision'],
  B: ['reversal error', 'Umkehrspanne'],
  M: ['mean error', 'mittlere Abweichung'],
  no_uncertainty: ['no uncertainty stated', 'ohne Angabe der Unsicherheit'],
  interval: ['Monte Carlo interval', 'Monte-Carlo-Intervall'],
  units: ['Values in {unit}.', 'Werte in {unit}.'],
  units_U: ['Values in {unit}. U: expanded uncertainty, about 95 %.', 'Werte in {unit}. U: erweiterte Unsicherheit, rund 95 %.'],
});

const tone_of = (verdict: Verdict | null) =>
  verdict === 'conforms' ? 'good' : verdict === 'does not conform' ? 'bad' : verdict === 'undecided' ? 'caution' : 'none';

const shown_of = (evaluated: Evaluated, parameter: Parameter): Shown | undefined =>
  evaluated.shown.find((row) => row.parameter === parameter);

/** The expanded uncertainty as it is shown, as a number for the bar. */
const number_of = (text: string): number | null => parsed(text);

function Stored({ now, kept }: { now: Shown; kept: Shown | undefined }) {
  if (kept === undefined || (kept.value === now.value && kept.U === now.U && kept.interval === now.interval)) return null;
  const text = kept.U === '' ? `${kept.value} ${kept.interval}` : `${kept.value} ± ${kept.U}`;
  return <span class="was small number">{t('kept')} {text}</span>;
}

type Letter = 'A' | 'E' | 'R' | 'B' | 'M';

/** The five figures that say how the axis is, large. */
export function Headline({ state, vocabulary }: { state: TestState; vocabulary: Vocabulary | null }) {
  const evaluated = state.evaluated.value;
  const kept = state.test.value;
  const main = main_parameters(evaluated.result);
  // Bars without a limit stand on one scale, so that they can be compared with each other.
  const reach = Math.max(...main.map((parameter) => Math.abs(evaluated.result.parameters[parameter] ?? 0) + (number_of(shown_of(evaluated, parameter)?.U ?? '') ?? 0)));
  return (
    <section class="panel headline" aria-label={t('glance')}>
      {main.map((parameter) => {
        const row = shown_of(evaluated, parameter);
        const value = evaluated.result.parameters[parameter];
        if (row === undefined || value === null) return null;
        return (
          <div key={parameter} class={`glance ${row.limit === null ? '' : tone_of(row.verdict)}`}>
            <div class="row spread">
              <span class="glance-symbol"><ParameterSymbol parameter={parameter} /></span>
              {row.limit !== null && <VerdictMark verdict={row.verdict} short />}
            </div>
            <div class="small quiet" title={vocabulary?.parameters.find((one) => one.key === parameter)?.title}>{t(parameter.charAt(0) as Letter)}</div>
            <div class="number figure">
              <span class="glance-value">{row.value}</span>{' '}
              <span>{row.U !== '' && <span class="glance-u">± {row.U}</span>} <span class="quiet">{row.unit}</span></span>
              {row.U === '' && row.interval !== '' && <span class="small"> ({row.interval})</span>}
            </div>
            <LimitBar value={value} U={number_of(row.U)} limit={row.limit} tone={tone_of(row.verdict)} reach={reach} />
            <div class="small quiet number">
              {row.limit !== null && t('of_limit', { limit: shortest(row.limit) })} <Stored now={row} kept={shown_of(kept, parameter)} />
            </div>
          </div>
        );
      })}
    </section>
  );
}

interface Methods { annex_a: boolean; gum: boolean; monte_carlo: boolean }

function methods_of(evaluated: Evaluated): Methods {
  const uncertainty = evaluated.result.uncertainty;
  return { annex_a: !!uncertainty?.annex_a, gum: !!uncertainty?.gum, monte_carlo: !!uncertainty?.monte_carlo };
}

function interval_text(output: MonteCarloOutput | null | undefined, decimals: number): string {
  return output ? `${fixed(output.symmetric[0], decimals)} … ${fixed(output.symmetric[1], decimals)}` : absent;
}

/** All twelve parameters, with the uncertainty by every method that was run. */
export function Parameters({ state, vocabulary }: { state: TestState; vocabulary: Vocabulary | null }) {
  const evaluated = state.evaluated.value;
  const kept = state.test.value;
  const methods = methods_of(evaluated);
  const decimals = most_decimals(evaluated.shown.map((row) => row.value));
  const limit_decimals = most_decimals(evaluated.shown.map((row) => shortest(row.limit)));
  const any_limit = evaluated.shown.some((row) => row.limit !== null);
  return (
    <section class="panel flush parameters-panel">
      <header><h2>{t('title')}</h2>{!methods.annex_a && !methods.gum && <span class="small quiet">{t('no_uncertainty')}</span>}</header>
      <div class="table-frame" tabIndex={0} role="region" aria-label={t('title')}>
        <table class={`parameters ${any_limit ? 'judged' : ''} ${methods.monte_carlo ? 'sampled' : ''}`}>
          <thead>
            <tr>
              <th scope="col"><span class="visually-hidden">{t('parameter')}</span></th>
              <th scope="col" class="name">{t('name')}</th>
              <th scope="col" class="number">{t('value')}</th>
              {methods.annex_a && <th scope="col" class="number">U <span class="method">{t('annex_a')}</span></th>}
              {methods.gum && <th scope="col" class="number">U <span class="method">GUM</span></th>}
              {methods.monte_carlo && <th scope="col" class="number">{t('interval')}</th>}
              {any_limit && <th scope="col" class="number">{t('limit')}</th>}
              {any_limit && <th scope="col"><span class="visually-hidden">{t('verdict')}</span></th>}
              {any_limit && <th scope="col" class="bar-cell"><span class="visually-hidden">{t('against')}</span></th>}
            </tr>
          </thead>
          <tbody>
            {evaluated.shown.map((row) => (
              <Row key={row.parameter} row={row} kept={shown_of(kept, row.parameter)} evaluated={evaluated} methods={methods}
                   column={decimals} limit_column={limit_decimals} any_limit={any_limit} title={vocabulary?.parameters.find((p) => p.key === row.parameter)?.title ?? ''} />
            ))}
          </tbody>
        </table>
      </div>
      <p class="small quiet foot">{t(methods.annex_a || methods.gum ? 'units_U' : 'units', { unit: evaluated.shown[0]?.unit ?? '' })}</p>
    </section>
  );
}

function Row({ row, kept, evaluated, methods, column, limit_column, any_limit, title }: {
  row: Shown; kept: Shown | undefined; evaluated: Evaluated; methods: Methods; any_limit: boolean; title: string;
  column: number; limit_column: number;   // decimals of what stands above and below
}) {
  const uncertainty = evaluated.result.uncertainty;
  const decimals = decimals_of(row.value);
  const value = evaluated.result.parameters[row.parameter];
  return (
    <tr class={main_parameters(evaluated.result).includes(row.parameter) ? 'main' : ''}>
      <th scope="row" title={title}><ParameterSymbol parameter={row.parameter} /></th>
      <td class="name">{title}</td>
      <td class="number"><Stored now={row} kept={kept} /> {value === null ? absent : <Aligned text={row.value} decimals={column} />}</td>
      {methods.annex_a && <td class="number"><Aligned text={fixed(uncertainty?.annex_a?.[row.parameter], decimals)} decimals={column} /></td>}
      {methods.gum && <td class="number"><Aligned text={fixed(uncertainty?.gum?.[row.parameter]?.U, decimals)} decimals={column} /></td>}
      {methods.monte_carlo && <td class="number">{interval_text(uncertainty?.monte_carlo?.[row.parameter], decimals)}</td>}
      {any_limit && <td class="number">{row.limit !== null && <Aligned text={shortest(row.limit)} decimals={limit_column} />}</td>}
      {any_limit && <td class="verdict-cell">{row.limit !== null && <VerdictMark verdict={row.verdict} short />}</td>}
      {any_limit && (
        <td class="bar-cell">
          {row.limit !== null && value !== null && <LimitBar value={value} U={number_of(row.U)} limit={row.limit} tone={tone_of(row.verdict)} />}
        </td>
      )}
    </tr>
  );
}
