// SPDX-License-Identifier: Apache-2.0
import type { Evaluated } from '../../api/types';
import { sentence } from '../../components/findings';
import { texts } from '../../i18n/texts';
import { marked, parsed } from '../../numbers';

const t = texts({
  smaller: ['For information, not a parameter of the standard: the smaller of R↑ and R↓ is {value} {unit}.',
            'Nur zur Information, kein Kennwert der Norm: der kleinere Wert von R↑ und R↓ ist {value} {unit}.'],
});

/** What somebody asked to be told beside the parameters of the standard. */
export function Information({ evaluated }: { evaluated: Evaluated }) {
  const found = evaluated.result.information?.smaller_repeatability;
  if (!found) return null;
  const told = parsed(found.text) === null ? sentence(found.text) : t('smaller', { value: marked(found.text), unit: evaluated.shown[0]?.unit ?? found.unit });
  return <p class="small quiet foot information">{told}</p>;
}
