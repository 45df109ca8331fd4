// SPDX-License-Identifier: Apache-2.0
// How the page of the volume calls what the command line calls by a flag.
import { words_by } from '../../components/page_words';
import { length_label } from '../tracking/words';
import { t } from './result_texts';

export const volume_words = words_by((flag) => (flag === 'tool' ? t('tool') : length_label(flag)));
