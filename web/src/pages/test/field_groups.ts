// SPDX-License-Identifier: Apache-2.0
// What fields of the metadata belong together.
import type { Field } from '../../api/types';
import { texts } from '../../i18n/texts';

const t = texts({
  test: 'Test',
  machine: 'Machine',
  axis: 'Axis',
  equipment: 'Test equipment',
  nde: 'Thermal expansion (NDE)',
  sensors: 'Temperature sensors',
  environment: 'Environment',
  instrument: 'Instrument settings',
  artefact: 'Artefact',
  tolerance: 'Tolerances',
  uncertainty: 'Uncertainty inputs',
  drift: 'Environmental variation',
  tracking: 'Tracking interferometer',
});

const titled = ['test', 'machine', 'axis', 'equipment', 'nde', 'sensors', 'environment', 'instrument', 'artefact', 'tolerance', 'uncertainty', 'drift', 'tracking'] as const;
export const group_title = (group: string): string => {
  const known = titled.find((one) => one === group);
  return known === undefined ? group : t(known);
};

/** What E_VE is, how it acts, and its recording: of one page of the drift test. */
const of_drift: readonly string[] = ['environmental_variation', 'environment_kind', 'drift_recording', 'drift_interval_s'].map((name) => `uncertainty.${name}`);

export const group_of = (field: Field): string =>
  of_drift.includes(field.key) ? 'drift' : field.group || (field.key.split('.')[0] as string);
