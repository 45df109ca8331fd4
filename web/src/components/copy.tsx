// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import { texts } from '../i18n/texts';

const t = texts({
  copy: 'Copy',
  copied: 'Copied',
  failed: 'The browser does not allow it',
});

/** Copies a text; says so where it was pressed and to screen readers. */
export function CopyButton({ text, label, disabled = false }: { text: () => string; label?: string; disabled?: boolean }) {
  const [said, set_said] = useState<'copied' | 'failed' | null>(null);
  const copy = () => {
    to_clipboard(text()).then(
      () => set_said('copied'),
      () => set_said('failed'),
    );
    setTimeout(() => set_said(null), 2500);
  };
  return (
    <>
      <button type="button" disabled={disabled} onClick={copy}>{said === null ? (label ?? t('copy')) : t(said)}</button>
      <span class="visually-hidden" role="status">{said === null ? '' : t(said)}</span>
    </>
  );
}

/** Pages that come over plain HTTP from another computer have no clipboard: there the old way does. */
export async function to_clipboard(text: string): Promise<void> {
  if (navigator.clipboard) return navigator.clipboard.writeText(text);
  const area = document.createElement('textarea');
  area.value = text;
  document.body.append(area);
  area.select();
  const done = document.execCommand('copy');
  area.remove();
  if (!done) throw new Error('no clipboard');
}
