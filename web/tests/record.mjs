// SPDX-License-Identifier: Apache-2.0
// One uncertainty, one verdict, one set of limits: whatever a page states holds on every other one.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { settle } from './pages.mjs';
import { edit_field, save_version } from './steps.mjs';
import { attribute_shows, example, shows } from './world.mjs';

const card = (page, n) => page.locator('.glance').nth(n);
const of_record = (page) => page.getByLabel('Uncertainty of record');

/** The example with other metadata, kept as a test. */
async function kept_with(world, change, name) {
  const test = JSON.parse(await readFile(example, 'utf8'));
  change(test);
  return world.api('POST', '/api/tests', new TextEncoder().encode(JSON.stringify(test)), { 'X-File-Name': name });
}

/** As a file says that whose readings were taken at 25 °C and never corrected. */
const uncorrected = (test) => {
  test.nde.applied = false;
  test.sensors.forEach((sensor) => { sensor.start_C = 25; sensor.end_C = 25; });
  test.tolerance = { E: 20 };
};

/** Limits for the axis of that test, which tests received later take over. */
async function limit_axis(world, id, limits) {
  const { axis } = await world.api('GET', `/api/tests/${id}`);
  const { version, machine, name, kind, notes } = await world.api('GET', `/api/axes/${axis.id}`);
  await world.api('PUT', `/api/axes/${axis.id}`, { base_version: version, reason: 'agreed', machine, name, kind, notes, limits });
  return axis.id;
}

export const record = {
  async 'every card names the method of its uncertainty, and another choice goes into cards, table and list'(world) {
    const id = await world.kept();
    const page = await world.page();
    await page.goto(`/tests/${id}`);
    await shows(card(page, 0), /9\.6\s*± [\d.]+\s*µm\s*Annex A/);
    await shows(page.locator('.parameters thead'), /U Annex A\s*of record/);
    await of_record(page).selectOption('gum');
    await shows(card(page, 0), /± [\d.]+\s*µm\s*GUM/);
    await shows(page.locator('.parameters thead'), /U GUM\s*of record/);
    await shows(page.locator('.parameters thead .compared'), /for comparison[\s\S]*Annex A/);
    await save_version(page, 'GUM agreed');
    const { shown, result } = await world.api('GET', `/api/tests/${id}`);
    assert.equal(result.uncertainty.record.method, 'gum');
    assert.equal(result.uncertainty.record.chosen, true);
    const A = shown.find(({ parameter }) => parameter === 'A');
    await page.goto('/');
    await shows(page.locator('.test-list tbody tr').first(), `±\u2009${A.U}`);
    await shows(page.locator('.test-list .record-note'), 'Uncertainty of record: GUM.');
  },

  async 'Monte Carlo of record is drawn at once, and its interval stands everywhere'(world) {
    await world.kept();
    const { id } = await kept_with(world, () => {}, 'sampled.json');  // other bytes: the same would count once in the trend
    const page = await world.page();
    await page.goto(`/tests/${id}`);
    await of_record(page).selectOption('monte-carlo');
    await shows(card(page, 0), /9\.6\s*µm\s*\([\d.]+ to [\d.]+\)\s*Monte Carlo/, 60_000);
    await save_version(page, 'a distribution is asked for');
    const { shown } = await world.api('GET', `/api/tests/${id}`);
    const A = shown.find(({ parameter }) => parameter === 'A');
    assert.equal(A.U, '');
    assert.equal(A.method, 'monte_carlo');
    await shows(card(page, 0), A.interval);
    await shows(page.locator('.parameters tbody tr').first().locator('.of-record'), A.interval);
    await page.goto('/');
    await shows(page.locator('.test-list .record-note'), 'by its own method');
    await shows(page.locator('.test-list tbody tr').first(), A.interval.replace(' to ', '\u202f…\u2009'));
    await shows(page.locator('.test-list tbody tr').first(), 'uncertainty: Monte Carlo');
    const { axis } = await world.api('GET', `/api/tests/${id}`);
    await page.goto(`/axes/${axis.id}`);
    await shows(page.locator('.trend .by-method').first(), 'Monte Carlo');
    await page.goto(`/compare?tests=${id},${id - 1}`);
    await shows(page.locator('.parameters-table'), /by different methods: Monte Carlo, Annex A/);
  },

  async 'curves without a common stretch are not said to begin where all begin'(world) {
    const first = await world.kept();
    const { id } = await kept_with(world, (test) => { test.series.targets = test.series.targets.map((target) => target + 2000); }, 'elsewhere.json');
    const page = await world.page({ width: 1200, height: 844 });
    await page.goto(`/compare?tests=${first},${id}&datum=start`);
    await shows(page.locator('.chart-panel .notice'), 'no stretch of the axis in common');
    await page.goto(`/compare?tests=${first},${id}`);
    await shows(page.locator('.parameters-table'), 'Difference');
    assert.equal(await page.locator('.chart-panel .notice').count(), 0, 'as measured is as measured');
  },

  async 'intervals in the list leave every verdict in sight'(world) {
    await world.kept();
    await kept_with(world, (test) => { test.uncertainty.method = 'monte-carlo'; }, 'sampled.json');
    for (const locale of ['en-GB', 'de-DE'])
      for (const width of [390, 641, 820, 1024, 1200]) {
        const page = await world.page({ width, height: 844, locale });
        await page.goto('/');
        await settle(page);
        const frame = page.locator('.test-list .table-frame');
        assert.equal(await frame.evaluate((box) => box.scrollWidth - box.clientWidth), 0, `${locale}, ${width} px`);
        await shows(frame.locator('tbody'), /…/);
      }
  },

  async 'an edit that limits one parameter keeps the limits of the axis for others, and says so before it is saved'(world) {
    const axis = await limit_axis(world, await world.kept(), [{ parameter: 'A', value: 8 }, { parameter: 'B', value: 4 }]);
    const id = await world.kept(example, 'limited.json');
    const page = await world.page();
    await page.goto(`/tests/${id}`);
    await shows(card(page, 0), 'limit 8 (axis)');
    await page.getByRole('button', { name: 'Edit', exact: true }).click();
    await page.locator('.edit-group summary', { hasText: 'Tolerances' }).click();
    await edit_field(page, 'Tolerance of A, µm', '20');
    await shows(page.locator('.edit-field.changed'), 'Takes the place of the limit of the axis: 8');
    await shows(card(page, 0), 'limit 20 (entered)');
    await page.getByRole('button', { name: /^Save as version/ }).click();
    const dialog = page.getByRole('dialog');
    const changes = dialog.locator('.limit-changes');
    await shows(changes, /A[^\n]*20 \(entered\) takes the place of 8 \(axis\);\s*does not conform\s*→\s*becomes\s*conforms/);
    await shows(changes, 'Limits that stay: B 4 (axis)');
    await dialog.getByLabel('Reason (required)').fill('A wider limit was agreed');
    await dialog.getByRole('button', { name: 'Save', exact: true }).click();
    await dialog.waitFor({ state: 'hidden' });
    const saved = await world.api('GET', `/api/tests/${id}`);
    const of = (key) => saved.shown.find(({ parameter }) => parameter === key);
    assert.deepEqual([of('A').limit, of('A').source, of('A').verdict], [20, 'entered', 'conforms']);
    assert.deepEqual([of('B').limit, of('B').source, of('B').verdict], [4, 'axis', 'does not conform']);
    assert.equal(saved.verdict, 'does not conform');
    const row = page.locator('.parameters tbody tr');
    await shows(row.first().locator('.origin'), /entered\s*replaces 8 \(axis\)/);
    await shows(row.nth(10).locator('.origin'), 'axis');
    assert.ok(axis > 0);
  },

  async 'an effect that is not corrected withholds the verdict, with the reason, until it is corrected'(world) {
    const { id } = await kept_with(world, uncorrected, 'warm.json');
    const page = await world.page();
    await page.goto(`/tests/${id}`);
    await shows(card(page, 1), /undecided[\s\S]*an effect is not corrected/);
    await shows(page.locator('.withheld-reasons'), /Undecided: E – Thermal expansion, about [\d.]+ µm over the travel, .*neither corrected nor in the uncertainty/);
    await attribute_shows(card(page, 1), 'class', /caution/);
    await page.getByRole('button', { name: 'Correct: Differential thermal expansion' }).click();
    await shows(card(page, 1), /does not conform|conforms/);
    await page.locator('.withheld-reasons').waitFor({ state: 'detached' });
    await shows(page.locator('.edit-bar'), /not saved/);
  },

  async 'a value has the same digits on its card, in the table and at the position that decides it'(world) {
    const id = await world.kept();
    const page = await world.page();
    await page.goto(`/tests/${id}`);
    await settle(page);
    const { shown } = await world.api('GET', `/api/tests/${id}`);
    for (const [parameter, n] of [['R', 2], ['B', 3]]) {
      const { value } = shown.find((row) => row.parameter === parameter);
      await shows(card(page, n).locator('.glance-value'), value);
      const decides = page.locator(`.positions td[title="decides ${parameter}"]`);
      await shows(decides, value);
      assert.equal((await decides.innerText()).replace(/^\u2212/, ''), value);
    }
  },

  async 'a long recording is counted, not written out, and can be cleared'(world) {
    const id = await world.kept();
    const { changes, options } = await world.api('GET', `/api/tests/${id}`);
    const drift = Array.from({ length: 400 }, (_, i) => (Math.sin(i / 9) * 0.4).toFixed(3)).join(' ');
    const recorded = { ...changes, 'uncertainty.drift_recording': drift, 'uncertainty.drift_interval_s': '5' };
    await world.api('POST', `/api/tests/${id}/versions`, { base_version: 1, title: 'recorded', reason: 'drift test', changes: recorded, options });
    const page = await world.page();
    await page.goto(`/tests/${id}`);
    await page.getByRole('button', { name: 'Edit', exact: true }).click();
    await shows(page.locator('.edit-field .recording'), '400 numbers');
    await page.getByRole('button', { name: 'Clear Recording of the environmental variation' }).click();
    await page.locator('.edit-field .recording').waitFor({ state: 'detached' });
  },
};
