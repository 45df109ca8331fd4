// SPDX-License-Identifier: Apache-2.0
// How the page of straightness, angles and squareness calls what the command line calls by a flag.
import { words_by } from '../../components/page_words';
import { t } from './texts';

const named = { error: 'error', positive: 'positive', reference: 'reference', offset: 'offset' } as const;

export const motion_label = (flag: string): string | undefined => (flag in named ? t(named[flag as keyof typeof named]) : undefined);
export const motion_words = words_by(motion_label);
