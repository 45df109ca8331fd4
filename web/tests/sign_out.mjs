// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { start_server } from './server.mjs';
import { edit_field } from './steps.mjs';
import { shows } from './world.mjs';

const token = '0123456789abcdef-of-a-test';

async function sign_in(page) {
  await page.getByLabel(/token/i).fill(token);
  await page.getByRole('button', { name: 'Sign in' }).click();
}

const left_behind = (page) => page.evaluate(() => ({ ...sessionStorage, actor: localStorage.getItem('axiometry.actor'), tracking: localStorage.getItem('axiometry.tracking'), volume: localStorage.getItem('axiometry.volume') }));

export const sign_out = {
  async 'who signs out leaves neither name nor unsaved edits in any tab'(world) {
    const id = await world.kept();
    const file = join(world.folder, 'token.txt');
    await writeFile(file, token, { mode: 0o600 });
    await world.server.stop();
    world.server = await start_server(world.program, { store: world.store, flags: ['--token-file', file] });

    const first = await world.page();
    await first.goto('/settings');
    await sign_in(first);
    await first.getByLabel(/name/i).fill('Anna Beispiel');
    const second = await first.context().newPage();
    for (const page of [first, second]) {
      await page.goto(`/tests/${id}`);
      await shows(page.locator('main'), /9\.6/);
      await edit_field(page, /misalignment/i, '2');
      await page.waitForFunction(() => sessionStorage.length === 1);
    }
    assert.match(JSON.stringify(await left_behind(first)), /misalignment.*Anna Beispiel/);

    await first.goto('/tracking');
    await first.getByLabel('Name', { exact: true }).fill('Mill of a customer');
    await first.waitForFunction(() => localStorage.getItem('axiometry.tracking')?.includes('Mill of a customer'));
    await first.goto('/volume');
    await first.waitForFunction(() => localStorage.getItem('axiometry.volume') !== null);
    await first.goto('/');
    await first.setInputFiles('input[type=file]', [{ name: 'chosen.csv', mimeType: 'text/csv', buffer: Buffer.from('a,b\n') }]);
    await shows(first.locator('.previews'), 'chosen.csv');
    await first.getByRole('link', { name: 'Settings' }).click();
    await first.getByRole('button', { name: 'Sign out' }).click();
    for (const page of [first, second]) {
      await page.getByLabel(/token/i).waitFor();
      assert.deepEqual(await left_behind(page), { actor: null, tracking: null, volume: null });
    }

    await sign_in(first);
    await first.getByRole('link', { name: 'Tests', exact: true }).click();
    await shows(first.locator('main'), 'table2');
    assert.equal(await first.getByText('chosen.csv').count(), 0);
    await second.reload();
    await shows(second.locator('main'), /9\.6/);
    assert.deepEqual(await left_behind(second), { actor: null, tracking: null, volume: null });
    await second.goto('/settings');
    assert.equal(await second.getByLabel(/name/i).inputValue(), '');
    const { latest } = await world.api('GET', `/api/tests/${id}`, undefined, { Authorization: `Bearer ${token}` });
    assert.equal(latest, 1);
  },
};
