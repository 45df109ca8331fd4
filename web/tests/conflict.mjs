// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { edit_field, save_version, shows_version } from './steps.mjs';
import { shows } from './world.mjs';

export const conflict = {
  async 'two tabs edit the same test: the second is told, and nothing of either is lost'(world) {
    const id = await world.kept();
    const [first, second] = [await world.page(), await world.page()];
    for (const page of [first, second]) {
      await page.goto(`/tests/${id}`);
      await shows(page.locator('main'), /9\.6/);
    }
    await edit_field(first, /misalignment/i, '2');
    await edit_field(second, /environmental/i, '5');
    await save_version(first, 'the certificate says so');
    await shows_version(first, 2);
    await save_version(second, 'measured overnight', { conflict: true });
    await shows(second.getByRole('dialog'), /version 2|somebody/i);
    const kept = await world.api('GET', `/api/tests/${id}`);
    assert.equal(kept.latest, 2, 'the conflict made no version');
    await second.getByRole('dialog').getByRole('button', { name: /my changes to version 2|mine/i }).first().click();
    await save_version(second, 'measured overnight');
    await shows_version(second, 3);
    const { changes } = await world.api('GET', `/api/tests/${id}`);
    const keys = Object.keys(changes).join(' ');
    assert.match(keys, /misalignment/);
    assert.match(keys, /environment/);
  },
};
