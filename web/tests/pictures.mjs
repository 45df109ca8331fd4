// SPDX-License-Identifier: Apache-2.0
// node web/tests/pictures.mjs PROGRAM FOLDER [WORD…]: every page at three widths, in both themes and every language, to be
// looked at by people.
import { mkdir } from 'node:fs/promises';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { settle, visited } from './pages.mjs';
import { World } from './world.mjs';

const [program, folder, ...words] = process.argv.slice(2);
if (!program || !folder) {
  console.error('expected: node web/tests/pictures.mjs PROGRAM FOLDER [WORD…]');
  process.exit(2);
}
const views = [
  { width: 390, height: 844 }, { width: 820, height: 1180 }, { width: 1440, height: 900 },
].flatMap((size) => ['en-GB', 'de-DE', 'fr-FR'].flatMap((locale) => ['light', 'dark'].map((theme) => ({ ...size, theme, locale }))));

await mkdir(folder, { recursive: true });
const browser = await chromium.launch({ executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium', args: process.getuid() === 0 ? ['--no-sandbox'] : [] });
const world = await World.make(program, browser);
let count = 0;
try {
  const empty = (await world.api('GET', '/api/tests')).total === 0 ? ['/'] : [];
  for (const stage of ['empty', 'full']) {
    const paths = stage === 'empty' ? empty : await visited(world);
    for (const view of views) {
      const page = await world.page(view);
      for (const path of paths) {
        const name = `${stage === 'empty' ? 'empty' : path.replace(/[?=,]/g, '-').replace(/^\/|\/$/g, '').replace(/\//g, '-') || 'tests'}`;
        if (words.length > 0 && !words.some((word) => name.includes(word))) continue;
        await page.goto(path);
        await settle(page);
        await page.screenshot({ path: join(folder, `${name}-${view.width}-${view.theme}-${view.locale.slice(0, 2)}.png`), fullPage: true });
        count += 1;
      }
      await page.context().close();
      world.contexts.pop();
    }
  }
} finally {
  await world.end();
  await browser.close();
}
console.log(`${count} pictures in ${folder}`);
for (const fault of new Set(world.faults)) console.log(`the page reported: ${fault}`);
