// SPDX-License-Identifier: Apache-2.0
// What may be done with a calibration: each makes a version, with its reason.
import { useState } from 'preact/hooks';
import { send } from '../../api/client';
import type { KeptCalibration } from '../../api/types';
import { CalibrationFields, type CalibrationWords } from '../../components/calibration_fields';
import { OptionsFields, form_of, options_of, type Options, type OptionsForm } from '../../components/evaluation_options';
import { MotionFields } from '../motions/fields';
import { is_motion_kind, motion_form_of, motion_options } from '../motions/form';
import { ReasonDialog } from '../test/reason_dialog';
import { t } from './texts';

interface Props { calibration: KeptCalibration; on_done: (calibration: KeptCalibration) => void; on_close: () => void }

const path_of = ({ id }: KeptCalibration): string => `/api/calibrations/${id}`;

const words_of = ({ title, machine, instrument, measured_on, notes }: KeptCalibration): CalibrationWords =>
  ({ title, machine: machine?.id ?? null, instrument: instrument?.id ?? null, measured_on, notes });

/** Only what was changed: an instrument that stays is not known anew. */
function changes(before: CalibrationWords, now: CalibrationWords): Partial<CalibrationWords> {
  const keys = Object.keys(now) as (keyof CalibrationWords)[];
  return Object.fromEntries(keys.filter((key) => now[key] !== before[key]).map((key) => [key, now[key]]));
}

export function EditCalibration({ calibration, on_done, on_close }: Props) {
  const [words, set_words] = useState(() => words_of(calibration));
  const changed = changes(words_of(calibration), words);
  const act = async (reason: string) => {
    on_done(await send<KeptCalibration>('POST', `${path_of(calibration)}/versions`, { ...changed, base_version: calibration.version, reason }));
  };
  return (
    <ReasonDialog title={t('edit_title')} action={t('save', { n: calibration.version + 1 })} close={on_close} act={act}
      disabled={Object.keys(changed).length === 0 || words.title.trim() === ''}>
      <CalibrationFields words={words} on_change={set_words} />
    </ReasonDialog>
  );
}

export function EvaluateAgain({ calibration, on_done, on_close }: Props) {
  const { kind } = calibration;
  const [form, set_form] = useState<OptionsForm>(() => form_of(calibration.options as Options));
  const [motion, set_motion] = useState(() => motion_form_of(calibration.options as Options));
  const options = is_motion_kind(kind) ? motion_options(kind, motion) : options_of(kind, form);
  const act = async (reason: string) => {
    on_done(await send<KeptCalibration>('POST', `${path_of(calibration)}/versions`, { options, base_version: calibration.version, reason }));
  };
  return (
    <ReasonDialog title={t('again_title')} action={t('save', { n: calibration.version + 1 })} close={on_close} act={act} disabled={options === null}>
      <p class="hint">{t('again_how')}</p>
      {is_motion_kind(kind) ? <MotionFields kind={kind} form={motion} on_change={set_motion} /> : <OptionsFields kind={kind} form={form} on_change={set_form} />}
    </ReasonDialog>
  );
}

export function WithdrawCalibration({ calibration, on_done, on_close }: Props) {
  const to = calibration.withdrawn ? 'reinstate' : 'withdraw';
  const act = async (reason: string) => { on_done(await send<KeptCalibration>('POST', `${path_of(calibration)}/${to}`, { reason })); };
  return (
    <ReasonDialog title={t(`${to}_title`)} action={t(to)} close={on_close} act={act}>
      {to === 'withdraw' && <p class="hint">{t('withdraw_how')}</p>}
    </ReasonDialog>
  );
}
