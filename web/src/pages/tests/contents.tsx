// SPDX-License-Identifier: Apache-2.0
import { Fragment } from 'preact';
import type { Method, Preview } from '../../api/types';
import { FigureCell, ParameterHead } from '../../components/figure_cell';
import { Formula } from '../../components/formula';
import { ParameterSymbol } from '../../components/symbol';
import { method_title } from '../../components/uncertainty';
import { VerdictMark } from '../../components/verdict';
import { absent, marked, position_unit, shortest } from '../../numbers';
import { Course } from './course';
import { t } from './texts';

type Previewed = Preview['tests'][number];

const extent = (test: Previewed): string =>
  `${t('targets_runs', { targets: test.targets, runs: test.runs })}, ${t('stretch', { first: shortest(test.first), last: shortest(test.last) })} ${position_unit(test.kind)}`;

const glance = ['A', 'E', 'R', 'B'] as const;
const shown_of = (test: Previewed, key: string) => test.evaluated?.shown.find((one) => one.parameter === key && /\d/.test(one.value)) ?? null;

const is_sure = (test: Previewed): boolean => glance.some((key) => (shown_of(test, key)?.low ?? null) !== null);

/** By which methods the uncertainties of these tests were found. */
const methods_of = (tests: readonly Previewed[]): Method[] =>
  [...new Set(tests.flatMap((test) => glance.map((key) => shown_of(test, key)?.method ?? null)))].filter((method) => method !== null);

/** The tests of a file: what they are of and what comes out. */
export function Contents({ preview }: { preview: Preview }) {
  const shown = preview.tests.slice(0, 8);
  const rest = preview.tests.length - shown.length;
  const methods = methods_of(shown);
  const with_U = shown.some((test) => glance.some((key) => (shown_of(test, key)?.U ?? '') !== ''));
  return (
    <div class="contents table-frame" tabIndex={0} role="region" aria-label={preview.file.name}>
      <table>
        <thead>
          <tr>
            <th scope="col">{t('test')}</th><th scope="col" class="wide-only">{t('measured')}</th><th scope="col" class="wide-only">{t('extent')}</th>
            {glance.map((key) => <th key={key} scope="col" class="number"><ParameterHead parameter={key} with_U={with_U} /></th>)}
            <th scope="col" class="wide-only">{t('unit')}</th><th scope="col">{t('verdict')}</th>
          </tr>
        </thead>
        <tbody>
          {shown.map((test, i) => (
            <Fragment key={i}>
              <tr class={notes_of(test) ? 'noted' : undefined}>
                <th scope="row">{[test.name, test.machine, test.axis && t('axis_of', { axis: test.axis })].filter((part) => part !== '').join(', ') || t('no_name')}
                  <span class="only-narrow quiet small">{test.measured_on} <span class="extent">{extent(test)}</span> ({test.evaluated?.shown[0]?.unit})</span>
                  {methods.length > 1 && methods_of([test]).map((method) => <span key={method} class="by-method quiet small">{t('by_method', { method: method_title(method) })}</span>)}
                </th>
                <td class="number-text wide-only">{test.measured_on || absent}</td>
                <td class="quiet small wide-only"><span class="extent-course"><span>{extent(test)}</span>{test.evaluated && <Course positions={test.evaluated.result.positions} />}</span></td>
                {glance.map((key) => {
                  const found = shown_of(test, key);
                  return (
                    <td key={key} class="number">
                      {found ? <FigureCell shown={{ value: marked(found.value), U: marked(found.U), interval: found.interval, method: found.method, verdict: found.verdict }} /> : <span class="quiet">{absent}<span class="plus-minus" /></span>}
                    </td>
                  );
                })}
                <td class="quiet wide-only">{test.evaluated?.shown[0]?.unit}</td>
                <td>{test.evaluated && <VerdictMark verdict={test.evaluated.verdict} />}</td>
              </tr>
              {notes_of(test) && <tr class="note"><td colSpan={6}>{notes_of(test)}</td><td colSpan={3} class="wide-only" /></tr>}
            </Fragment>
          ))}
        </tbody>
      </table>
      {methods.length === 1 && <p class="quiet small more">{t('record', { method: method_title(methods[0] as Method) })}</p>}
      {rest > 0 && <p class="quiet small more">{t('more_tests', { n: rest })}</p>}
    </div>
  );
}

/** What one would rather know before keeping it: that it is no result, why, and that nothing tells how sure it is. */
function notes_of(test: Previewed) {
  if (!test.evaluated) return null;
  const { result } = test.evaluated;
  const gravest = result.findings.find((finding) => finding.severity === 'departure');
  const sure = is_sure(test);
  const other = test.evaluated.shown.filter((one) => ['E_up', 'E_down', 'R_up', 'R_down'].includes(one.parameter) && /\d/.test(one.value));
  if (result.conforming && sure) return null;
  return (
    <>
      {!result.conforming && <p><strong>{t('no_result')}</strong>{gravest && <>: <Formula text={gravest.message} /></>}</p>}
      {shown_of(test, 'A') === null && other.length > 0 && <p class="one-way">{other.map((one) => <span key={one.parameter} class="number"><ParameterSymbol parameter={one.parameter} /> {marked(one.value)} {one.unit}</span>)}</p>}
      {!sure && <p class="quiet">{t('no_U')}</p>}
    </>
  );
}
