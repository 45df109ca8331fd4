// SPDX-License-Identifier: Apache-2.0
import type { Finding } from '../api/types';
import { texts } from '../i18n/texts';
import { Formula } from './formula';

const t = texts({
  departure: ['Departure', 'Abweichung'],
  missing: ['Missing', 'Fehlt'],
  note: ['Note', 'Hinweis'],
  clause: ['clause {clause}', 'Abschnitt {clause}'],
});

/** What the standard says, the gravest first; its weight is a word beside the colour. */
export function FindingList({ findings }: { findings: Finding[] }) {
  return (
    <ul class="finding-list">
      {findings.map((finding, i) => (
        <li key={i} class={finding.severity}>
          <span class="weight">{t(finding.severity)}</span>
          <span>
            <Formula text={finding.message} />
            {finding.clause !== '' && <span class="quiet"> ({t('clause', { clause: finding.clause })})</span>}
          </span>
        </li>
      ))}
    </ul>
  );
}
