// SPDX-License-Identifier: Apache-2.0
// Calibrations in the archive: kept after an evaluation, found again, evaluated anew, compared, withdrawn.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { downloaded, shows } from './world.mjs';

const measured = (name) => readFileSync(fileURLToPath(new URL(`../../tests/transcripts/${name}`, import.meta.url)));
const given = (name, bytes, mimeType = 'application/octet-stream') => ({ name, mimeType, buffer: bytes });

/** What the page of the volume would send. */
async function keep_volume(page, spans, title) {
  const files = ['lengths.csv', 'machine.json'].map((name) => [name, measured(`volumetric.files/${name}`).toString()]);
  return page.evaluate(async ({ files, spans, title }) => {
    const form = new FormData();
    form.append('kind', 'volumetric');
    form.append('options', JSON.stringify({ spans }));
    form.append('about', JSON.stringify({ title, measured_on: '2026-11-20' }));
    for (const [name, text] of files) form.append(name.replace(/\..*/, ''), new File([text], name));
    const answer = await fetch('/api/calibrations', { method: 'POST', body: form });
    return { status: answer.status, id: (await answer.json()).id };
  }, { files, spans, title });
}

async function with_reason(page, button, reason) {
  await page.getByRole('dialog').getByLabel('Reason (required)').fill(reason);
  await page.getByRole('dialog').getByRole('button', { name: button }).click();
}

export const calibrations = {
  async 'calibrations: lines are kept after their evaluation, and found on the page of their machine'(world) {
    await world.api('POST', '/api/machines', { name: 'Mill 5' });
    const page = await world.page();
    await page.goto('/tracking');
    await page.locator('.tracking-lines tbody tr').nth(6).waitFor();
    await page.getByLabel('Use another plan').setInputFiles(given('seven.json', measured('tracking-evaluate.files/seven.json'), 'application/json'));
    await page.locator('section[aria-labelledby=tracking-lengths] input[accept*=csv]').setInputFiles(given('lengths.csv', measured('tracking-evaluate.files/lengths.csv'), 'text/csv'));
    await page.getByRole('button', { name: 'Keep in the archive' }).click();
    await page.getByRole('dialog').getByLabel('Title').fill('Seven lines');
    await page.getByRole('dialog').getByRole('button', { name: 'Keep', exact: true }).click();
    await page.getByRole('link', { name: /Kept as calibration 1/ }).click();
    await shows(page.locator('h1'), 'Seven lines');
    await shows(page.locator('main'), /Mill 5/);
    await shows(page.locator('.results'), /xyz/);
    const file = await downloaded(page, () => page.getByRole('link', { name: 'lengths.csv' }).click());
    assert.deepEqual(file.bytes, measured('tracking-evaluate.files/lengths.csv'), 'byte by byte');
    const report = await downloaded(page, () => page.getByRole('link', { name: 'Report PDF' }).click());
    assert.equal(report.bytes.subarray(0, 5).toString(), '%PDF-');
    await page.goto('/machines/1');
    await shows(page.locator('main'), /Seven lines.*2 lines: A ≤ 10\.\d µm/s);
    await page.goto('/calibrations/1');
    await shows(page.locator('main'), 'Seven lines');
    assert.equal(await page.locator('.calibration-history').count(), 0, 'one point is no course');
    await page.evaluate(async (files) => {
      const form = new FormData();
      form.append('kind', 'lines');
      form.append('about', JSON.stringify({ title: 'A year later', machine: 1, measured_on: '2027-11-20' }));
      for (const [role, text] of Object.entries(files)) form.append(role, new File([text], `${role}.txt`));
      await fetch('/api/calibrations', { method: 'POST', body: form });
    }, { lengths: measured('tracking-evaluate.files/lengths.csv').toString(), plan: measured('tracking-evaluate.files/seven.json').toString() });
    await page.reload();
    await shows(page.locator('.calibration-history'), /Over time\s*A \(x\), µm\s*A \(xyz\), µm/);
    const narrow = await world.page({ width: 390 });
    await narrow.goto('/calibrations');
    await shows(narrow.locator('.list-page'), /A year later\s*Lines \(ISO 230-2\)\s*Mill 5\s*2027-11-20\s*2 lines: A ≤ 10\.\d µm/);
    assert.equal(await narrow.locator('.table-frame').evaluate((box) => box.scrollWidth - box.clientWidth), 0, 'the figures are seen without scrolling');
  },

  async 'calibrations: the 21 errors are listed, evaluated again into a version, compared and withdrawn'(world) {
    const page = await world.page();
    await page.goto('/calibrations');
    await shows(page.locator('main'), 'No calibration is kept yet');
    assert.deepEqual(await keep_volume(page, 4, 'Before'), { status: 201, id: 1 });
    assert.deepEqual(await keep_volume(page, 3, 'After'), { status: 201, id: 2 });
    await page.goto('/calibrations?kind=volumetric');
    await shows(page.locator('main'), /After.*Before.*χ²\/ν/s);
    await page.getByLabel('Search').fill('befo');
    await page.waitForFunction(() => document.querySelectorAll('.list-page tbody tr').length === 1);
    await page.getByRole('link', { name: 'Before' }).click();
    await shows(page.locator('main'), /Rank of unknowns\s*154 \/ 154/);
    await shows(page.locator('main'), /the beam was broken/);
    await page.getByRole('button', { name: 'Evaluate again' }).click();
    await page.getByRole('dialog').getByLabel('Spans').fill('5, 6');
    await shows(page.getByRole('dialog'), 'one, or three');
    await page.getByRole('dialog').getByLabel('Spans').fill('5');
    await with_reason(page, 'Save as version 2', 'finer curves');
    await shows(page.locator('main'), /Options: Spans: 5/);
    await page.getByText('Versions (2)').click();
    await shows(page.locator('.history'), /finer curves/);
    await page.goto('/calibrations/1?version=1');
    await shows(page.locator('main'), 'This is version 1 of 2');
    await page.goto('/calibrations/2');
    await page.getByLabel('Compare with').selectOption({ label: 'Before, 2026-11-20' });
    await shows(page.locator('main'), /EXX[\s\S]*C0Y/);
    await page.getByRole('button', { name: 'Withdraw' }).click();
    await with_reason(page, 'Withdraw', 'wrong machine');
    await page.getByRole('button', { name: 'Reinstate' }).waitFor();
    await page.goto('/calibrations');
    await page.waitForFunction(() => document.querySelectorAll('.list-page tbody tr').length === 1);
    await page.getByLabel('with withdrawn ones').check();
    await page.locator('.list-page tbody tr').nth(1).waitFor();
  },
};
