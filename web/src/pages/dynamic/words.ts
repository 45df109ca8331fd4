// SPDX-License-Identifier: Apache-2.0
// How the page of motion calls what the command line calls by a flag, and a request by a member.
import { words_by } from '../../components/page_words';
import { position_unit } from '../../numbers';
import { t } from './texts';

const named = {
  feed: 'feed_label', from: 'from', to: 'to', window: 'window', even: 'even', rate: 'rate', 'stream-axis': 'stream_axis', 'skip-damaged': 'skip_damaged', reverse: 'reverse',
  stream: 'stream', 'units-per-count': 'units_per_count', rotary: 'kind',
} as const;

export const dynamic_label = (flag: string): string | undefined =>
  flag in named ? t(named[flag as keyof typeof named], { unit: position_unit('linear') }) : undefined;
export const dynamic_words = words_by(dynamic_label);
