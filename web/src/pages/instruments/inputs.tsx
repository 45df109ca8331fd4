// SPDX-License-Identifier: Apache-2.0
// What an instrument brings to a test: inputs of the uncertainty, by the keys of the metadata.
import type { Changes, Field as Known, Vocabulary } from '../../api/types';
import { use_get } from '../../api/use';
import { marked, parsed } from '../../numbers';
import { t } from './texts';

export interface Input { key: string; text: string }

export const rows_of = (inputs: Changes): Input[] => Object.entries(inputs).map(([key, text]) => ({ key, text: shown(text) }));

/** Numbers in the user's decimal mark; other texts as they are. */
const shown = (text: string): string => (/^-?\d*\.?\d+(e[+-]?\d+)?$/i.test(text) ? marked(text) : text);

export function wrong_input(row: Input, known: readonly Known[]): boolean {
  const field = known.find((one) => one.key === row.key);
  return field?.type === 'number' && parsed(row.text) === null;
}

/** As `--set` takes them; rows without a key or a text are left out. */
export function changes_of(rows: readonly Input[], known: readonly Known[]): Changes {
  return Object.fromEntries(rows.flatMap((row) => {
    if (row.key === '' || row.text.trim() === '') return [];
    const number = known.find((one) => one.key === row.key)?.type === 'number';
    return [[row.key, number ? String(parsed(row.text)) : row.text]];
  }));
}

export function use_inputs(): readonly Known[] {
  return use_get<Vocabulary>('/api/vocabulary').data?.fields.filter((field) => field.group === 'uncertainty' && field.type !== 'records' && field.type !== 'numbers') ?? [];
}

export function InputsEditor({ rows, known, tried, on_change }: {
  rows: readonly Input[]; known: readonly Known[]; tried: boolean; on_change: (rows: Input[]) => void;
}) {
  const set = (i: number, part: Partial<Input>) => on_change(rows.map((row, k) => (k === i ? { ...row, ...part } : row)));
  return (
    <fieldset class="inputs">
      <legend>{t('inputs')}</legend>
      <p class="quiet small">{t('inputs_hint')}</p>
      {rows.map((row, i) => {
        const field = known.find((one) => one.key === row.key);
        const wrong = tried && wrong_input(row, known);
        const title = field?.title ?? row.key;
        return (
          <div key={i} class="input-row">
            <select aria-label={t('input')} value={row.key} onChange={(event) => set(i, { key: event.currentTarget.value })}>
              <option value="">{t('choose')}</option>
              {!field && row.key !== '' && <option value={row.key}>{row.key}</option>}
              {known.map((one) => <option key={one.key} value={one.key} disabled={one.key !== row.key && rows.some((other) => other.key === one.key)}>{one.title}</option>)}
            </select>
            {field?.type === 'choice'
              ? <select aria-label={title} value={row.text} onChange={(event) => set(i, { text: event.currentTarget.value })}>
                  <option value="" />
                  {field.choices.map((choice) => <option key={choice} value={choice}>{choice}</option>)}
                </select>
              : <input
                  aria-label={title || t('value')} value={row.text} inputMode={field?.type === 'number' ? 'decimal' : 'text'} aria-invalid={wrong ? 'true' : undefined}
                  onInput={(event) => set(i, { text: event.currentTarget.value })}
                />}
            <span class="quiet unit">{field?.unit_linear}</span>
            <button type="button" class="plain" aria-label={t('remove_input', { title })} onClick={() => on_change(rows.filter((_, k) => k !== i))}>
              <svg width="12" height="12" viewBox="0 0 14 14" aria-hidden="true"><path d="M2 2l10 10M12 2L2 12" stroke="currentColor" stroke-width="1.6" /></svg>
            </button>
            {wrong && <span class="fault" role="alert">{t('number_fault', { text: row.text })}</span>}
          </div>
        );
      })}
      <button type="button" onClick={() => on_change([...rows, { key: '', text: '' }])}>{t('add_input')}</button>
    </fieldset>
  );
}

export function InputsTable({ inputs, known }: { inputs: Changes; known: readonly Known[] }) {
  const all = Object.entries(inputs);
  if (all.length === 0) return <p class="quiet">{t('no_inputs')}</p>;
  return (
    <div class="table-frame" tabIndex={0} role="region" aria-label={t('inputs')}>
      <table class="narrow">
        <thead><tr><th scope="col">{t('input')}</th><th scope="col" class="number">{t('value')}</th><th scope="col">{t('unit')}</th></tr></thead>
        <tbody>
          {all.map(([key, text]) => {
            const field = known.find((one) => one.key === key);
            return <tr key={key}><th scope="row">{field?.title ?? key}</th><td class="number">{shown(text)}</td><td class="quiet">{field?.unit_linear}</td></tr>;
          })}
        </tbody>
      </table>
    </div>
  );
}
