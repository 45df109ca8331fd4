// SPDX-License-Identifier: Apache-2.0
// Pages whose code comes when it is first asked for, so that the first one shows at once.
import { useEffect, useState } from 'preact/hooks';
import type { Page } from './router';

const loads: (() => Promise<unknown>)[] = [];

/** The page that a module exports under this name; nothing is shown until it has come. */
export function lazy_page<Name extends string>(load: () => Promise<Record<Name, Page>>, name: Name): Page {
  let content: Page | null = null;
  const come = async () => { content = (await load())[name]; };
  loads.push(come);
  return function LazyPage({ parts }) {
    const [, draw] = useState(0);
    const [fault, set_fault] = useState<unknown>(null);
    useEffect(() => {
      if (content === null) void come().then(() => draw((times) => times + 1), set_fault);
    }, []);
    if (fault !== null) throw fault;
    const Content = content;
    return Content === null ? null : <Content parts={parts} />;
  };
}

/** All other pages, one after the other: the program may be gone when they are wanted, or another one by then. */
export async function load_all_pages(): Promise<void> {
  for (const load of loads) await load().catch(() => undefined);
}
