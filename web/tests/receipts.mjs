// SPDX-License-Identifier: Apache-2.0
// Something was kept, and the server has no memory left to show it: its answer is a receipt.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { edit_field, save_version, shows_version } from './steps.mjs';
import { example, shows } from './world.mjs';

const messages = {
  en: 'it was kept, but the server has no memory left to show it: read it again',
  de: 'es wurde aufbewahrt, aber der Server hat keinen Speicher mehr, um es zu zeigen: bitte erneut abrufen',
};

/** From now on that is what comes in place of each answer to a change at that path; it is made all the same. */
const answer_by_receipts = (page, path) => page.route(path, async (route) => {
  if (route.request().method() === 'GET') return route.continue();
  const whole = await route.fetch();
  assert.equal(whole.status(), 201, await whole.text());
  const { id, version } = await whole.json();
  const message = messages[route.request().headers()['accept-language']];
  return route.fulfill({ status: 201, json: { kept: true, id, version, message } });
});

export const receipts = {
  async 'a version that was kept and cannot be shown is told as kept, and is not saved twice'(world) {
    const id = await world.kept();
    const page = await world.page();
    await page.goto(`/tests/${id}`);
    await shows(page.locator('main'), /9\.6/);
    await answer_by_receipts(page, /\/api\/tests\/\d+\/versions/);
    await edit_field(page, /misalignment/i, '2');
    await save_version(page, 'the certificate says so', { conflict: true });
    const told = await shows(page.getByRole('dialog').getByRole('alert'), messages.en);
    assert.match(told, /^Kept, but not shown/);
    assert.equal(await page.evaluate(() => sessionStorage.length), 0, 'nothing is left to save');
    await page.reload();
    await shows_version(page, 2);
    const { latest, changes } = await world.api('GET', `/api/tests/${id}`);
    assert.equal(latest, 2);
    assert.match(Object.keys(changes).join(' '), /misalignment/);
  },

  async 'a machine that was kept and cannot be shown is told as kept, in German too'(world) {
    for (const [locale, add, name, heading, number] of [['en-GB', /^New machine|^Add/, /^Name/, 'Kept, but not shown', 1],
      ['de-DE', /^Neue Maschine|^Maschine anlegen|^Anlegen/, /^Name|^Bezeichnung/, 'Aufbewahrt, aber nicht gezeigt', 2]]) {
      const page = await world.page({ locale });
      await page.goto('/machines');
      await answer_by_receipts(page, '**/api/machines');
      await page.getByRole('button', { name: add }).first().click();
      const dialog = page.getByRole('dialog');
      await dialog.getByLabel(name).first().fill(`Mill ${number}`);
      await dialog.locator('button[type=submit]').click();
      const told = await shows(dialog.getByRole('alert'), messages[locale.slice(0, 2)]);
      assert.ok(told.startsWith(heading), told);
      assert.ok(await dialog.locator('button[type=submit]').isDisabled(), 'it is not added twice');
      await dialog.getByLabel(name).first().press('Enter');
      await dialog.locator('footer button').first().click();
      await shows(page.locator('main'), `Mill ${number}`);
      const { machines } = await world.api('GET', '/api/machines');
      assert.equal(machines.length, number);
    }
  },

  async 'files that were kept and cannot be shown are told as kept, and are not sent twice'(world) {
    const bytes = await readFile(example);
    const page = await world.page();
    await page.goto('/');
    await answer_by_receipts(page, /\/api\/tests$/);
    await page.setInputFiles('input[type=file]', ['one', 'two'].map((name, k) => (
      { name: `${name}.json`, mimeType: 'application/json', buffer: Buffer.concat([bytes, Buffer.from('\n'.repeat(k))]) })));
    await page.getByRole('button', { name: 'Keep all 2' }).click();
    const previews = page.locator('.previews');
    await page.waitForFunction(() => document.querySelectorAll('.previews [role=alert]').length === 2);
    await shows(previews.getByRole('alert').first(), messages.en);
    await shows(previews.locator('h2'), '2 kept');
    assert.equal(await previews.getByRole('button', { name: /^Keep/ }).count(), 0);
    await page.waitForFunction(() => document.querySelectorAll('.test-list tbody tr').length === 2);
    assert.equal((await world.api('GET', '/api/tests')).total, 2);
    await previews.getByRole('link', { name: 'test 2' }).click();
    await page.waitForURL('**/tests/2');
  },

  async 'a plan that was kept and cannot be shown is saved, and a change of it is its next version'(world) {
    const page = await world.page();
    await page.goto('/plans/new');
    await shows(page.locator('.figures'), /Targets\s*5/);
    await page.getByLabel('Title').fill('Mill X, spring');
    await answer_by_receipts(page, '**/api/plans');
    await page.getByRole('button', { name: 'Save', exact: true }).click();
    await shows(page.getByRole('alert'), messages.en);
    const next = page.getByRole('button', { name: 'Save version 2' });
    assert.ok(await next.isDisabled(), 'it is not saved twice');
    await page.getByLabel('Dwell (s)').fill('4');
    await next.click();
    await page.waitForURL(/\/plans\/\d+$/);
    const { plans } = await world.api('GET', '/api/plans');
    assert.deepEqual(plans.map(({ version }) => version), [2]);

    await page.goto('/plans/new');
    await shows(page.locator('.figures'), /Targets\s*5/);
    await page.getByLabel('Title').fill('Mill X, autumn');
    await page.getByRole('button', { name: 'Save', exact: true }).click();
    await shows(page.getByRole('alert'), messages.en);
    await page.getByRole('link', { name: 'Plans' }).first().click();
    await shows(page.locator('main'), 'Mill X, autumn');
    assert.deepEqual(world.dialogs, [], 'nothing is left to save');
  },
};
