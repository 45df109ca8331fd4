// SPDX-License-Identifier: Apache-2.0
// Why nothing is decided although there is a value, and what mends that.
import type { Evaluated, Field, Parameter, Vocabulary } from '../../api/types';
import { sentence } from '../../components/findings';
import { Formula } from '../../components/formula';
import { texts } from '../../i18n/texts';
import { plain_symbol, withheld_of } from './figures_text';
import type { TestState } from './state';

const t = texts({
  title: 'Undecided: {symbols}',
  correct: 'Correct: {title}',
  say: 'Say: {title}',
});

interface Reason { text: string; parameters: Parameter[] }

/** Each reason once, with the parameters that it holds of. */
function reasons(evaluated: Evaluated): Reason[] {
  const found: Reason[] = [];
  for (const row of evaluated.shown) {
    const withheld = withheld_of(evaluated, row);
    if (withheld === null) continue;
    const same = found.find(({ text }) => text === withheld);
    if (same) same.parameters.push(row.parameter);
    else found.push({ text: withheld, parameters: [row.parameter] });
  }
  return found;
}

/** Corrections by the words in which a reason names them, in every language. */
const named_as = texts({
  nde: 'the correction for thermal expansion',
  'air=ciddor': 'the correction for the air after Ciddor',
  'dead-path': 'the correction of the dead path',
  gain: 'the correction of the gain',
  sign: 'the correction of the sign',
});
const named = ['nde', 'air=ciddor', 'dead-path', 'gain', 'sign'] as const;

/** Those that the reason names, which the page can make as well. */
const corrections_in = (text: string, { corrections }: Vocabulary): Vocabulary['corrections'] =>
  named.filter((id) => text.includes(named_as(id))).flatMap((id) => corrections.filter((one) => one.id === id));

const fields_in = (text: string, { fields }: Vocabulary): Field[] => fields.filter(({ key }) => text.includes(key));

export function Withheld({ state, vocabulary }: { state: TestState; vocabulary: Vocabulary | null }) {
  const found = reasons(state.evaluated.value);
  if (found.length === 0) return null;
  return (
    <div class="notice caution withheld-reasons">
      {found.map((reason) => (
        <div key={reason.text}>
          <p><strong>{t('title', { symbols: reason.parameters.map(plain_symbol).join(', ') })}</strong> – <Formula text={sentence(reason.text)} /></p>
          {vocabulary && <Mends state={state} vocabulary={vocabulary} text={reason.text} />}
        </div>
      ))}
    </div>
  );
}

/** What the reason names, a press away; it is a draft like any other change. */
function Mends({ state, vocabulary, text }: { state: TestState; vocabulary: Vocabulary; text: string }) {
  if (state.test.value.version !== state.test.value.latest) return null;
  const made = state.options.value.corrections;
  const correct = (id: string) => {
    state.edit();
    state.choose({ corrections: vocabulary.corrections.map((one) => one.id).filter((one) => one === id || made.includes(one)) });
  };
  return (
    <div class="row no-print">
      {corrections_in(text, vocabulary).filter(({ id }) => !made.includes(id)).map(({ id, title }) => (
        <button key={id} type="button" class="small" onClick={() => correct(id)}>{t('correct', { title })}</button>
      ))}
      {fields_in(text, vocabulary).map((field) => (
        <button key={field.key} type="button" class="small" onClick={() => state.edit(field.key)}>{t('say', { title: field.title })}</button>
      ))}
    </div>
  );
}
