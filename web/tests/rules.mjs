// SPDX-License-Identifier: Apache-2.0
// A kept test by other rules, side by side.
import assert from 'node:assert/strict';
import { settle } from './pages.mjs';
import { axe_findings, downloaded, shows } from './world.mjs';

export const rules = {
  async 'a kept test is told by other rules side by side, with what must not be compared'(world) {
    const id = await world.kept();
    const page = await world.page();
    await page.goto(`/tests/${id}`);
    await page.getByRole('link', { name: 'By other rules' }).click();
    const table = page.locator('table.by-rules');
    const row = (name) => table.locator('tbody tr', { has: page.locator('th', { hasText: new RegExp(`^${name}$`) }) });
    await shows(row('A').locator('td').nth(3), /P\s*10\.6\s*\+1\.0 \(\+11\s%\)/);
    await shows(row('A').locator('td').nth(0), /^9\.6$/);
    assert.deepEqual(await table.locator('th.rule').allInnerTexts().then((all) => all.map((text) => text.split('\n')[0])), ['ISO 230-2:2006', 'JIS B 0182:1993', 'VDI/DGQ 3441']);
    await shows(table.locator('th.rule').nth(1), /in part not checked against the text of the rule/);
    await shows(table.locator('th.rule').nth(2), /not checked against the text of the rule/);
    const warnings = page.locator('section', { has: page.getByRole('heading', { name: 'What must not be compared' }) });
    await shows(warnings, /P after VDI\/DGQ 3441 is 10\.6 µm, but A after ISO 230-2:2014 is 9\.59 µm/);
    assert.deepEqual(await axe_findings(page), []);
    await page.getByLabel('JIS B 0182:1993').uncheck();
    await page.getByLabel('GB/T 38614-2020').check();
    await settle(page);
    assert.match(page.url(), /rules=gb-t-38614-2020%2Ciso-230-2-2006%2Cvdi-dgq-3441/);
    assert.doesNotMatch(await warnings.innerText(), /JIS/);
    await shows(row('other').locator('td').nth(1), /Linearity ↑, largest residual\s*1\.1/);
    await shows(page.locator('table.rule-evidence'), /read in the text of the rule/);
    const { name, bytes } = await downloaded(page, () => page.getByRole('link', { name: 'JSON' }).click());
    assert.equal(name, `test-${id}-by-rules.json`);
    assert.deepEqual(JSON.parse(bytes).rules.map((rule) => rule.id), ['gb-t-38614-2020', 'iso-230-2-2006', 'vdi-dgq-3441']);
  },

  async 'of a rule that the readings do not suffice for it is said why'(world) {
    const id = await world.kept();
    const page = await world.page();
    await page.goto(`/tests/${id}/rules?rules=jis-b-6201`);
    await shows(page.locator('table.by-rules'), /Lost motion\s*–\s*needs seven approaches to both ends and the middle from each direction/);
    await page.goto(`/tests/${id}/rules?rules=vdi-dgq-3441`);
    await page.getByLabel(/with the interval in which each figure lies/).check();
    await shows(page.locator('table.by-rules'), /P\s*10\.6\s*\d+\.\d to \d+\.\d/, 60_000);
    await shows(page.locator('.rules-page'), /Intervals of 95 % are for the figures of this test by the formulas as they are known here/);
    await page.goto(`/tests/${id}/rules?rules=`);
    await shows(page.locator('.rules-page'), /Choose a rule\./);
    assert.equal(await page.locator('table.by-rules').count(), 0);
  },
};
