// SPDX-License-Identifier: Apache-2.0
import { signal } from '@preact/signals';
import { useEffect, useState } from 'preact/hooks';
import { add_files } from './pages/tests/incoming';
import { go } from './router';
import { t } from './shell_texts';

const carries_files = (event: DragEvent): boolean => event.dataTransfer?.types.includes('Files') ?? false;

/** A page to which any dropped file belongs, while it is shown. */
export const drop_taker = signal<((files: readonly File[]) => void) | null>(null);

/**
 * Files may be dropped on any page: they are shown on the page of tests. A part of a page that takes files itself
 * prevents the default of its own drop event; a part that takes those of its whole page says so by `drop_taker`.
 */
export function DropAnywhere() {
  const [over, set_over] = useState(false);
  useEffect(() => {
    const end = new AbortController();
    const signal = end.signal;
    window.addEventListener('dragover', (event) => {
      if (!carries_files(event)) return;
      if (!event.defaultPrevented) set_over(true);
      event.preventDefault();
    }, { signal });
    window.addEventListener('dragleave', (event) => { if (event.relatedTarget === null) set_over(false); }, { signal });
    window.addEventListener('drop', (event) => {
      set_over(false);
      if (!carries_files(event) || event.defaultPrevented) return;
      event.preventDefault();
      const files = [...(event.dataTransfer?.files ?? [])];
      if (drop_taker.peek()) { drop_taker.peek()?.(files); return; }
      add_files(files);
      if (location.pathname !== '/') go('/');
    }, { signal });
    return () => end.abort();
  }, []);
  return over ? <div class="drop-sign" aria-hidden="true"><span>{t('drop')}</span></div> : null;
}
