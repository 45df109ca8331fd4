// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { settle } from './pages.mjs';
import { shows } from './world.mjs';

export const offline = {
  async 'a program that is gone is said, and what was typed is still there when it is back'(world) {
    const { id } = await world.plan();
    const page = await world.page();
    await page.goto(`/plans/${id}`);
    await shows(page.locator('.figures'), /Targets/);
    await settle(page);  // what is asked for beside the plan would have a notice of its own
    await world.server.stop('SIGKILL');
    await page.getByLabel('Dwell (s)').fill('8');
    await shows(page.getByRole('alert').first(), 'does not answer');
    assert.equal(await page.locator('.notice').locator('visible=true').count(), 1, 'that the program is gone is said once');
    const unsaved = page.waitForEvent('requestfailed', (request) => request.method() !== 'GET' && request.url().endsWith(`/api/plans/${id}`));
    await page.getByRole('button', { name: 'Save version 2' }).click();
    await unsaved;  // later it would reach the program that is back
    await shows(page.getByRole('alert').first(), 'does not answer');
    await settle(page);
    await world.back();
    await page.getByRole('button', { name: 'Try again' }).first().click();
    assert.equal(await page.getByLabel('Dwell (s)').inputValue(), '8');
    await page.getByRole('button', { name: 'Save version 2' }).click();
    await shows(page.locator('main'), /Version 2/);
    assert.equal((await world.api('GET', `/api/plans/${id}`)).request.dwell_s, 8);
  },

  async 'a list that could not be loaded is loaded when asked again'(world) {
    await world.kept();
    const page = await world.page();
    await page.goto('/plans');
    await page.getByRole('heading', { level: 1 }).waitFor();
    await world.server.stop('SIGKILL');
    await page.getByRole('link', { name: 'Tests', exact: true }).click();
    await shows(page.getByRole('alert').first(), 'does not answer');
    await world.back();
    // It asks by itself too, every two seconds.
    await page.getByRole('button', { name: 'Try again' }).first().click({ timeout: 2_500 }).catch(() => undefined);
    await shows(page.locator('main'), /9\.6/);
  },

  async 'a page whose code does not come says so, and is shown when asked again'(world) {
    const page = await world.page();
    await page.route(/plans-.*\.js$/, (route) => route.abort());
    await page.goto('/');
    await page.getByRole('heading', { level: 1 }).waitFor();
    await page.getByRole('link', { name: 'Plans', exact: true }).click();
    await shows(page.getByRole('alert').first(), 'Another program answers');
    await page.unroute(/plans-.*\.js$/);
    await page.getByRole('button', { name: 'Try again' }).click();
    await shows(page.locator('h1'), 'Test plans');
  },
};
