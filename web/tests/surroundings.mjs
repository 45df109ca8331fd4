// SPDX-License-Identifier: Apache-2.0
// A log of temperatures dropped on the page of its test: judged, kept with its version, found again.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { downloaded, is_gone, shows } from './world.mjs';

const bytes = readFileSync(fileURLToPath(new URL('../../tests/transcripts/temperatures.files/hall.csv', import.meta.url)));
const panel_of = (page) => page.locator('.surroundings-panel');
const drop = (page, name, buffer) => panel_of(page).locator('input[type=file]').setInputFiles({ name, mimeType: 'text/csv', buffer });

async function save(page, reason) {
  await page.getByRole('button', { name: /^Save as version/ }).click();
  const dialog = page.getByRole('dialog');
  await shows(dialog.locator('.differences'), /temperature log hall\.csv .*2026-03-02T09:00 – 2026-03-02T10:10, … – 22 °C/);
  await dialog.getByLabel('Reason (required)').fill(reason);
  await dialog.getByRole('button', { name: 'Save', exact: true }).click();
  await dialog.waitFor({ state: 'hidden' });
}

export const surroundings = {
  async 'temperatures: a log dropped on the page of a test is judged, kept with its version and drawn'(world) {
    const id = await world.kept();
    const page = await world.page();
    await page.goto(`/tests/${id}`);
    await drop(page, 'hall.csv', bytes);
    await shows(panel_of(page), /Log: hall\.csv/);
    await shows(panel_of(page), /Nobody said when the test was/);
    await panel_of(page).getByLabel('Test began').fill('2026-03-02T09:00');
    await panel_of(page).getByLabel('Test ended').fill('2026-03-02T10:10');
    await panel_of(page).getByLabel('Agreed highest, °C').fill('22');
    await page.keyboard.press('Tab');
    const exceeded = /Highest temperature of the air\s*22\.93 °C\s*at most 22 °C\s*exceeded/;
    await shows(panel_of(page), exceeded);
    // By less than two decimals show.
    await panel_of(page).getByLabel('Agreed highest, °C').fill('22.929');
    await page.keyboard.press('Tab');
    await shows(panel_of(page), /Highest temperature of the air\s*22\.9300 °C\s*at most 22\.929 °C\s*exceeded/);
    await panel_of(page).getByLabel('Agreed highest, °C').fill('22');
    await page.keyboard.press('Tab');
    await shows(panel_of(page), exceeded);
    await shows(panel_of(page), /Gradient over the machine\s*0\.82 °C\s*–?\s*no limit agreed/);
    await shows(page.locator('.findings-panel'), /highest temperature of the air: 22\.93 °C, expected at most 22 °C as agreed/);
    await save(page, 'Temperatures of the hall');
    await shows(page.locator('.archive-panel', { hasText: 'Documents' }), 'hall.csv');
    await page.reload();
    await shows(panel_of(page), /exceeded/);
    const drawn = panel_of(page).locator('img.library-figure');
    await drawn.waitFor();
    await page.waitForFunction((img) => img.complete && img.naturalWidth > 0, await drawn.elementHandle());
    const test = await world.api('GET', `/api/tests/${id}`);
    assert.equal(test.options.temperatures.highest_C, 22);
    assert.equal(test.result.environment.exceeded, true);
    assert.ok(test.result.findings.some(({ id }) => id === 'environment-highest-exceeded'));
    const kept = await downloaded(page, () => page.getByRole('link', { name: 'hall.csv' }).click());
    assert.deepEqual(kept.bytes, bytes, 'byte by byte');
    // The version before has no log, and knows nothing of it.
    const first = await world.api('GET', `/api/tests/${id}?version=1`);
    assert.equal(first.options.temperatures, undefined);
    assert.equal(first.result.environment, undefined);
  },

  async 'temperatures: a sensor that takes no part is judged no more, until somebody says otherwise'(world) {
    const id = await world.kept();
    const page = await world.page();
    await page.goto(`/tests/${id}`);
    await drop(page, 'hall.csv', bytes);
    await panel_of(page).getByLabel('Test began').fill('2026-03-02T09:00');
    await panel_of(page).getByLabel('Test ended').fill('2026-03-02T10:10');
    await page.keyboard.press('Tab');
    await shows(panel_of(page), /Highest temperature of the air\s*22\.93 °C/);
    const air = panel_of(page).getByLabel(/^Sensor Luft.* is of$/);
    await air.selectOption('none');
    await shows(panel_of(page), /Highest temperature of the air\s*(?!22)\S/);
    await is_gone(panel_of(page).getByText('22.93 °C'));
    await air.selectOption('air');
    await shows(panel_of(page), /Highest temperature of the air\s*22\.93 °C/);
  },

  async 'temperatures: sensors whose names tell no role are listed to be given one'(world) {
    const id = await world.kept();
    const page = await world.page();
    await page.goto(`/tests/${id}`);
    await drop(page, 'oil.csv', Buffer.from('time;Oil [C];KSS [C]\n2026-03-02 09:00;20;21\n2026-03-02 09:10;20.5;21\n'));
    await shows(page.locator('main'), /expected one of "Oil", "KSS" to be stated as such/);
    await panel_of(page).getByLabel('Sensor Oil is of').selectOption('air');
    await shows(panel_of(page), /Highest temperature of the air\s*20\.50 °C/);
    assert.equal(await panel_of(page).getByLabel('Sensor KSS is of').inputValue(), '');
  },

  async 'temperatures: what is no log is told, and the test goes on without it'(world) {
    const id = await world.kept();
    const page = await world.page();
    await page.goto(`/tests/${id}`);
    await drop(page, 'words.csv', Buffer.from('these are\nno temperatures\n'));
    await shows(page.locator('main'), /expected a temperature log/);
    await panel_of(page).getByRole('button', { name: 'Without the log' }).click();
    await shows(panel_of(page), 'Add a temperature log');
    await is_gone(page.locator('main').getByText(/expected a temperature log/));
    assert.equal((await world.api('GET', `/api/tests/${id}`)).versions.length, 1);
  },
};
