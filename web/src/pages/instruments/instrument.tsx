// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import type { Instrument } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { absent } from '../../numbers';
import './instruments.css';
import { Due } from './due';
import { InputsTable, use_inputs } from './inputs';
import { InstrumentDialog, name_of } from './instrument_dialog';
import { t } from './texts';
import { EntityHistory } from '../machines/history';

const facts = ['role', 'manufacturer', 'type', 'serial_number', 'certificate', 'calibrated_on'] as const;

/** One instrument: what it is, until when its calibration holds, and what it brings to a test. */
export function InstrumentPage({ parts }: { parts: Record<string, string> }) {
  const instrument = use_get<Instrument>(`/api/instruments/${parts['id']}`);
  const known = use_inputs();
  const [editing, set_editing] = useState(false);
  const found = instrument.data;
  if (instrument.error && !found) return <FailureNotice error={instrument.error} retry={instrument.reload} />;
  if (!found) return null;
  return (
    <>
      <div class="page-head">
        <div>
          <p class="crumb"><a href="/instruments">{t('title')}</a></p>
          <h1 tabIndex={-1}>{name_of(found) || absent}</h1>
        </div>
        <div class="row no-print">
          <a class="button" href={`/?instrument=${found.id}`}>{t('tests')}</a>
          <button type="button" onClick={() => set_editing(true)}>{t('edit')}</button>
        </div>
      </div>
      {instrument.error && <FailureNotice error={instrument.error} retry={instrument.reload} />}
      <section class="panel">
        <dl class="fact-grid">
          {facts.map((key) => <div key={key}><dt>{t(key)}</dt><dd>{found[key] || absent}</dd></div>)}
          <div><dt>{t('calibration_due')}</dt><dd><Due due={found.calibration_due} /></dd></div>
        </dl>
        {found.notes !== '' && <p class="notes">{found.notes}</p>}
      </section>
      <section class="panel">
        <header><h2>{t('inputs')}</h2></header>
        <p class="quiet small">{t('inputs_hint')}</p>
        <InputsTable inputs={found.inputs} known={known} />
      </section>
      <EntityHistory path={`/api/instruments/${found.id}`} subject={`instrument ${found.id}`} version={found.version} />
      {editing && (
        <InstrumentDialog instrument={found} on_saved={() => { set_editing(false); instrument.reload(); }} on_close={() => set_editing(false)} />
      )}
    </>
  );
}
