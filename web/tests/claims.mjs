// SPDX-License-Identifier: Apache-2.0
// What may be claimed of a result, and what is told beside the parameters.
import assert from 'node:assert/strict';
import { shows } from './world.mjs';

/** A file that says nothing of its test. */
const bare = ['target_mm,direction,run,deviation_um',
  ...['up', 'down'].flatMap((way) => [1, 2, 3, 4, 5].flatMap((run) => [0, 100, 200, 300, 400].map((x) => `${x},${way},${run},${(x / 100 + run) / 10}`)))].join('\n');

export const claims = {
  async 'what speaks against a claim is told in sentences'(world) {
    const { id } = await world.api('POST', '/api/tests', bare, { 'X-File-Name': 'bare.csv' });
    const page = await world.page();
    await page.goto(`/tests/${id}`);
    const list = page.getByRole('list', { name: 'What may be claimed' });
    const against = list.locator('details').first();
    await against.locator('summary').click();
    const { result } = await world.api('GET', `/api/tests/${id}`);
    const { missing } = result.claims.find((claim) => claim.missing.length > 0);
    const points = await against.locator('li').allInnerTexts();
    const begin = (text) => text.slice(0, 12).toLowerCase();
    assert.deepEqual(points.map(begin), missing.map(({ message }) => begin(message)));
  },

  async 'the smaller repeatability is told where it was asked for, as its parameter is'(world) {
    const id = await world.kept();
    const { options, title } = await world.api('GET', `/api/tests/${id}`);
    await world.api('POST', `/api/tests/${id}/versions`, { base_version: 1, title, reason: 'asked for', changes: { 'test.smaller_repeatability': 'yes' }, options });
    for (const [locale, words] of [['en-GB', 'the smaller of R↑ and R↓ is'], ['de-DE', 'der kleinere Wert von R↑ und R↓ ist']]) {
      const page = await world.page({ locale });
      await page.goto(`/tests/${id}`);
      const told = await shows(page.locator('.information'), words);
      const { result, shown } = await world.api('GET', `/api/tests/${id}`, undefined, { 'Accept-Language': locale });
      const { value, unit } = shown.find(({ parameter }) => parameter === result.information.smaller_repeatability.of);
      assert.ok(told.includes(`${words} ${value} ${unit}`), told);
    }
  },
};
