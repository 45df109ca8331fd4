// SPDX-License-Identifier: Apache-2.0
// The periodic error of a kept test (Annex C).
import assert from 'node:assert/strict';
import { axe_findings, downloaded, shows } from './world.mjs';

/** An amplitude of 2 µm every 10 mm, read upwards in five runs at unequal steps. */
const screw = [
  '# axis.name: X', '# axis.expected_period: 10', 'position_mm,run,direction,deviation_um',
  ...[1, 2, 3, 4, 5].flatMap((run) => Array.from({ length: 40 }, (_, k) => {
    const x = 1.7 * k + 0.4 * (k % 3);
    return `${x.toFixed(3)},${run},up,${(2 * Math.sin((2 * Math.PI * x) / 10) + ((run * 7919 + k * 10473) % 97) / 970).toFixed(4)}`;
  })),
].join('\n');

export const periodic = {
  async 'the periodic error of a kept test is found, or fitted with the period that is known'(world) {
    const kept = await world.api('POST', '/api/tests', screw, { 'X-File-Name': 'screw.csv' });
    const id = kept.id ?? kept.tests[0].id;
    const page = await world.page();
    await page.goto(`/tests/${id}`);
    await page.getByRole('link', { name: 'Periodic error' }).click();
    await shows(page.locator('main'), /Period\s(9\.99|10\.00)\d*\s±\s0\.00\d+\smm:\s[34]\.[09]\d+\s±\s0\.0\d+\sµm\speak to valley/);
    assert.equal(await page.locator('.report-figure img').count(), 4);
    await shows(page.locator('.report-table').first(), /Amplitude\s+A1\s+(1\.99|2\.0)/);
    assert.deepEqual(await axe_findings(page), []);
    await page.getByRole('button', { name: 'Take it' }).click();
    await shows(page.locator('main'), /Period, as given/);
    assert.match(page.url(), /\?period=10$/);
    await page.getByLabel('Known period').fill('-3');
    await shows(page.locator('.fault'), 'a number above 0');
    await page.getByLabel('Known period').fill('');
    await page.getByLabel('Shortest searched').fill('0.00001');
    await shows(page.getByRole('alert'), /periods to search between/);
    assert.equal(await page.locator('.report-panel').count(), 0, 'nothing of another search beside a refusal');
    await page.goto(`/tests/${id}/periodic?period=10`);
    const { name, bytes } = await downloaded(page, () => page.getByRole('link', { name: 'JSON' }).click());
    assert.equal(name, `test-${id}-periodic.json`);
    assert.equal(JSON.parse(bytes).directions[0].period_known, true);
  },

  async 'a test whose targets cannot tell a period says so, in the reader\'s language and on a dark page'(world) {
    const id = await world.kept();
    const page = await world.page({ locale: 'de-DE', theme: 'dark' });
    await page.goto(`/tests/${id}/periodic?period=500`);
    await shows(page.locator('main'), /weicht|Keine signifikante periodische Abweichung/);
    await shows(page.getByRole('heading', { level: 1 }), /Periodische Abweichung der Achse X/);
    assert.equal(await page.locator('.report-figure img.only-print').count(), await page.locator('.report-figure img.no-print').count());
    await page.goto(`/tests/${id}/periodic?period=0.001`);
    await shows(page.getByRole('alert'), /Periode/);
  },
};
