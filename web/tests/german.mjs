// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { settle, visited } from './pages.mjs';
import { shows } from './world.mjs';

// Words that only an English text of the page has.
const english = [
  'the', 'and', 'Tests', 'Machines', 'Instruments', 'Capture', 'Settings', 'Targets', 'Runs', 'Feed', 'Overrun', 'Duration', 'Findings',
  'Download', 'Save', 'Edit', 'Cancel', 'Close', 'Copy', 'Uncertainty', 'Repeatability', 'Reversal', 'Accuracy', 'conforms', 'undecided', 'Version of',
  'found', 'expected', 'Measured', 'Received', 'Search', 'History', 'Limits', 'Reading', 'Readings', 'up', 'down', 'Report', 'Issue', 'standard cycle',
  'Misalignment', 'Temperature', 'Inspector', 'not stated', 'clause', 'departure', 'missing', 'note', 'axis', 'with', 'from', 'is', 'of', 'which',
];
// What is no text of the page: names that users and files have.
const own_names = [/Table 2 of ISO 230-2 \(worked example\)/g, /Example Instruments/g, /Simulated axis/g, /X of the mill/g];
const names = '.mono, code, pre, [lang="en"], .listing, .manual, select[aria-label], option[value="en"]';

/** The words on the page, without what users and files are called. */
const words_on = (page) => page.evaluate((skipped) => {
  const copy = document.body.cloneNode(true);
  copy.querySelectorAll(`${skipped}, h1, footer, th[scope="row"] a, iframe, script, style`).forEach((one) => one.remove());
  const shown = [];
  const walk = document.createTreeWalker(copy, NodeFilter.SHOW_TEXT);
  while (walk.nextNode()) shown.push(walk.currentNode.textContent);
  copy.querySelectorAll('[aria-label], [title], [placeholder]').forEach((one) => {
    for (const name of ['aria-label', 'title', 'placeholder']) shown.push(one.getAttribute(name) ?? '');
  });
  return shown.map((text) => text.trim()).filter((text) => text !== '');
}, names);

export const german = {
  async 'in German no English is left, and numbers have a comma'(world) {
    const paths = (await visited(world)).filter((path) => path !== '/audit');
    const page = await world.page({ locale: 'de-DE' });
    const left = new Set();
    for (const path of paths) {
      await page.goto(path);
      await settle(page);
      for (const shown of await words_on(page)) {
        const text = own_names.reduce((left, name) => left.replace(name, ''), shown);
        for (const word of english)
          if (new RegExp(`(^|[^\\p{L}-])${word}($|[^\\p{L}-])`, 'u').test(text)) left.add(`${path}: "${word}" in "${text.slice(0, 90)}"`);
      }
    }
    await page.goto(paths[1]);
    const text = await shows(page.locator('main'), /9,6/);
    assert.doesNotMatch(text, /\b9\.6\b/);
    assert.equal(await page.evaluate(() => document.documentElement.lang), 'de');
    const report = await (await fetch(`${world.server.address}/api${paths[1]}/report.html?language=de&decimal=comma`)).text();
    assert.match(report, /Umkehrspanne/);
    assert.match(report, /9,6/);
    if (left.size > 0) throw new Error(`${left.size} English texts are left:\n${[...left].join('\n')}`);
  },

  async 'the language is switched in the settings and stays'(world) {
    await world.kept();
    const page = await world.page();
    await page.goto('/settings');
    await page.getByLabel(/language/i).first().selectOption('de').catch(() => page.getByText('Deutsch').first().click());
    await shows(page.locator('header'), 'Prüfungen');
    await page.goto('/');
    await shows(page.locator('header'), 'Prüfungen');
  },
};
