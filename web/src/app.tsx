// SPDX-License-Identifier: Apache-2.0
import { use_get } from './api/use';
import type { Health } from './api/types';
import { texts } from './i18n/texts';
import { place, routed } from './router';
import { routes } from './pages/routes';

const t = texts({
  tests: ['Tests', 'Prüfungen'],
  machines: ['Machines', 'Maschinen'],
  instruments: ['Instruments', 'Messmittel'],
  plans: ['Plans', 'Prüfpläne'],
  capture: ['Capture', 'Erfassung'],
  settings: ['Settings', 'Einstellungen'],
  skip: ['To the content', 'Zum Inhalt'],
  nothing: ['There is no such page.', 'Diese Seite gibt es nicht.'],
  read_only: ['read-only', 'nur lesbar'],
});

const sections = [
  ['/', 'tests', ['/tests', '/compare']],
  ['/machines', 'machines', ['/machines', '/axes']],
  ['/instruments', 'instruments', ['/instruments']],
  ['/plans', 'plans', ['/plans']],
  ['/captures', 'capture', ['/captures']],
  ['/settings', 'settings', ['/settings', '/audit']],
] as const;

export function App() {
  const path = place.value.path;
  const health = use_get<Health>('/api/health');
  const found = routed(routes, path);
  return (
    <>
      <a class="skip" href="#content">{t('skip')}</a>
      <header class="bar no-print">
        <div>
          <a class="name" href="/">Axiometry</a>
          <nav>
            {sections.map(([to, key, prefixes]) => (
              <a key={to} href={to} aria-current={path === to || prefixes.some((prefix) => path.startsWith(prefix)) ? 'page' : undefined}>
                {t(key)}
              </a>
            ))}
          </nav>
        </div>
      </header>
      <main id="content">{found ? <found.page parts={found.parts} /> : <p>{t('nothing')}</p>}</main>
      {health.data && (
        <footer class="status no-print">
          <span>Axiometry {health.data.program.version}</span>
          <span>{health.data.store.location}{health.data.store.writable ? '' : ` (${t('read_only')})`}</span>
        </footer>
      )}
    </>
  );
}
