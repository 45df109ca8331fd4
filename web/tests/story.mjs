// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { edit_field, save_version, shows_version, uncertainties } from './steps.mjs';
import { downloaded, example, is_gone, shows } from './world.mjs';

export const story = {
  async 'from an empty store to an issued report'(world) {
    const page = await world.page();
    await page.goto('/');
    await page.getByRole('heading', { level: 1 }).waitFor();
    await page.setInputFiles('input[type=file]', example);
    await shows(page.locator('main'), /9\.6/);
    assert.equal((await world.api('GET', '/api/tests')).total, 0, 'a preview keeps nothing');
    await page.getByRole('button', { name: 'Keep', exact: true }).click();
    await page.waitForURL(/\/tests\/\d+$/);
    await shows(page.locator('main'), /9\.6/);

    const before = await uncertainties(page);
    await edit_field(page, /misalignment/i, '2');
    for (let i = 0; i < 250 && (await uncertainties(page)) === before; i++) await page.waitForTimeout(40);
    assert.notEqual(await uncertainties(page), before, 'the numbers follow the input');
    await save_version(page, 'misalignment was estimated anew');
    await shows_version(page, 2);

    await page.getByRole('link', { name: 'Report', exact: true }).first().click();
    await page.waitForURL(/\/tests\/\d+\/report/);
    const preview = page.frameLocator('.preview iframe');
    await shows(preview.locator('body'), /9\.6/);
    const pdf = await downloaded(page, () => page.locator('.downloads a', { hasText: 'PDF' }).first().click());
    assert.equal(pdf.bytes.subarray(0, 5).toString(), '%PDF-');
    assert.match(pdf.name, /\.pdf$/);
    const raw = await downloaded(page, () => page.getByRole('link', { name: 'The file as it came' }).click());
    assert.ok(raw.bytes.equals(await readFile(example)), 'the raw file comes back byte for byte');

    await page.getByRole('button', { name: 'Issue', exact: true }).click();
    await shows(page.locator('.issued'), /SHA-256 [0-9a-f]{64}/);
    const id = Number(/tests\/(\d+)/.exec(page.url())[1]);
    const { documents, latest } = await world.api('GET', `/api/tests/${id}`);
    assert.equal(latest, 2);
    assert.equal(documents.filter(({ kind }) => kind === 'report').length, 1);
    await page.getByLabel('Language').selectOption('de');
    await shows(preview.locator('body'), /Umkehrspanne/);
    await page.getByLabel('Decimal sign').selectOption('comma');
    await shows(preview.locator('body'), /9,6/);

    await world.restart();
    await page.goto(`/tests/${id}`);
    await shows_version(page, 2);
  },

  async 'an empty store takes the examples, and offers them no more'(world) {
    const page = await world.page();
    await page.goto('/');
    await page.getByRole('button', { name: 'Load the examples' }).click();
    await shows(page.locator('.test-list'), /iso230-2-table2/);
    await is_gone(page.getByRole('button', { name: 'Load the examples' }));
    const { total } = await world.api('GET', '/api/tests');
    await shows(page.locator('footer'), `${total} tests`);
  },

  async 'a count of one is told in the singular'(world) {
    await world.kept();
    const page = await world.page();
    await page.goto('/machines');
    await shows(page.locator('.page-head'), /^Machines\s+1 machine, 1 needs attention/);
    await shows(page.locator('footer'), /(^|\s)1 test,/);
    await page.goto('/settings');
    await page.getByLabel('Language').selectOption('de');
    await shows(page.locator('main'), /1 Maschine, 1 Achse, .* 0 Prüfpläne, 1 Prüfung,/);
  },

  async 'a file that somebody else keeps meanwhile is said to be there already'(world) {
    const page = await world.page();
    await page.goto('/');
    await page.setInputFiles('input[type=file]', example);
    await shows(page.locator('.previews'), /9\.6/);
    const first = await world.kept();
    await page.getByRole('button', { name: 'Keep', exact: true }).click();
    await shows(page.locator('.previews'), new RegExp(`the same bytes as test ${first}\\b`));
    assert.equal(new URL(page.url()).pathname, '/');
  },
};
