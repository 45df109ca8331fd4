// SPDX-License-Identifier: Apache-2.0
// By which method the uncertainty of record is found: named, and chosen.
import type { Evaluated, Method, Vocabulary } from '../../api/types';
import { all_methods, method_title, method_word } from '../../components/uncertainty';
import { texts } from '../../i18n/texts';
import { method_field, type TestState } from './state';
import { colon } from '../../i18n/colon';

const t = texts({
  of_record: 'Uncertainty of record',
  by_default: 'by default: {method}',
  by_default_alone: 'by default',
  decides: 'It stands with every value and decides; other methods are shown for comparison.',
  none: 'none stated',
  running: 'Monte Carlo is drawing trials; the figures are those from before …',
});

/** The method whose uncertainty stands with the results. */
export const record_method = (evaluated: Evaluated): Method | null => evaluated.result.uncertainty?.record?.method ?? null;

/** Below the figures: whose uncertainty they have, and the way to another one. */
export function RecordLine({ state, vocabulary }: { state: TestState; vocabulary: Vocabulary | null }) {
  const method = record_method(state.evaluated.value);
  const field = vocabulary?.fields.find((one) => one.key === method_field);
  const editable = field !== undefined && state.test.value.version === state.test.value.latest;
  const name = method === null ? t('none') : method_title(method);
  const chosen = field ? state.text_of(field) : '';
  return (
    <div class="record-line small">
      <span class={editable ? 'only-print' : ''}>{t('of_record')}{colon()} {name}.</span>
      {editable && (
        <label class="no-print">{t('of_record')}
          <select value={chosen} onChange={(event) => { state.edit(); state.put(field, event.currentTarget.value); }}>
            <option value="">{chosen === '' && method !== null ? t('by_default', { method: name }) : t('by_default_alone')}</option>
            {all_methods.filter((one) => field.choices.includes(method_word(one))).map((one) => (
              <option key={one} value={method_word(one)}>{method_title(one)}</option>
            ))}
          </select>
        </label>
      )}{' '}
      <span class="quiet" role="status">{state.busy.value === 'sampling' ? t('running') : method === null ? '' : t('decides')}</span>
    </div>
  );
}
