// SPDX-License-Identifier: Apache-2.0
// Which wishes a control has a use for. What it has none for is not offered, since it would be without effect.
import type { CompensatedControl } from '../../api/types';

/** Beside the reference point, the method and what its curves allow, of which every control has a use. */
export type Use = CompensatedControl['options'][number] | 'inch' | 'read_step';

/** Those whose unit of length is one alone. */
const of_one_unit: readonly string[] = ['axeserr', 'fanuc', 'fanuc-bidirectional', 'grblhal', 'haas', 'marlin', 'pmac', 'smoothie', 'twincat-cnc'];
/** Those whose file may leave the spacing to a parameter of the control. */
const of_told_step: readonly string[] = ['fanuc', 'fanuc-bidirectional'];

export function has_use(control: CompensatedControl, use: Use): boolean {
  if (use === 'inch') return !of_one_unit.includes(control.id);
  if (use === 'read_step') return of_told_step.includes(control.id);
  return control.options.includes(use);
}

/** Whether it has positions to choose: a backlash alone, with or without a scale factor, has none. */
export const has_grid = ({ limits }: CompensatedControl): boolean => limits.points === null || limits.points > 2;

/** Whether it takes axes of this kind. */
export const takes = ({ limits }: CompensatedControl, kind: 'linear' | 'rotary'): boolean => limits[kind];

/** Words of what machines say of their control, and the control they mean: the more special ones first. */
const names: readonly (readonly [RegExp, string])[] = [
  [/linux\s*cnc|emc2/i, 'linuxcnc'],
  [/sinumerik|siemens|840\s*d|828\s*d|808\s*d|802\s*d/i, 'siemens-lec'],
  [/fanuc/i, 'fanuc'],
  [/heidenhain|\b(i?tnc|manualplus)\b/i, 'heidenhain'],
  [/twincat\s*(ptp|nc\s*ptp)/i, 'twincat-ptp'],
  [/twincat|beckhoff|\bisg\b/i, 'twincat-cnc'],
  [/\bacs\b|spiiplus/i, 'acs'],
  [/aerotech|automation\s*1|\ba3200\b/i, 'aerotech'],
  [/pmac|delta\s*tau/i, 'pmac'],
  [/fagor/i, 'fagor'],
  [/haas/i, 'haas'],
  [/mitsubishi|meldas/i, 'mitsubishi'],
  [/kflop|kogna|kmotion/i, 'kflop'],
  [/mach\s*4/i, 'mach4'],
  [/grbl\s*hal/i, 'grblhal'],
  [/marlin/i, 'marlin'],
  [/smoothie/i, 'smoothie'],
  [/ncstudio|weihong/i, 'axeserr'],
];

/** The control that a machine's own words mean; null where they mean none of these, or one that does not take the axis. */
export function guessed(words: string, controls: readonly CompensatedControl[], kind: 'linear' | 'rotary'): CompensatedControl | null {
  const id = names.find(([pattern]) => pattern.test(words))?.[1];
  return controls.find((one) => one.id === id && takes(one, kind)) ?? null;
}
