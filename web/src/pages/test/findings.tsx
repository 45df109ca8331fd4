// SPDX-License-Identifier: Apache-2.0
import type { Field, Finding, Vocabulary } from '../../api/types';
import { Formula } from '../../components/formula';
import { texts } from '../../i18n/texts';
import { field_unit, stated_text } from './field_value';
import type { TestState } from './state';

const t = texts({
  title: ['Findings', 'Befunde'],
  none: ['Nothing to remark.', 'Nichts zu bemerken.'],
  departure: ['Departures from the standard', 'Abweichungen von der Norm'],
  missing: ['Missing', 'Fehlende Angaben'],
  note: ['Notes', 'Hinweise'],
  entries: ['{n} {n|entry|entries}', '{n} {n|Angabe|Angaben}'],
  fill_in: ['Fill in:', 'Ergänzen:'],
  clause: ['clause {clause}', 'Abschnitt {clause}'],
  source: ['from the file', 'aus der Datei'],
});

const severities = ['departure', 'missing', 'note'] as const;
const tones = { departure: 'bad', missing: 'caution', note: '' } as const;

/** Clauses of Annex A that a message names, stretches written out: "A.1 to A.3" are three. */
function named_clauses(message: string): Set<string> {
  const found = new Set<string>();
  for (const [, first, last] of message.matchAll(/A\.(\d+)(?:\s*(?:to|bis|–|-)\s*A\.(\d+))?/g))
    for (let n = Number(first); n <= Number(last ?? first); n += 1) found.add(`A.${n}`);
  return found;
}

/** Fields without a value that would answer a finding: named by key, by title, or by their clause of Annex A. */
function missing_fields(finding: Finding, vocabulary: Vocabulary, state: TestState): Field[] {
  const { metadata, axis } = state.evaluated.value.result;
  const message = finding.message.toLowerCase();
  const clauses = named_clauses(finding.message);
  return vocabulary.fields.filter((field) => {
    if (message.includes(field.key.toLowerCase())) return true;
    if (stated_text(field, metadata) !== '') return false;
    if (field.type === 'number' && field.unit_linear !== '' && axis.kind === 'rotary' && field.unit_rotary === '') return false;
    if (clauses.has(field.clause)) return true;
    return field.clause === finding.clause && message.includes(field.title.toLowerCase());
  });
}

/** What the standard finds to say about this test, in words, worst first. */
export function Findings({ state, vocabulary }: { state: TestState; vocabulary: Vocabulary | null }) {
  const { findings } = state.evaluated.value.result;
  return (
    <section class="panel findings-panel">
      <header><h2>{t('title')}</h2></header>
      {findings.length === 0 && <p class="quiet">{t('none')}</p>}
      <div class="stack tight">
        {severities.filter((severity) => findings.some((finding) => finding.severity === severity)).map((severity) => (
          <div key={severity} class={`notice ${tones[severity]}`}>
            {severity === 'missing'
              ? <Missing findings={findings.filter((finding) => finding.severity === severity)} state={state} vocabulary={vocabulary} />
              : (
                <>
                  <h3>{t(severity)}</h3>
                  <ul class="findings">
                    {findings.filter((finding) => finding.severity === severity).map((finding, i) => <li key={i}><Message finding={finding} /></li>)}
                  </ul>
                </>
              )}
          </div>
        ))}
      </div>
    </section>
  );
}

const few_fields = 8;

/** What the standard asks to be stated. Of a file that says nothing of its test that is a page: its length is told, and it is unfolded when asked. */
function Missing({ findings, state, vocabulary }: { findings: readonly Finding[]; state: TestState; vocabulary: Vocabulary | null }) {
  const fields = findings.map((finding) => (vocabulary ? missing_fields(finding, vocabulary, state) : []));
  const count = new Set(fields.flat()).size;
  const list = (
    <ul class="findings">
      {findings.map((finding, i) => (
        <li key={i}>
          <Message finding={finding} />
          <FillIn fields={fields[i] ?? []} state={state} />
        </li>
      ))}
    </ul>
  );
  if (count <= few_fields) return <><h3>{t('missing')}</h3>{list}</>;
  return (
    <details>
      <summary><strong>{t('missing')}</strong> <span class="number">{t('entries', { n: count })}</span></summary>
      {list}
    </details>
  );
}

function Message({ finding }: { finding: Finding }) {
  const clause = finding.clause === 'source' ? t('source') : /^\d|^A\.\d/.test(finding.clause) ? t('clause', { clause: finding.clause }) : finding.clause;
  return <p><Formula text={finding.message} /> <span class="quiet small">{clause}</span></p>;
}

function FillIn({ fields, state }: { fields: readonly Field[]; state: TestState }) {
  if (fields.length === 0 || state.test.value.version !== state.test.value.latest) return null;
  const { kind } = state.evaluated.value.result.axis;
  return (
    <p class="fill-in no-print">
      <span class="small quiet">{t('fill_in')}</span>{' '}
      {fields.map((field) => (
        <button key={field.key} type="button" class="small" onClick={() => state.edit(field.key)}>{[field.title, field_unit(field, kind)].filter((part) => part !== '').join(', ')}</button>
      ))}
    </p>
  );
}
