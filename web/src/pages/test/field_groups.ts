// SPDX-License-Identifier: Apache-2.0
// What fields of the metadata belong together.
import type { Field } from '../../api/types';
import { texts } from '../../i18n/texts';

const t = texts({
  test: ['Test', 'Prüfung'],
  machine: ['Machine', 'Maschine'],
  axis: ['Axis', 'Achse'],
  equipment: ['Test equipment', 'Messmittel'],
  nde: ['Thermal expansion (NDE)', 'Wärmedehnung (NDE)'],
  sensors: ['Temperature sensors', 'Temperatursensoren'],
  environment: ['Environment', 'Umgebung'],
  instrument: ['Instrument settings', 'Geräteeinstellungen'],
  artefact: ['Artefact', 'Prüfkörper'],
  tolerance: ['Tolerances', 'Toleranzen'],
  uncertainty: ['Uncertainty inputs', 'Eingangsgrößen der Unsicherheit'],
  tracking: ['Tracking interferometer', 'Tracking-Interferometer'],
});

const titled = ['test', 'machine', 'axis', 'equipment', 'nde', 'sensors', 'environment', 'instrument', 'artefact', 'tolerance', 'uncertainty', 'tracking'] as const;
export const group_title = (group: string): string => {
  const known = titled.find((one) => one === group);
  return known === undefined ? group : t(known);
};

export const group_of = (field: Field): string => field.group || (field.key.split('.')[0] as string);
