// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { attribute_shows, example, shows } from './world.mjs';

/** A test of one direction of approach, whose A is an A↑ or A↓. */
const one_way = (direction, slope) => [
  '# machine.name: Lathe 9', '# axis.name: X', `# test.date: 2026-02-0${slope}`, 'target_mm,direction,run,deviation_um',
  ...[1, 2, 3, 4, 5].flatMap((run) => [0, 100, 200, 300, 400].map((x) => `${x},${direction},${run},${(slope * x) / 100 + run / 10}`)),
].join('\n');

export const trend = {
  async 'tests of one direction have their figures in the list, the trend and the overview of machines'(world) {
    await world.kept();
    const ids = [];
    for (const [direction, slope] of [['up', 1], ['up', 2], ['down', 3]]) {
      const kept = await world.api('POST', '/api/tests', one_way(direction, slope), { 'X-File-Name': `${direction}_${slope}.csv` });
      ids.push(kept.id ?? kept.tests[0].id);
    }
    const figure = async (id, key) => {
      const { result } = await world.api('GET', `/api/tests/${id}`);
      return result.parameters[key];
    };
    const up = await figure(ids[1], 'A_up');
    assert.ok(up > 8 && await figure(ids[1], 'A') === null, 'the test must be of one direction');
    const page = await world.page();
    await page.goto('/');
    const row = (name) => page.locator('.test-list tbody tr', { hasText: name });
    await shows(row('up_2').locator('td.number').nth(0), new RegExp(`^A↑\\s*${up.toFixed(1).replace('.', '\\.')}`));
    await shows(row('up_2').locator('td.number').nth(2), /^R↑\s*\d/);
    await shows(row('down_3').locator('td.number').nth(1), /^E↓\s*\d/);
    assert.equal((await row('up_2').locator('td.number').nth(3).innerText()).trim(), '–', 'one direction has no reversal');
    const { axis } = await world.api('GET', `/api/tests/${ids[1]}`);
    await page.goto(`/axes/${axis.id}`);
    const heads = page.locator('.trend table thead');
    await shows(heads, /A↑/);
    await shows(heads, /R↓/);
    await shows(page.locator('.trend tbody tr', { hasText: 'up_2' }), new RegExp(up.toFixed(1)));
    await page.goto('/machines');
    const last = await figure(ids[2], 'A_down');
    await shows(page.locator(`a.axis-spark[href="/axes/${axis.id}"] .value`), new RegExp(`A↓\\s*${last.toFixed(1)}`));
    await attribute_shows(page.locator(`a.axis-spark[href="/axes/${axis.id}"]`), 'title', /^X: A↓ \d.*, 1 test/);
  },

  async 'each axis of a machine is due by its own latest test, whatever was measured of the others'(world) {
    const of_axis = (axis, date) => one_way('up', 1).replace('axis.name: X', `axis.name: ${axis}`).replace(/test.date: .*/, `test.date: ${date}`);
    const today = new Date().toISOString().slice(0, 10);
    for (const [axis, date] of [['X', '2019-03-01'], ['X', today], ['Z', '2020-04-17'], ['Y', '2020-04-17']]) await world.api('POST', '/api/tests', of_axis(axis, date), { 'X-File-Name': `${axis}_${date}.csv` });
    const page = await world.page();
    await page.goto('/machines');
    const row = page.locator('.machines tbody tr', { hasText: 'Lathe 9' });
    await shows(row.locator('td .tag.caution').first(), /^[ZY], [ZY] overdue since 2021-04-17$/);
    assert.equal(await row.locator('td .tag.caution').count(), 1, 'X was tested today');
  },

  async 'compared tests say what their U means'(world) {
    const ids = [await world.kept(), await world.kept(example, 'again.json')];
    const page = await world.page();
    await page.goto(`/compare?tests=${ids.join(',')}`);
    await shows(page.locator('.side-by-side .by-method').first(), 'Annex A, k = 2');
    await page.goto(`/tests/${ids[0]}`);
    await shows(page.locator('.parameters-panel .foot').first(), 'about 95 % (k = 2)');
  },

  async 'a file that was kept twice counts once in the trend, and says so'(world) {
    const id = await world.kept();
    const again = await world.kept(example, 'again.json');
    const { axis } = await world.api('GET', `/api/tests/${id}`);
    const page = await world.page();
    await page.goto(`/axes/${axis.id}`);
    await shows(page.locator('.trend tbody'), `the same bytes are kept as test ${again} too, and count once`);
    assert.equal(await page.locator('.trend tbody tr').count(), 1);
    await page.goto('/machines');
    await shows(page.locator('a.axis-spark'), 'X');
    await attribute_shows(page.locator(`a.axis-spark[href="/axes/${axis.id}"]`), 'title', /, 1 test/);
  },

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
