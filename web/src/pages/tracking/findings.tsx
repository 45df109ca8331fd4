// SPDX-License-Identifier: Apache-2.0
import type { TrackingFinding } from '../../api/types';
import { sentence } from '../../components/findings';
import { t } from './texts';

/** What was found, the gravest first, each with its stable name; its weight is a word beside the colour. */
export function TrackingFindings({ findings }: { findings: TrackingFinding[] }) {
  if (findings.length === 0) return <p class="quiet">{t('no_findings')}</p>;
  return (
    <ul class="finding-list">
      {findings.map(({ id, severity, message }, k) => (
        <li key={k} class={severity === 'serious' ? 'departure' : 'note'}>
          <span class="weight">{t(severity)}</span>
          <span>{sentence(message)} <span class="quiet mono small">{id}</span></span>
        </li>
      ))}
    </ul>
  );
}
