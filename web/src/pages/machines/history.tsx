// SPDX-License-Identifier: Apache-2.0
import { useEffect, useRef } from 'preact/hooks';
import type { AxisVersions, InstrumentVersions, MachineVersions } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { VersionList } from '../../components/versions';
import { t } from './texts';
import { colon } from '../../i18n/colon';

/** The versions of a machine, an axis or an instrument, and the way to its lines in the audit trail. */
export function EntityHistory({ path, subject, version }: { path: string; subject: string; version: number }) {
  const versions = use_get<MachineVersions | AxisVersions | InstrumentVersions>(`${path}/versions`);
  const seen = useRef(version);
  useEffect(() => { if (seen.current !== version) { seen.current = version; versions.reload(); } }, [version]);
  return (
    <details class="panel history">
      <summary>{t('history')} <span class="quiet small">({t('versions')}{colon()} {version})</span></summary>
      {versions.error && <FailureNotice error={versions.error} retry={versions.reload} />}
      {versions.data && <VersionList versions={versions.data.versions.map((one) => ({ ...one.change, version: one.version }))} />}
      <p class="small"><a href={`/audit?subject=${encodeURIComponent(subject)}`}>{t('audit')}</a></p>
    </details>
  );
}
