// SPDX-License-Identifier: Apache-2.0
import type { Changes, Field, Options, Vocabulary } from '../../api/types';
import { texts } from '../../i18n/texts';
import { typed_text } from './field_value';

const t = texts({
  title: ['Differences', 'Unterschiede'],
  field: ['Field', 'Feld'],
  nothing: ['nothing', 'nichts'],
  unchanged: ['as in the file', 'wie in der Datei'],
  options: ['Evaluation', 'Auswertung'],
  same: ['No difference in metadata or inputs.', 'Kein Unterschied in Angaben oder Eingangsgrößen.'],
});

export interface State { changes: Changes; options: Options }

/** Keys whose change differs between two states. */
export function different_keys(a: Changes, b: Changes): string[] {
  return [...new Set([...Object.keys(a), ...Object.keys(b)])].filter((key) => a[key] !== b[key]);
}

function options_text(options: Options): string {
  const parts = [...options.methods, ...options.corrections];
  if (options.methods.includes('monte-carlo')) parts.push(`seed ${options.seed}`, `${Math.round(options.coverage * 1e6) / 1e4} %`, ...(options.trials === null ? [] : [String(options.trials)]));
  return parts.join(', ');
}

function value_text(field: Field | undefined, value: string | undefined): string {
  if (value === undefined) return t('unchanged');
  if (value === '') return t('nothing');
  return field ? typed_text(field, value) : value;
}

/** What differs in metadata, inputs and options, side by side. */
export function Differences({ states, vocabulary }: { states: readonly { title: string; state: State }[]; vocabulary: Vocabulary | null }) {
  const keys = [...new Set(states.flatMap(({ state }) => states.flatMap((other) => different_keys(state.changes, other.state.changes))))].sort();
  const options = states.map(({ state }) => options_text(state.options));
  const options_differ = options.some((text) => text !== options[0]);
  if (keys.length === 0 && !options_differ) return <p class="quiet">{t('same')}</p>;
  return (
    <div class="table-frame" tabIndex={0} role="region" aria-label={t('title')}>
      <table class="differences">
        <thead><tr><th scope="col">{t('field')}</th>{states.map(({ title }) => <th key={title} scope="col">{title}</th>)}</tr></thead>
        <tbody>
          {keys.map((key) => {
            const field = vocabulary?.fields.find((one) => one.key === key);
            return (
              <tr key={key}>
                <th scope="row">{field?.title ?? key}</th>
                {states.map(({ title, state }) => <td key={title}>{value_text(field, state.changes[key])}</td>)}
              </tr>
            );
          })}
          {options_differ && <tr><th scope="row">{t('options')}</th>{options.map((text, i) => <td key={i}>{text}</td>)}</tr>}
        </tbody>
      </table>
    </div>
  );
}
