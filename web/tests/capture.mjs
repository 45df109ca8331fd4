// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { shows } from './world.mjs';

const quick = { dwell_s: 1, runs: 2, targets: 5, feed: 10000 };

async function begun(world, page, { speed: times, ...more }) {
  const { id } = await world.plan('Quick', { ...quick, ...more });
  await page.goto(`/captures/new?plan=${id}`);
  const speed = page.getByLabel('Speed');
  await speed.locator('option').first().waitFor({ state: 'attached' });
  await speed.selectOption(String(times));
  await page.getByLabel('Fault of the axis').selectOption('backlash');
  await page.getByRole('button', { name: 'Start' }).click();
  await page.waitForURL(/\/captures\/\d+$/);
}

export const capture = {
  async 'a capture with the simulator fills in its targets and becomes a test'(world) {
    const page = await world.page();
    await begun(world, page, { speed: 60 });
    await shows(page.locator('.readout'), /\d of 20/);
    await shows(page.locator('.ending'), /complete/, 90_000);
    await shows(page.locator('.readout'), '20 of 20');
    const cells = await page.locator('.filling td.number').allInnerTexts();
    assert.ok(cells.every((text) => /\d/.test(text)), `a cell stayed empty: ${cells}`);
    await page.getByRole('link', { name: 'To the test' }).click();
    await page.waitForURL(/\/tests\/\d+$/);
    const test = await world.api('GET', `/api${new URL(page.url()).pathname}`);
    assert.equal(test.readings.targets.length, 5);
    assert.equal(test.readings.up[0].length, 2);
  },

  async 'a capture that is stopped keeps what has come'(world) {
    const page = await world.page();
    await begun(world, page, { speed: 10, runs: 50 });  // 500 readings, for a minute and a half
    await shows(page.locator('.readout'), /\b(?!500)[1-9]\d+ of 500/, 60_000);
    await page.getByRole('button', { name: 'Stop' }).click();
    const dialog = page.getByRole('dialog');
    await dialog.getByRole('button', { name: 'Go on capturing' }).click();
    await dialog.waitFor({ state: 'hidden' });
    await page.getByRole('button', { name: 'Stop' }).click();
    await dialog.getByRole('button', { name: 'Stop', exact: true }).click();
    await shows(page.locator('.ending'), /stopped/, 20_000);
    await page.getByRole('link', { name: 'To the test' }).waitFor();
  },
};
