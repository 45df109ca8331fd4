// SPDX-License-Identifier: Apache-2.0
import type { Changes, Evaluated, Options, Vocabulary } from '../../api/types';
import { texts } from '../../i18n/texts';
import { count, marked } from '../../numbers';
import { unchanged_text, value_with_unit } from './field_words';

const t = texts({
  title: 'Differences',
  field: 'Field',
  options: 'Evaluation',
  annex_a: 'Annex A',
  sampling: 'Monte Carlo (seed {seed}, {coverage} %{trials})',
  trials: ', {trials} trials',
  log: 'temperature log {name} ({hash})',
  same: 'No difference in metadata or inputs.',
});

export interface State { changes: Changes; options: Options }

/** Keys whose change differs between two states. */
export function different_keys(a: Changes, b: Changes): string[] {
  return [...new Set([...Object.keys(a), ...Object.keys(b)])].filter((key) => a[key] !== b[key]);
}

/** Everything that a log is judged by. */
function log_text(log: NonNullable<Options['temperatures']>): string {
  const number = (x: number | undefined) => (x === undefined ? '…' : marked(String(x)));
  const parts = [t('log', { name: log.name, hash: log.sha256.slice(0, 8) })];
  if (log.began || log.ended) parts.push(`${log.began ?? '…'} – ${log.ended ?? '…'}`);
  if (log.lowest_C !== undefined || log.highest_C !== undefined) parts.push(`${number(log.lowest_C)} – ${number(log.highest_C)} °C`);
  if (log.rate_C_per_h !== undefined) parts.push(`≤ ${number(log.rate_C_per_h)} °C/h`);
  if (log.gradient_C !== undefined) parts.push(`Δ ≤ ${number(log.gradient_C)} °C`);
  for (const { name, role } of log.sensors ?? []) parts.push(`${name} = ${role}`);
  return parts.join(', ');
}

function options_text(options: Options, vocabulary: Vocabulary): string {
  const { methods, seed, coverage, trials } = options;
  const parts = [t('annex_a')];
  if (methods.includes('gum')) parts.push('GUM');
  if (methods.includes('monte-carlo')) {
    parts.push(t('sampling', {
      seed, coverage: marked(String(Number((100 * coverage).toFixed(4)))), trials: trials === null ? '' : t('trials', { trials: count(trials) }),
    }));
  }
  if (options.temperatures) parts.push(log_text(options.temperatures));
  return [...parts, ...options.corrections.map((id) => vocabulary.corrections.find((one) => one.id === id)?.title ?? id)].join(', ');
}

interface Props {
  states: readonly { title: string; state: State }[];
  of: Evaluated;                      // whose fields these are, and what the archive lends them
  stated: Record<string, unknown>;    // what the file says of them
  vocabulary: Vocabulary;
}

/** What differs in metadata, inputs and options, side by side. */
export function Differences({ states, of, stated, vocabulary }: Props) {
  const keys = [...new Set(states.flatMap(({ state }) => states.flatMap((other) => different_keys(state.changes, other.state.changes))))].sort();
  const options = states.map(({ state }) => options_text(state.options, vocabulary));
  const options_differ = options.some((text) => text !== options[0]);
  if (keys.length === 0 && !options_differ) return <p class="quiet">{t('same')}</p>;
  return (
    <div class="table-frame" tabIndex={0} role="region" aria-label={t('title')}>
      <table class="differences">
        <thead><tr><th scope="col">{t('field')}</th>{states.map(({ title }) => <th key={title} scope="col">{title}</th>)}</tr></thead>
        <tbody>
          {keys.map((key) => {
            const field = vocabulary.fields.find((one) => one.key === key);
            return (
              <tr key={key}>
                <th scope="row">{field?.title ?? key}</th>
                {states.map(({ title, state }) => {
                  const text = state.changes[key];
                  return <td key={title}>{field ? value_with_unit(field, text ?? unchanged_text(field, stated, of), vocabulary, of.result.axis.kind) : (text ?? '')}</td>;
                })}
              </tr>
            );
          })}
          {options_differ && <tr><th scope="row">{t('options')}</th>{options.map((text, i) => <td key={i}>{text}</td>)}</tr>}
        </tbody>
      </table>
    </div>
  );
}
