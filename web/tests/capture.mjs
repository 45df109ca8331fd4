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
    await shows(page.locator('.ending'), /stopped/);
    await page.getByRole('link', { name: 'To the test' }).waitFor();
  },

  async 'a running capture is asked for once at a time, however often its tab is looked at again'(world) {
    const page = await world.page();
    await begun(world, page, { speed: 10, runs: 50 });
    await shows(page.locator('.readout'), /[1-9]\d* of 500/, 60_000);
    let [open, most, asked] = [0, 0, 0];
    await page.route(/\/api\/captures\/\d+\?after=/, async (route) => {
      asked += 1;
      most = Math.max(most, ++open);
      await new Promise((later) => setTimeout(later, 300));
      open -= 1;
      await route.continue();
    });
    for (let i = 0; i < 20; i++) {
      await page.evaluate(() => document.dispatchEvent(new Event('visibilitychange')));
      await page.waitForTimeout(100);
    }
    await page.unrouteAll({ behavior: 'ignoreErrors' });
    assert.ok(asked > 2, `asked ${asked} times`);
    assert.equal(most, 1);
  },

  async 'who looks at an interrupted capture sees that somebody else goes on with it'(world) {
    const [one, other] = [await world.page(), await world.page()];
    await begun(world, one, { speed: 10, runs: 50 });
    await shows(one.locator('.readout'), /[1-9]\d* of 500/, 60_000);
    await world.restart();
    await other.goto(new URL(one.url()).pathname);
    await shows(other.locator('.ending'), /interrupted/);
    await shows(one.locator('.ending'), /interrupted/);
    await one.getByRole('button', { name: 'Resume' }).click();
    await other.getByRole('button', { name: 'Stop' }).waitFor();
    const path = `/api${new URL(one.url()).pathname}`;
    await world.api('POST', `${path}/stop`, {});
    const { readings } = await world.api('GET', `${path}?after=0`);
    for (const page of [one, other]) await shows(page.locator('.readout'), `${readings.length} of 500`);
  },
};
