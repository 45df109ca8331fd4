// SPDX-License-Identifier: Apache-2.0
// Pages whose code comes when it is first asked for, so that the first one shows at once.
import { useEffect, useState } from 'preact/hooks';
import { ApiError } from './api/client';
import { ask_health, reachable, returned } from './api/session';
import { FailureNotice } from './components/failure';
import type { Page } from './router';
import { t } from './shell_texts';

const loads: (() => Promise<unknown>)[] = [];

/** The page that a module exports under this name; nothing is shown until it has come. */
export function lazy_page<Name extends string>(load: () => Promise<Record<Name, Page>>, name: Name): Page {
  let content: Page | null = null;
  const come = async () => { content = (await load())[name]; };
  loads.push(come);
  return function LazyPage({ parts }) {
    const [, draw] = useState(0);
    const [lost, set_lost] = useState<'no' | 'away' | 'replaced'>('no');
    const back = returned.value;
    useEffect(() => {
      if (content !== null) return;
      void come().then(() => draw((times) => times + 1), async () => { await ask_health(); set_lost(reachable.value ? 'replaced' : 'away'); });
    }, []);
    // A browser does not ask again for code that did not come; and the program that is back may be another.
    const again = async () => { await ask_health(); if (reachable.value) location.reload(); };
    useEffect(() => { if (lost === 'away') void again(); }, [back]);
    if (lost === 'away') return <FailureNotice error={new ApiError('offline', '', 0)} retry={() => void again()} />;
    if (lost === 'replaced') return <FailureNotice error={new ApiError('refused', t('replaced'), 0)} retry={() => location.reload()} />;
    const Content = content;
    return Content === null ? null : <Content parts={parts} />;
  };
}

/** All other pages, one after the other: the program may be gone when they are wanted, or another one by then. */
export async function load_all_pages(): Promise<void> {
  for (const load of loads) await load().catch(() => undefined);
  performance.mark('all-pages-loaded');
}
