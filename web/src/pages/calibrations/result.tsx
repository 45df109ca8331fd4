// SPDX-License-Identifier: Apache-2.0
// What a calibration has found, shown as the page shows it where it was evaluated.
import type { KeptCalibration, MotionResult, TrackingEvaluation, VolumetricResult } from '../../api/types';
import { is_motion_kind } from '../motions/form';
import { MotionView } from '../motions/view';
import { Results } from '../tracking/results';
import { VolumeResult } from '../volume/result';
import '../tracking/tracking.css';
import { t } from './texts';

export function CalibrationResult({ calibration }: { calibration: KeptCalibration }) {
  if (calibration.kind === 'lines') {
    return (
      <section class="panel">
        <header><h2>{t('lines')}</h2></header>
        <Results evaluation={calibration.result as TrackingEvaluation} />
      </section>
    );
  }
  if (is_motion_kind(calibration.kind)) return <MotionView result={calibration.result as MotionResult} />;
  return <VolumeResult result={calibration.result as VolumetricResult} />;
}
