// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { example, shows } from './world.mjs';

export const trend = {
  async 'a test without a date stands in the trend where it was received, and says so'(world) {
    await world.kept();
    const undated = JSON.parse(await readFile(example, 'utf8'));
    undated.test = { ...undated.test, date: '' };
    const { id } = await world.api('POST', '/api/tests', new TextEncoder().encode(JSON.stringify(undated)), { 'X-File-Name': 'undated.json' });
    const test = await world.api('GET', `/api/tests/${id}`);
    const { points } = await world.api('GET', `/api/axes/${test.axis.id}/trend?parameters=A&limit=10`);
    const point = points.find((one) => one.test === id);
    assert.equal(point.measured_on, '');
    const day = point.received_at.slice(0, 10);
    const page = await world.page();
    await page.goto(`/axes/${test.axis.id}`);
    await shows(page.locator('.trend tbody tr').first(), `${day} (received)`);
    await page.locator('.chart').focus();
    for (let i = 0; i < 3; i += 1) await page.keyboard.press('ArrowRight');
    await shows(page.locator('.chart .tip .head'), `${day} (received)`);
    await shows(page.locator('.chart [aria-live]'), new RegExp(`^${day}, `));
  },
};
