// SPDX-License-Identifier: Apache-2.0
import type { ComparedFigure, ComparedRule, Parameter, RulesCompared } from '../../api/types';
import { sentence } from '../../components/findings';
import { Formula } from '../../components/formula';
import { ParameterSymbol } from '../../components/symbol';
import { absent, unit_sign } from '../../numbers';
import { all_parameters } from '../test/figures_text';
import { RuleSymbol } from './symbol';
import { t } from './texts';
import { colon } from '../../i18n/colon';

/** A row for each parameter that a chosen rule has something taken for, and one for what is taken for none. */
type Row = Parameter | null;

const figures_of = (rule: ComparedRule, row: Row): ComparedFigure[] => rule.figures.filter(({ beside }) => beside === row);

/** Of the parameter itself, as a figure beside it shows it. */
const standard_text = (rules: readonly ComparedRule[], row: Row): string =>
  rules.flatMap((rule) => figures_of(rule, row)).find(({ shown }) => shown.beside_value !== '')?.shown.beside_value ?? absent;

/** Null where every figure was read in the text of the rule. */
function unchecked_words({ figures }: ComparedRule): string | null {
  const unchecked = figures.filter(({ checked_against_text }) => !checked_against_text).length;
  return unchecked === 0 ? null : t(unchecked === figures.length ? 'unchecked' : 'partly_unchecked');
}

/** What the rules say of one axis, each column a rule, each row what its figures are taken for. */
export function SideBySide({ compared, rules }: { compared: RulesCompared; rules: readonly ComparedRule[] }) {
  const rows: Row[] = [...all_parameters, null].filter((row) => rules.some((rule) => figures_of(rule, row).length > 0));
  return (
    <section class="panel flush rules-table">
      <header><h2>{t('side')}</h2></header>
      <div class="table-frame" tabIndex={0} role="region" aria-label={t('side')}>
        <table class="by-rules">
          <thead>
            <tr>
              <th scope="col">{t('taken_for')}</th>
              <th scope="col" class="number">{compared.standard}</th>
              {rules.map((rule) => (
                <th key={rule.id} scope="col" class="rule">
                  {rule.name}
                  {unchecked_words(rule) !== null && <span class="line small caution-words">{unchecked_words(rule)}</span>}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {rows.map((row) => (
              <tr key={row ?? 'other'}>
                <th scope="row">{row === null ? t('other') : <ParameterSymbol parameter={row} />}</th>
                <td class="number">{row === null ? absent : standard_text(rules, row)}</td>
                {rules.map((rule) => (
                  <td key={rule.id}>
                    {figures_of(rule, row).map((figure) => <Figure key={figure.key} figure={figure} />)}
                  </td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      <p class="small quiet foot">{t('unit', { unit: unit_sign(compared.unit), standard: compared.standard })}</p>
      {compared.remarks.map((remark) => <p key={remark} class="small foot">{sentence(remark)}</p>)}
      {compared.uncertainty && compared.uncertainty.notes.length > 0 && (
        <details class="small foot"><summary>{t('assumed')}</summary><ul>{compared.uncertainty.notes.map((note) => <li key={note}><Formula text={sentence(note)} /></li>)}</ul></details>
      )}
    </section>
  );
}

function Figure({ figure }: { figure: ComparedFigure }) {
  const { shown, symbol } = figure;
  const travel = shown.share_of_travel === '' ? '' : t('of_travel', { share: shown.share_of_travel });
  const apart = figure.departs_by === null ? [] : [shown.difference, shown.relative_difference && `(${shown.relative_difference})`];
  const below = [travel, ...apart].filter((part) => part !== '').join(' ');
  return (
    <div class="rule-figure" title={`${figure.title}${colon()} ${figure.evidence_text}`}>
      <span class="what">{symbol === null ? <span class="small">{figure.title}</span> : <RuleSymbol symbol={symbol} />}</span>
      <span class="number">{figure.value === null ? absent : shown.value}</span>
      {figure.absent_because !== null && <span class="line small quiet">{figure.absent_because}</span>}
      {shown.interval !== '' && <span class="line small number">{shown.interval}</span>}
      {figure.no_interval_because !== null && <span class="line small quiet">{figure.no_interval_because}</span>}
      {below !== '' && <span class="line small quiet number">{below}</span>}
    </div>
  );
}
