// SPDX-License-Identifier: Apache-2.0
import { health, reachable, why_read_only } from './api/session';
import { bytes, count } from './numbers';
import { t } from './shell_texts';
import { colon } from './i18n/colon';

/** What holds for every page at the moment: a lost connection, a store that cannot be written. */
export function Banners() {
  const why = why_read_only();
  return (
    <div class="banners no-print" aria-live="polite">
      {!reachable.value && <p class="notice caution lost">{t('lost')}</p>}
      {reachable.value && why !== null && <p class="notice caution">{t('read_only', { why: why === '' ? '' : `: ${why}` })}</p>}
    </div>
  );
}

export function StatusLine() {
  const now = health.value;
  if (!now) return null;
  const { store } = now;
  return (
    <footer class="status no-print">
      <span>Axiometry {now.program.version}</span>
      <span class="where">
        {t('store')}{colon()} {store.location}{store.writable ? '' : ` (${t('read_only_short')})`}
      </span>
      <span>{t('counted', { tests: count(store.counts.tests), size: bytes(store.counts.content_bytes) })}</span>
    </footer>
  );
}
