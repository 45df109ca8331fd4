// SPDX-License-Identifier: Apache-2.0
// How pages of lengths call what the command line calls by a flag.
import { option_label } from '../../components/evaluation_options';
import { words_by } from '../../components/page_words';
import { capture_label } from '../capture/words';
import { t } from './coordinates_texts';

export const length_label = (flag: string): string | undefined => option_label(flag) ?? capture_label(flag);
export const tracking_words = words_by((flag) => (flag === 'instrument' ? t('instrument') : length_label(flag)));
