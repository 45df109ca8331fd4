// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { edit_field, save_version, shows_version } from './steps.mjs';
import { example, shows } from './world.mjs';

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

  async 'two people change the limits of an axis: what one did not touch stays as the other left it, and what stands over it is told'(world) {
    const { name } = JSON.parse(await readFile(example)).machine;
    const machine = await world.api('POST', '/api/machines', { name });
    const limit = (parameter, value) => ({ parameter, value });
    const x = { machine: machine.id, name: 'X', kind: 'linear', notes: '' };
    const axis = await world.api('POST', '/api/axes', { ...x, limits: [limit('A', 12), limit('B', 5)] });
    await world.kept();
    const page = await world.page();
    await page.goto(`/machines/${machine.id}`);
    await page.getByRole('button', { name: 'Limits…' }).click();
    const dialog = page.getByRole('dialog');
    await dialog.getByLabel('E', { exact: true }).fill('9');
    await world.api('PUT', `/api/axes/${axis.id}`, { ...x, limits: [limit('A', 6), limit('B', 5)], base_version: 1, reason: 'agreed' });
    await dialog.getByRole('button', { name: /save/i }).click();
    await page.getByRole('button', { name: 'Keep mine as version 3' }).click();
    await dialog.first().waitFor({ state: 'hidden' });
    const kept = await world.api('GET', `/api/axes/${axis.id}`);
    assert.equal(kept.version, 3);
    assert.deepEqual(Object.fromEntries(kept.limits.map((one) => [one.parameter, one.value])), { A: 6, B: 5, E: 9 });
    await shows(page.locator('dd.latest'), /X over the limit of today/);
    await page.goto('/machines');
    await shows(page.locator('main'), /X over the limit of today/);
  },
};
