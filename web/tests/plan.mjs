// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { downloaded, shows } from './world.mjs';

export const plan = {
  async 'a plan answers while one types, is saved in versions and gives its program'(world) {
    const page = await world.page();
    await page.goto('/plans/new');
    const targets = page.getByRole('table').locator('tbody tr');
    await shows(page.locator('.figures'), /Targets\s*5/);
    await page.getByLabel('to (mm)').fill('1000');
    await shows(page.locator('.figures'), /Targets\s*5/);
    await page.getByRole('combobox', { name: 'Targets', exact: true }).selectOption('count');
    await page.getByLabel('Number of targets').fill('9');
    await shows(page.locator('.figures'), /Targets\s*9/);
    assert.equal(await targets.count(), 9);
    await page.getByLabel('Runs', { exact: true }).fill('2');
    await shows(page.locator('.outcome'), 'departs from ISO 230-2:2014');
    await page.getByLabel('Runs', { exact: true }).fill('zwei');
    await shows(page.locator('.plan-form'), 'found "zwei", expected a number');
    assert.equal(await targets.count(), 9, 'the last good plan stays');
    await page.getByLabel('Runs', { exact: true }).fill('5');
    await page.getByLabel('Title').fill('Mill X, spring');
    await page.getByRole('button', { name: 'Save', exact: true }).click();
    await page.waitForURL(/\/plans\/\d+$/);
    await shows(page.locator('h1'), 'Mill X, spring');
    await page.getByLabel('Dwell (s)').fill('4');
    await page.getByRole('button', { name: 'Save version 2' }).click();
    await shows(page.locator('main'), /Version 2/);

    await page.getByLabel('Control', { exact: true }).selectOption('linuxcnc');
    await shows(page.locator('.listing'), /G1 X/);
    const program = await downloaded(page, () => page.getByRole('button', { name: /Download/ }).click());
    assert.match(program.name, /\.ngc$/);
    assert.match(program.bytes.toString(), /G4 P4(\.0)?\b/);
    await page.getByLabel('in inches').check();
    await shows(page.locator('.listing'), /G20/);
    const sheet = await downloaded(page, () => page.getByRole('button', { name: 'Plan sheet PDF' }).click());
    assert.equal(sheet.bytes.subarray(0, 5).toString(), '%PDF-');
    const id = Number(new URL(page.url()).pathname.split('/').pop());
    const kept = await world.api('GET', `/api/plans/${id}`);
    assert.equal(kept.version, 2);
    assert.equal(kept.request.dwell_s, 4);
  },

  async 'a plan that two people edit loses nothing of either'(world) {
    const { id } = await world.plan();
    const [mine, theirs] = [await world.page(), await world.page()];
    for (const page of [mine, theirs]) {
      await page.goto(`/plans/${id}`);
      await shows(page.locator('.figures'), /Targets/);
    }
    await theirs.getByLabel('Dwell (s)').fill('6');
    await theirs.getByRole('button', { name: 'Save version 2' }).click();
    await shows(theirs.locator('main'), /Version 2/);
    await mine.getByLabel('Runs', { exact: true }).fill('7');
    await mine.getByRole('button', { name: 'Save version 2' }).click();
    await mine.getByRole('dialog').getByRole('button', { name: /version 3/ }).click();
    await shows(mine.locator('main'), /Version 3/);
    assert.equal((await world.api('GET', `/api/plans/${id}`)).request.runs, 7);
    assert.equal((await world.api('GET', `/api/plans/${id}?version=2`)).request.dwell_s, 6);
  },
};
