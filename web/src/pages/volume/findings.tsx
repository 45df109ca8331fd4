// SPDX-License-Identifier: Apache-2.0
import type { VolumetricFinding } from '../../api/types';
import { sentence } from '../../components/findings';
import { t } from './result_texts';

/** What was found, the gravest first, each with its stable name. */
export function VolumeFindings({ findings }: { findings: readonly VolumetricFinding[] }) {
  if (findings.length === 0) return <p class="quiet">{t('no_findings')}</p>;
  return (
    <ul class="finding-list">
      {findings.map(({ id, severity, message }, k) => (
        <li key={k} class={severity === 'serious' ? 'departure' : 'note'}>
          <span class="weight">{t(severity === 'serious' ? 'serious' : 'note')}</span>
          <span>{sentence(message)} <span class="quiet mono small">{id}</span></span>
        </li>
      ))}
    </ul>
  );
}
