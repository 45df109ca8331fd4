// SPDX-License-Identifier: Apache-2.0
import { useEffect, useErrorBoundary } from 'preact/hooks';
import { signed_in } from './api/session';
import { Banners, StatusLine } from './banners';
import { DropAnywhere } from './drop_anywhere';
import { place, routed, type Page } from './router';
import { routes } from './pages/routes';
import { t } from './shell_texts';
import { SignIn } from './sign_in';

const sections = [
  ['/', 'tests', ['/tests', '/compare']],
  ['/machines', 'machines', ['/machines', '/axes']],
  ['/instruments', 'instruments', ['/instruments']],
  ['/plans', 'plans', ['/plans']],
  ['/captures', 'capture', ['/captures', '/dynamic']],
  ['/tracking', 'tracking', ['/tracking']],
  ['/volume', 'volume', ['/volume']],
  ['/calibrations', 'calibrations', ['/calibrations']],
  ['/compensations', 'tables', ['/compensations', '/tables']],
  ['/settings', 'settings', ['/settings', '/audit']],
] as const;

export function App() {
  const path = place.value.path;
  const found = routed(routes, path);
  use_title_of_heading();
  use_focus_on_arrival(path);
  useEffect(() => document.querySelector('.bar nav [aria-current]')?.scrollIntoView({ block: 'nearest', inline: 'nearest' }), [path]);
  return (
    <>
      <a class="skip" href="#content" onClick={(event) => { event.preventDefault(); focus_content(); }}>{t('skip')}</a>
      <header class="bar no-print">
        <div>
          <a class="name" href="/">Axiometry</a>
          <nav aria-label={t('sections')}>
            {sections.map(([to, key, prefixes]) => (
              <a key={to} href={to} aria-current={path === to || prefixes.some((prefix) => within(path, prefix)) ? 'page' : undefined}>
                {t(key)}
              </a>
            ))}
          </nav>
        </div>
      </header>
      <Banners />
      <main id="content" tabIndex={-1}>
        {!signed_in.value ? <SignIn /> : found ? <Guarded key={path} page={found.page} parts={found.parts} /> : <Nowhere path={path} />}
      </main>
      <StatusLine />
      <DropAnywhere />
    </>
  );
}

const within = (path: string, prefix: string): boolean => path === prefix || path.startsWith(`${prefix}/`);

/** A page that fails says so, and leaves the rest of the workbench usable. */
function Guarded({ page: Content, parts }: { page: Page; parts: Record<string, string> }) {
  const [error, again] = useErrorBoundary();
  if (error === undefined) return <Content parts={parts} />;
  return (
    <div class="notice bad" role="alert">
      <h1 tabIndex={-1}>{t('broken')}</h1>
      <p>{t('broken_more', { message: error instanceof Error ? error.message : String(error) })}</p>
      <button type="button" onClick={again}>{t('again')}</button>
    </div>
  );
}

function Nowhere({ path }: { path: string }) {
  return (
    <>
      <h1 tabIndex={-1}>{t('no_page')}</h1>
      <p>{t('no_page_more', { path })}</p>
      <p><a href="/">{t('to_tests')}</a></p>
    </>
  );
}

function focus_content(): void {
  const content = document.getElementById('content');
  (content?.querySelector<HTMLElement>('h1') ?? content)?.focus();
}

/** The window is called as its page's heading, whichever page it is and whenever its heading changes. */
function use_title_of_heading(): void {
  useEffect(() => {
    const main = document.getElementById('content') as HTMLElement;
    const name = () => {
      const heading = main.querySelector('h1')?.textContent?.trim() ?? '';
      const title = heading === '' ? 'Axiometry' : `${heading} – Axiometry`;
      if (document.title !== title) document.title = title;
      if (expecting()) focus_content();
    };
    name();
    const watch = new MutationObserver(name);
    watch.observe(main, { childList: true, subtree: true, characterData: true });
    return () => watch.disconnect();
  }, []);
}

/** After a link was followed the focus is at the new page's heading, as after a page load; not at the first page. */
let arrived = '';
let arrived_at = -Infinity;
function use_focus_on_arrival(path: string): void {
  useEffect(() => {
    if (arrived !== '' && arrived !== path) { arrived_at = performance.now(); focus_content(); }
    arrived = path;
  }, [path]);
  useEffect(() => {
    const end = new AbortController();
    for (const sign of ['pointerdown', 'keydown'] as const) window.addEventListener(sign, () => { arrived_at = -Infinity; }, { capture: true, signal: end.signal });
    return () => end.abort();
  }, []);
}

/** A page whose heading comes with its data has nothing to focus at first, or loses it; once the user went on, by a press or a key, it is theirs. */
function expecting(): boolean {
  const at = document.activeElement;
  const free = at === null || at === document.body || at.id === 'content';
  return free && performance.now() - arrived_at < 3000 && document.querySelector('#content h1') !== null;
}
