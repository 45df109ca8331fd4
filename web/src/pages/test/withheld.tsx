// SPDX-License-Identifier: Apache-2.0
// Why nothing is decided although there is a value, and what mends that.
import type { Evaluated, Judgement, Parameter, Vocabulary } from '../../api/types';
import { sentence } from '../../components/findings';
import { Formula } from '../../components/formula';
import { texts } from '../../i18n/texts';
import { judgement_of, plain_symbol, withheld_of } from './figures_text';
import type { TestState } from './state';

const t = texts({
  title: 'Undecided: {symbols}',
  correct: 'Correct: {title}',
  say: 'Say: {title}',
});

type Remedy = NonNullable<Judgement['remedy']>;

interface Reason { text: string; parameters: Parameter[]; remedy: Remedy | undefined }

/** Each reason once, with the parameters that it holds of. */
function reasons(evaluated: Evaluated): Reason[] {
  const found: Reason[] = [];
  for (const row of evaluated.shown) {
    const withheld = withheld_of(evaluated, row);
    if (withheld === null) continue;
    const same = found.find(({ text }) => text === withheld);
    if (same) same.parameters.push(row.parameter);
    else found.push({ text: withheld, parameters: [row.parameter], remedy: judgement_of(evaluated, row.parameter)?.remedy });
  }
  return found;
}

export function Withheld({ state, vocabulary }: { state: TestState; vocabulary: Vocabulary | null }) {
  const found = reasons(state.evaluated.value);
  if (found.length === 0) return null;
  return (
    <div class="notice caution withheld-reasons">
      {found.map((reason) => (
        <div key={reason.text}>
          <p><strong>{t('title', { symbols: reason.parameters.map(plain_symbol).join(', ') })}</strong> – <Formula text={sentence(reason.text)} /></p>
          {vocabulary && reason.remedy && <Mends state={state} vocabulary={vocabulary} remedy={reason.remedy} />}
        </div>
      ))}
    </div>
  );
}

/** What mends it, a press away; it is a draft like any other change. */
function Mends({ state, vocabulary, remedy }: { state: TestState; vocabulary: Vocabulary; remedy: Remedy }) {
  if (state.test.value.version !== state.test.value.latest) return null;
  const made = state.options.value.corrections;
  const correct = (id: string) => {
    state.edit();
    state.choose({ corrections: vocabulary.corrections.map((one) => one.id).filter((one) => one === id || made.includes(one)) });
  };
  return (
    <div class="row no-print">
      {vocabulary.corrections.filter(({ id }) => remedy.corrections.includes(id) && !made.includes(id)).map(({ id, title }) => (
        <button key={id} type="button" class="small" onClick={() => correct(id)}>{t('correct', { title })}</button>
      ))}
      {vocabulary.fields.filter(({ key }) => remedy.fields.includes(key)).map((field) => (
        <button key={field.key} type="button" class="small" onClick={() => state.edit(field.key)}>{t('say', { title: field.title })}</button>
      ))}
    </div>
  );
}
