// SPDX-License-Identifier: Apache-2.0
// Tables that leave something open: answered in the page, kept, and read by the same answers ever after.
import assert from 'node:assert/strict';
import { settle } from './pages.mjs';
import { axe_findings, downloaded, shows } from './world.mjs';

/** Targets and two columns of readings, without a word about them. */
const rows = Array.from({ length: 6 }, (_, i) => `${i * 100} ${(i / 10 - 0.5).toFixed(2)} ${(i / 10 + 0.5).toFixed(2)}\n`).join('');
const file = (name, text = rows) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });

async function answer(page, name, unit) {
  const form = page.getByRole('form', { name: `Columns of ${name}` });
  await form.getByLabel('Column 1').selectOption('target');
  await form.getByLabel('Column 2').selectOption('deviation/up');
  await form.getByLabel('Column 3').selectOption('deviation/down');
  await form.getByLabel('Targets in').selectOption(unit);
  await form.getByLabel('Readings in').selectOption('um');
  return form;
}

const entry = (page, name) => page.locator('.previews li', { has: page.locator('.what', { hasText: name }) });

export const answers = {
  async 'a table that leaves something open is answered in the page and read by the answers ever after'(world) {
    const page = await world.page();
    await page.goto('/');
    await settle(page);
    await page.setInputFiles('input[type=file]', [file('short.dat'), file('long.dat')]);
    await shows(page.locator('.previews'), /2 with an open question/);
    const form = page.getByRole('form', { name: 'Columns of short.dat' });
    await shows(form, /Still open: .*unit of the targets/);
    assert.equal(await form.getByRole('button', { name: 'Preview' }).isDisabled(), true);
    assert.deepEqual(await axe_findings(page), []);
    await (await answer(page, 'short.dat', 'mm')).getByRole('button', { name: 'Preview' }).click();
    await shows(entry(page, 'short.dat'), /6 targets × 1 run, 0 to 500 mm/);
    await shows(entry(page, 'short.dat'), /Not a result of the standard: /);
    await (await answer(page, 'long.dat', 'm')).getByRole('button', { name: 'Preview' }).click();
    await shows(entry(page, 'long.dat'), /6 targets × 1 run, 0 to 500000 mm/);
    const { name, bytes } = await downloaded(page, () => entry(page, 'long.dat').getByRole('button', { name: 'Download profile' }).click());
    assert.equal(name, 'long-profile.json');
    assert.equal(JSON.parse(bytes.toString()).target_unit, 'm');
    await page.getByRole('button', { name: 'Keep all 2' }).click();
    await shows(page.locator('.previews'), /2 kept/);

    await world.restart();
    for (const [title, last] of [['short', 500], ['long', 500_000]]) {
      const { tests } = await world.api('GET', `/api/tests?text=${encodeURIComponent(`${title}.dat`)}`);
      assert.equal(tests.length, 1);
      const before = await world.api('GET', `/api/tests/${tests[0].id}`);
      assert.equal(before.readings.targets.at(-1), last);
      await world.api('POST', `/api/tests/${before.id}/versions`, { base_version: 1, title, reason: 'limit', changes: { 'tolerance.E': '5' }, options: before.options });
      const after = await world.api('GET', `/api/tests/${before.id}`);
      assert.deepEqual(after.result.parameters, before.result.parameters);
      assert.deepEqual(after.file.profile, before.file.profile);
      const report = await fetch(`${world.server.address}/api/tests/${before.id}/report.html`);
      assert.equal(report.status, 200);
      await page.goto(`/tests/${before.id}`);
      await shows(page.locator('main'), /Columns were read as stated with the file/);
    }
  },

  async 'what was said of one table is taken for the next, mended, and fits a telephone'(world) {
    const page = await world.page({ width: 390, height: 844 });
    await page.goto('/');
    await settle(page);
    await page.setInputFiles('input[type=file]', [file('one.dat'), file('two.dat')]);
    const form = await answer(page, 'one.dat', 'mm');
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    await form.getByRole('button', { name: 'Preview' }).click();
    await shows(entry(page, 'one.dat'), /read as you said/);
    await page.getByRole('button', { name: 'As for one.dat' }).click();
    await shows(entry(page, 'two.dat'), /read as you said/);
    await entry(page, 'two.dat').getByRole('button', { name: 'Change…' }).click();
    const again = page.getByRole('form', { name: 'Columns of two.dat' });
    assert.equal(await again.getByLabel('Column 3').inputValue(), 'deviation/down');
    await again.getByLabel('Column 3').selectOption('direction');
    await again.getByRole('button', { name: 'Preview' }).click();
    await shows(entry(page, 'two.dat'), /Refused \(line 1/);
    await again.getByLabel('Column 3').selectOption('deviation/down');
    await again.getByRole('button', { name: 'Preview' }).click();
    await shows(entry(page, 'two.dat'), /read as you said/);
    assert.equal(await page.getByRole('button', { name: 'Keep', exact: true }).count(), 2);
  },

  async 'what was said of one table leaves the next its own first row'(world) {
    const page = await world.page();
    await page.goto('/');
    await settle(page);
    await page.setInputFiles('input[type=file]', [file('headed.dat', `Machine seven\nhall two\nread aloud in the early morning\n${rows}`), file('bare.dat')]);
    await (await answer(page, 'headed.dat', 'mm')).getByRole('button', { name: 'Preview' }).click();
    await shows(entry(page, 'headed.dat'), /6 targets × 1 run, 0 to 500 mm/);
    await page.getByRole('button', { name: 'As for headed.dat' }).click();
    await shows(entry(page, 'bare.dat'), /6 targets × 1 run, 0 to 500 mm/);
  },

  async 'a fault in a table of a known format is said before anything is asked'(world) {
    const page = await world.page();
    await page.goto('/');
    await settle(page);
    const lines = ['target_mm,direction,run,deviation_um', ...Array.from({ length: 10 }, (_, k) => `${(k % 5) * 100},${k < 5 ? 'up' : 'down'},1,0.${k}`)];
    lines[4] = lines[4].replace('up', 'upp');
    await page.setInputFiles('input[type=file]', file('fault.csv', `${lines.join('\n')}\n`));
    await shows(entry(page, 'fault.csv'), /Refused \(line 5.*found "upp"/s);
    await entry(page, 'fault.csv').getByRole('button', { name: 'Say what the columns mean' }).click();
    await shows(page.getByRole('form', { name: 'Columns of fault.csv' }), /upp/);
  },
};
