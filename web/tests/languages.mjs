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

/** Of each language but English: its words for some things, and which of the English words are its own as well. */
const spoken = {
  German: { tag: 'de', locale: 'de-DE', name: 'Deutsch', tests: 'Prüfungen', reversal: /Umkehrspanne/, shared: [] },
  French: { tag: 'fr', locale: 'fr-CH', name: 'Français', tests: 'Essais', reversal: /[Ee]rreur d’inversion/, shared: ['Machines', 'Instruments'] },
};

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

async function is_spoken(world, { tag, locale, reversal, shared }) {
  const paths = (await visited(world)).filter((path) => path !== '/audit');
  const page = await world.page({ locale });
  const left = new Set();
  for (const path of paths) {
    await page.goto(path);
    await settle(page);
    for (const shown of await words_on(page)) {
      const text = own_names.reduce((left, name) => left.replace(name, ''), shown);
      for (const word of english.filter((one) => !shared.includes(one)))
        if (new RegExp(`(^|[^\\p{L}-])${word}($|[^\\p{L}-])`, 'u').test(text)) left.add(`${path}: "${word}" in "${text.slice(0, 90)}"`);
    }
  }
  await page.goto(paths[1]);
  const text = await shows(page.locator('main'), /9,6/);
  assert.doesNotMatch(text, /\b9\.6\b/);
  assert.equal(await page.evaluate(() => document.documentElement.lang), tag);
  const report = await (await fetch(`${world.server.address}/api${paths[1]}/report.html?language=${tag}&decimal=comma`)).text();
  assert.match(report, reversal);
  assert.match(report, /9,6/);
  if (left.size > 0) throw new Error(`${left.size} English texts are left:\n${[...left].join('\n')}`);
}

const tests = {};
for (const [language, how] of Object.entries(spoken))
  tests[`in ${language} no English is left, and numbers have a comma`] = (world) => is_spoken(world, how);

export const languages = {
  ...tests,

  async 'the language is switched in the settings and stays'(world) {
    await world.kept();
    for (const { tag, name, tests: title } of Object.values(spoken)) {
      const page = await world.page();
      await page.goto('/settings');
      const choice = page.locator('select').filter({ has: page.locator('option[value="fr"]') }).first();
      assert.equal(await choice.locator(`option[value="${tag}"]`).textContent(), name);
      await choice.selectOption(tag);
      await shows(page.locator('header'), title);
      await page.goto('/');
      await shows(page.locator('header'), title);
    }
  },
};
