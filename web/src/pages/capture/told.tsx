// SPDX-License-Identifier: Apache-2.0
// What a capture of one axis tells beside its readings.
import type { Capture } from '../../api/types';
import { fixed } from '../../numbers';
import type { Reading } from './live';
import { t } from './texts';

export function Events({ capture }: { capture: Capture }) {
  const all = [...capture.notices.map((message) => ({ message, time_s: null })), ...[...capture.events].reverse()];
  return (
    <section class="panel" aria-labelledby="events">
      <h2 id="events">{t('events')}</h2>
      {all.length === 0 ? <p class="quiet">{t('no_events')}</p> : (
        <ul class="event-list" tabIndex={0} aria-labelledby="events">
          {all.map((event, i) => (
            <li key={i}>
              <span class="number quiet">{event.time_s === null ? '' : `${fixed(event.time_s, 1)} s`}</span> {event.message}
            </li>
          ))}
        </ul>
      )}
    </section>
  );
}

/** The latest reading for those who do not look. */
export function Said({ readings, unit }: { readings: Reading[]; unit: string }) {
  const last = readings[readings.length - 1];
  return (
    <p class="visually-hidden" aria-live="polite">
      {last && t('said', { i: last.target, direction: t(last.direction), run: last.run, value: `${fixed(last.deviation, 1)} ${unit}` })}
    </p>
  );
}
