// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { randomBytes } from 'node:crypto';
import { open, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { settle } from './pages.mjs';
import { example, shows } from './world.mjs';

const markup = '<img src=x onerror="window.pwned=1"><script>window.pwned=2</script>"\'><svg onload=window.pwned=3>';

/** The example with markup in every text of its metadata that the program knows. */
async function poisoned(world) {
  const test = JSON.parse(await readFile(example, 'utf8'));
  const { fields } = await world.api('GET', '/api/vocabulary');
  let count = 0;
  for (const { key, type } of fields) {
    const [group, name, ...deeper] = key.split('.');
    if (type !== 'text' || name === undefined || deeper.length > 0 || /date/.test(name)) continue;
    test[group] = { ...test[group], [name]: markup };
    count += 1;
  }
  assert.ok(count >= 10, `found ${count} texts in the vocabulary, expected more`);
  for (const one of test.equipment) for (const name of Object.keys(one)) one[name] = markup;
  return test;
}

async function nothing_ran(world, page) {
  assert.equal(await page.evaluate(() => window.pwned), undefined);
  for (const frame of page.frames()) assert.equal(await frame.evaluate(() => window.pwned).catch(() => undefined), undefined);
  assert.deepEqual(world.dialogs, []);
}

export const wrong_files = {
  async 'files that are no tests are refused with the reason, and nothing is kept'(world) {
    const page = await world.page();
    await page.goto('/');
    await settle(page);
    await page.setInputFiles('input[type=file]', [
      { name: 'empty.json', mimeType: 'application/json', buffer: Buffer.alloc(0) },
      { name: 'noise.bin', mimeType: 'application/octet-stream', buffer: randomBytes(40_000) },
      { name: 'words.csv', mimeType: 'text/csv', buffer: Buffer.from('one;two\nthree;four\n') },
      { name: 'broken.json', mimeType: 'application/json', buffer: Buffer.from('{"format": "axiometry-test/1",\n "targets": [1, 2,, 3]}') },
    ]);
    for (const name of ['empty.json', 'noise.bin', 'words.csv', 'broken.json']) await shows(page.locator('main'), name);
    await shows(page.locator('main'), /expected[\s\S]*expected[\s\S]*expected[\s\S]*expected/);
    assert.equal(await page.getByRole('button', { name: 'Keep', exact: true }).count(), 0);
    assert.equal((await world.api('GET', '/api/tests')).total, 0);
  },

  async 'a file above the limit is refused, and the page goes on'(world) {
    const { limits } = await world.api('GET', '/api/health');
    const path = join(world.folder, 'huge.csv');
    const file = await open(path, 'w');
    await file.truncate(limits.upload_bytes + 1);
    await file.close();
    const page = await world.page();
    await page.goto('/');
    await settle(page);
    await page.setInputFiles('input[type=file]', path);
    await shows(page.getByRole('alert').first(), /expected at most|too large|limit/i, 60_000);
    await page.setInputFiles('input[type=file]', example);
    await page.getByRole('button', { name: 'Keep', exact: true }).click();
    await shows(page.locator('main'), /Kept: iso230-2-table2/);
    assert.equal((await world.api('GET', '/api/tests')).total, 1);
  },

  async 'markup in every text field stays text, on every page and in the report'(world) {
    const bytes = new TextEncoder().encode(JSON.stringify(await poisoned(world)));
    const { id } = await world.api('POST', '/api/tests', bytes, { 'X-File-Name': encodeURIComponent(`${markup}.json`), 'X-Actor': encodeURIComponent(markup) });
    const machine = await world.api('POST', '/api/machines', {
      name: markup, manufacturer: markup, type: markup, serial_number: `${markup} 2`, controller: markup, location: markup, notes: markup,
    });
    await world.api('POST', '/api/axes', { machine: machine.id, name: markup, kind: 'linear', limits: [], notes: markup });
    await world.api('POST', '/api/instruments', {
      role: markup, manufacturer: markup, type: markup, serial_number: `${markup} 2`, certificate: markup, calibrated_on: '', calibration_due: '', inputs: {}, notes: markup,
    });
    const plan = await world.plan(markup, { axis: markup.slice(0, 40), further: { machine: markup } });
    const { axes } = (await world.api('GET', `/api/machines/${machine.id}`));
    const paths = ['/', `/tests/${id}`, `/tests/${id}/report`, `/compare?tests=${id}`, '/machines', `/machines/${machine.id}`,
      ...axes.map((axis) => `/axes/${axis.id}`), '/instruments', '/plans', `/plans/${plan.id}`, '/captures/new', '/audit'];
    const page = await world.page();
    for (const path of paths) {
      await page.goto(path);
      await settle(page);
      await nothing_ran(world, page);
      assert.equal(await page.locator('main img[src="x"], main svg[onload], main script').count(), 0, path);
    }
    await page.goto(`/api/tests/${id}/report.html`);
    await settle(page);
    await nothing_ran(world, page);
    await page.goto('/');
    await settle(page);
    await page.setInputFiles('input[type=file]', { name: `${markup}.json`.replaceAll('/', '-'), mimeType: 'application/json', buffer: Buffer.from(bytes) });
    await page.getByRole('button', { name: /^Keep/ }).first().waitFor();
    await nothing_ran(world, page);
  },
};
