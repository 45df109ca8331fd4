// SPDX-License-Identifier: Apache-2.0
import type { Field, Finding, Vocabulary } from '../../api/types';
import { sentence } from '../../components/findings';
import { Formula } from '../../components/formula';
import { texts } from '../../i18n/texts';
import { Claims } from './claims';
import { group_of, group_title } from './field_groups';
import { field_unit } from './field_value';
import type { TestState } from './state';

const t = texts({
  title: 'Findings',
  none: 'Nothing to remark.',
  departure: 'Departures from the standard',
  missing: ['Missing', 'findings'],
  note: ['Notes', 'findings'],
  entries: '{n} {n|entry|entries}',
  fill_in: 'Fill in:',
  clause: 'clause {clause}',
  source: 'from the file',
  expected: 'Not given, but expected in the report:',
});

const severities = ['departure', 'missing', 'note'] as const;
const tones = { departure: 'bad', missing: 'caution', note: '' } as const;

/** The fields that would answer a finding. */
const fields_of = (finding: Finding, vocabulary: Vocabulary): Field[] => vocabulary.fields.filter(({ key }) => finding.fields?.includes(key) ?? false);

/** What the standard finds to say about this test, in words, worst first. */
export function Findings({ state, vocabulary }: { state: TestState; vocabulary: Vocabulary | null }) {
  const { findings, claims } = state.evaluated.value.result;
  return (
    <section class="panel findings-panel">
      <header><h2>{t('title')}</h2></header>
      {claims && claims.length > 0 && <Claims claims={claims} />}
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
  const fields = findings.map((finding) => (vocabulary ? fields_of(finding, vocabulary) : []));
  const count = new Set(fields.flat()).size;
  const list = (
    <ul class="findings">
      {findings.map((finding, i) => (
        <li key={i}>
          {to_fill_in(state) && told_by_fields(finding, fields[i] ?? [])
            ? <Expected finding={finding} fields={fields[i] ?? []} state={state} />
            : <><Message finding={finding} /><FillIn fields={fields[i] ?? []} state={state} /></>}
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

function Message({ finding, text = sentence(finding.message) }: { finding: Finding; text?: string }) {
  const clause = finding.clause === 'source' ? t('source') : /^\d|^A\.\d/.test(finding.clause) ? t('clause', { clause: finding.clause }) : finding.clause;
  return <p><Formula text={text} /> <span class="quiet small">{clause}</span> <span class="quiet mono small">{finding.id}</span></p>;
}

const to_fill_in = (state: TestState): boolean => state.test.value.version === state.test.value.latest;

/** Whether the buttons of the fields say all that the sentence lists. */
const told_by_fields = (finding: Finding, fields: readonly Field[]): boolean => finding.id === 'items-of-identification' && fields.length === finding.fields?.length;

/** A list of items of the report, by what they are of, each with the way to its field. On paper it is the sentence. */
function Expected({ finding, fields, state }: { finding: Finding; fields: readonly Field[]; state: TestState }) {
  const groups = [...new Set(fields.map(group_of))];
  return (
    <>
      <div class="only-print"><Message finding={finding} /></div>
      <div class="no-print"><Message finding={finding} text={t('expected')} /></div>
      <dl class="expected no-print">
        {groups.map((group) => (
          <div key={group}>
            <dt class="small quiet">{group_title(group)}</dt>
            <dd><FieldButtons fields={fields.filter((field) => group_of(field) === group)} state={state} /></dd>
          </div>
        ))}
      </dl>
    </>
  );
}

function FillIn({ fields, state }: { fields: readonly Field[]; state: TestState }) {
  if (fields.length === 0 || !to_fill_in(state)) return null;
  return <p class="fill-in no-print"><span class="small quiet">{t('fill_in')}</span>{' '}<FieldButtons fields={fields} state={state} /></p>;
}

function FieldButtons({ fields, state }: { fields: readonly Field[]; state: TestState }) {
  const { kind } = state.evaluated.value.result.axis;
  return (
    <>
      {fields.map((field) => (
        <button key={field.key} type="button" class="small" onClick={() => state.edit(field.key)}>{[field.title, field_unit(field, kind)].filter((part) => part !== '').join(', ')}</button>
      ))}
    </>
  );
}
