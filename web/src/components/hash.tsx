// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import { texts } from '../i18n/texts';
import { to_clipboard } from './copy';
import './hash.css';

const t = texts({
  copy: 'Copy {hash}',
  copied: 'copied',
  failed: 'not allowed by the browser',
});

/** A hash is known by its beginning; under the pointer or the focus it is whole, and a press copies it. */
export function Hash({ hash }: { hash: string }) {
  const [said, set_said] = useState<'copied' | 'failed' | null>(null);
  const copy = () => {
    to_clipboard(hash).then(() => set_said('copied'), () => set_said('failed'));
    setTimeout(() => set_said(null), 1500);
  };
  return (
    <button type="button" class="hash" onClick={copy}>
      <span class="visually-hidden">{t('copy', { hash })}</span>
      <span aria-hidden="true">{hash.slice(0, 12)}…</span>
      <span class="whole" aria-hidden="true">{said === null ? hash : t(said)}</span>
      <span class="visually-hidden" role="status">{said === null ? '' : t(said)}</span>
    </button>
  );
}
