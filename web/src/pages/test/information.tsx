// SPDX-License-Identifier: Apache-2.0
import type { Evaluated } from '../../api/types';
import { texts } from '../../i18n/texts';
import { shown_of } from './figures_text';

const t = texts({
  smaller: 'For information, not a parameter of the standard: the smaller of R↑ and R↓ is {value} {unit}.',
});

/** What somebody asked to be told beside the parameters of the standard. */
export function Information({ evaluated }: { evaluated: Evaluated }) {
  const found = evaluated.result.information?.smaller_repeatability;
  const shown = found && shown_of(evaluated, found.of);
  if (!shown) return null;
  return <p class="small quiet foot information">{t('smaller', { value: shown.value, unit: shown.unit })}</p>;
}
