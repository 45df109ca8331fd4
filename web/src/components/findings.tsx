// SPDX-License-Identifier: Apache-2.0
import type { Finding } from '../api/types';
import { texts } from '../i18n/texts';
import { Formula } from './formula';

const t = texts({
  departure: 'Departure',
  missing: 'Missing',
  note: 'Note',
  clause: 'clause {clause}',
});

/** With a capital letter and a full stop, unless it begins with a symbol ("s_i") or ends already. */
export function sentence(message: string): string {
  const begins_with_key = /^\p{Ll}[^\s]*[._]\S/u.test(message);
  const begun = !begins_with_key && /^(\p{Ll}{2}|\p{Ll}’|à |a \p{Ll}{2})/u.test(message) ? message.charAt(0).toUpperCase() + message.slice(1) : message;
  return /[.?!]$/.test(begun) ? begun : `${begun}.`;
}

/** What the standard says, the gravest first, each with its stable name; its weight is a word beside the colour. */
export function FindingList({ findings }: { findings: Finding[] }) {
  return (
    <ul class="finding-list">
      {findings.map((finding, i) => (
        <li key={i} class={finding.severity}>
          <span class="weight">{t(finding.severity)}</span>
          <span>
            <Formula text={sentence(finding.message)} />
            {finding.clause !== '' && <span class="quiet"> ({t('clause', { clause: finding.clause })})</span>}
            {' '}<span class="quiet mono small">{finding.id}</span>
          </span>
        </li>
      ))}
    </ul>
  );
}
