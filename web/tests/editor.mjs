// SPDX-License-Identifier: Apache-2.0
// What the page of a test says of its fields: what is missing, what they held before, where limits are set.
import assert from 'node:assert/strict';
import { edit_field } from './steps.mjs';
import { shows } from './world.mjs';

/** Readings, and nothing of the test they were taken in. */
const bare = ['target_mm,direction,run,deviation_um',
  ...[10, 120, 233, 341, 480].flatMap((target) => [1, 2, 3, 4, 5].flatMap((run) => ['up', 'down'].map((way, i) => `${target},${way},${run},${run * 0.1 + i}`))),
].join('\n');

export const editor = {
  async 'a test without limits leads to the first of them, and saving says what was there before and who says so'(world) {
    const id = await world.kept();
    const page = await world.page();
    await page.goto(`/tests/${id}`);
    await page.getByRole('button', { name: 'no tolerance' }).click();
    const limit = page.getByLabel('Tolerance of A, µm', { exact: true });
    await limit.waitFor();
    await page.waitForFunction(() => document.activeElement?.closest('.edit-field') !== null);
    await limit.fill('12');
    await edit_field(page, /Calibration uncertainty of the device.*µm\/m/, '3.4');
    await page.getByRole('button', { name: /^Save as version/ }).click();
    const dialog = page.getByRole('dialog');
    await shows(dialog.locator('.differences'), /Tolerance of A\s+not given\s+12\sµm/);
    await shows(dialog.locator('.differences'), /Calibration uncertainty of the device \(k = 2\)\s+1\sµm\/m\s+3\.4\sµm\/m/);
    await dialog.getByLabel('Reason (required)').fill('Limits agreed');
    await dialog.getByLabel('Name for the audit trail').fill('A. Inspector');
    await dialog.getByRole('button', { name: 'Save', exact: true }).click();
    await dialog.waitFor({ state: 'hidden' });
    const saved = await world.api('GET', `/api/tests/${id}`);
    assert.equal(saved.versions.find((one) => one.version === 2).actor, 'A. Inspector');
  },

  async 'what is missing is offered field by field, at the start and at the end'(world) {
    const { id } = await world.api('POST', '/api/tests', bare, { 'X-File-Name': 'bare.csv' });
    for (const [locale, ends] of [['en-GB', ['Air pressure at the start, kPa', 'Air pressure at the end, kPa']],
                                  ['de-DE', ['Luftdruck am Anfang, kPa', 'Luftdruck am Ende, kPa']]]) {
      const page = await world.page({ locale });
      await page.goto(`/tests/${id}`);
      // Folded once the page knows the fields there are: until then nothing is offered, and there is nothing to unfold.
      await page.locator('.findings-panel details', { has: page.locator('.expected') }).locator('summary').click();
      for (const name of ends) await page.getByRole('button', { name, exact: true }).waitFor();
      assert.equal(await page.locator('.expected').count(), 1, locale);
    }
  },

  async 'a word in place of a number is named as that, not by the key of its field'(world) {
    const id = await world.kept();
    const page = await world.page();
    await page.goto(`/tests/${id}`);
    await edit_field(page, /Calibration uncertainty of the device.*µm\/m/, 'abc');
    await shows(page.locator('.edit-field .fault'), '“abc” is not a number');
  },
};
