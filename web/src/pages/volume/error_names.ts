// SPDX-License-Identifier: Apache-2.0
// The 21 errors after ISO 230-1: names, kinds, units.
import { t } from './result_texts';

export const axes = ['X', 'Y', 'Z'] as const;
export type Axis = (typeof axes)[number];

export interface Motion { name: string; axis: Axis; motion: string; unit: 'µm' | 'µrad' }

/** Of each axis EXa, EYa, EZa, EAa, EBa, ECa. */
export const motions: readonly Motion[] = axes.flatMap((axis) =>
  [...'XYZABC'].map((motion): Motion => ({ name: `E${motion}${axis}`, axis, motion, unit: 'XYZ'.includes(motion) ? 'µm' : 'µrad' })));

/** Y against X, Z against X, Z against Y. */
export const squarenesses = [['C0Y', 'Y', 'X'], ['B0Z', 'Z', 'X'], ['A0Z', 'Z', 'Y']] as const;

/** Roll is about the axis itself; pitch of X about Y, of Y and Z about X; yaw the third. */
export function kind_of({ axis, motion }: Motion): string {
  if (motion === axis) return t('positioning');
  if ('XYZ'.includes(motion)) return t('straightness', { axis: motion });
  const about = 'XYZ'['ABC'.indexOf(motion)] as Axis;
  if (about === axis) return t('roll');
  return about === (axis === 'X' ? 'Y' : 'X') ? t('pitch') : t('yaw');
}
