// SPDX-License-Identifier: Apache-2.0
// How the pages of lengths and of the volume call what the command line calls by a flag.
import { option_label } from '../../components/evaluation_options';
import { words_by } from '../../components/page_words';
import { capture_label } from '../capture/words';
import { t } from './result_texts';

export const length_label = (flag: string): string | undefined => option_label(flag) ?? capture_label(flag);
const volume_label = (flag: string): string | undefined => (flag === 'tool' ? t('tool') : length_label(flag));

export const volume_words = words_by(volume_label);
export const tracking_words = words_by(length_label);
