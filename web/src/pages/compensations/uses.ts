// SPDX-License-Identifier: Apache-2.0
// Which wishes a control has a use for. What it has none for is not offered, since it would be without effect.
import type { CompensatedControl } from '../../api/types';

/** Beside the reference point, the method and what its curves allow, of which every control has a use. */
export type Use = CompensatedControl['options'][number] | 'read_step';

export const has_use = (control: CompensatedControl, use: Use): boolean => (use === 'read_step' ? control.read_step : control.options.includes(use));

/** Whether it has positions to choose: a backlash alone, with or without a scale factor, has none. */
export const has_grid = ({ limits }: CompensatedControl): boolean => limits.points === null || limits.points > 2;

export type OtherCurves = 'both-ways' | 'with-backlash';

/** The curves that its tables may have instead of its own. */
export const other_curves = ({ limits: { curves }, backlash }: CompensatedControl): OtherCurves[] => [
  ...(curves === 'both-ways' ? [] : ['both-ways' as const]), ...(curves !== 'with-backlash' && backlash !== '' ? ['with-backlash' as const] : []),
];

/** What a positive number in its file does. */
export const sign_of = (control: CompensatedControl, is_turned: boolean): string => (is_turned && has_use(control, 'turned_sign') ? control.turned_sign : control.sign);

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
