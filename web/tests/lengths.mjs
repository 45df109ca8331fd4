// SPDX-License-Identifier: Apache-2.0
// Lengths captured live: part after part of a plan, watched, cut off and gone on with, and on to the results.
import assert from 'node:assert/strict';
import { small_volume } from './pages.mjs';
import { axe_findings, downloaded, shows, sideways } from './world.mjs';

const parts = (page) => page.locator('.length-parts');
const begin = (page, part) => parts(page).getByRole('button', { name: part });
const stops = (page) => page.locator('.stop-list tbody tr');

/** Chooses the simulator at a speed, in what happens to the beam. */
async function choose(page, speed, preset = 'good') {
  await parts(page).getByLabel('Speed').locator('option').first().waitFor({ state: 'attached' });
  await parts(page).getByLabel('Speed').selectOption(String(speed));
  await parts(page).getByLabel('What happens to the beam').selectOption(preset);
}

async function planned_volume(world, how = {}) {
  const page = await world.page(how);
  await page.goto('/volume');
  await page.locator('svg.chain').waitFor();
  await page.locator('section[aria-labelledby="volume-machine"]').getByLabel('Name', { exact: true }).first().fill('Mill 5');
  await page.getByLabel('Points per station and tool').fill('10');
  await page.getByLabel('Feed').first().fill('20000');
  await page.getByLabel('Rest at a point').fill('2');
  await page.getByRole('button', { name: 'Make the plan' }).click();
  await begin(page, /^Capture: part 1 /).waitFor({ timeout: 60_000 });
  return page;
}

/** Begins a capture of the small volume as a script does; its page. */
async function watched(world, { speed, part = 1, preset = 'good' }, how = {}) {
  const { plan } = await world.api('POST', '/api/volumetric/plan', small_volume);
  const { id } = await world.api('POST', '/api/captures', {
    lengths: { kind: 'volume', plan, part }, source: 'simulator', options: { speed, preset },
  });
  const page = await world.page(how);
  await page.goto(`/captures/${id}`);
  return { page, id };
}

const ended = (page, how = /complete/) => shows(page.locator('.ending'), how, 90_000);

export const lengths = {
  async 'lengths: from the plan of a volume part by part to the errors, without a file'(world) {
    const page = await planned_volume(world);
    const all = await parts(page).locator('tbody tr').count();
    assert.equal(all, 12, 'four stations with three tools');
    await choose(page, 60);
    await begin(page, /^Capture: part 1 /).click();
    await page.waitForURL(/\/captures\/\d+$/);
    await shows(page.locator('h1'), /part 1 \(station /);
    await ended(page);
    await shows(page.locator('.ending'), /10 of 10 lengths are kept/);
    assert.equal(await stops(page).count(), 10);
    const told = await stops(page).locator('td').allInnerTexts();
    assert.ok(told.every((text) => /\d|caught/.test(text)), `a length is missing: ${told}`);

    await begin(page, /^Capture: part 2 /).click();  // the next part, with the same source
    await shows(page.locator('h1'), /part 2 \(station /);
    await ended(page);
    const { plan } = await world.api('GET', `/api${new URL(page.url()).pathname}/plan`);
    for (let part = 3; part <= all; part += 5)
      await Promise.all([0, 1, 2, 3, 4].map((k) => part + k).filter((one) => one <= all).map(async (one) => {
        const { id } = await world.api('POST', '/api/captures', { lengths: { kind: 'volume', plan, part: one }, source: 'simulator', options: { speed: 60 } });
        for (;;) {
          const { state } = await world.api('GET', `/api/captures/${id}`);
          if (state === 'complete') return;
          assert.ok(['waiting', 'running'].includes(state), `part ${one} ${state}`);
          await new Promise((later) => setTimeout(later, 500));
        }
      }));
    await page.reload();
    await shows(parts(page), '12 of 12 parts have lengths');
    await parts(page).getByRole('link', { name: 'Find the errors' }).click();
    await page.waitForURL(/\/volume\?captures=/);
    await shows(page.locator('section[aria-labelledby="volume-found"]'), 'All 21 errors found');
    await shows(page.locator('section[aria-labelledby="volume-lengths"]'), 'simulated, not measured');
    await page.goto('/captures');
    await page.locator('tbody tr').first().waitFor();
    assert.equal(await page.locator('tbody tr').count(), all);
    const table = await downloaded(page, () => page.getByRole('link', { name: '10 of 10 lengths' }).first().click());
    assert.match(table.bytes.toString(), /# Simulated, not measured[\s\S]*station,tool,/);
    const raw = await downloaded(page, () => page.getByRole('link', { name: 'raw recording' }).first().click());
    assert.match(raw.bytes.toString(), /^# Simulated, not measured\ntime_s,length_mm\n/);
  },

  async 'lengths: the expected point, the running length and the points caught are shown while it goes on'(world) {
    const { page } = await watched(world, { speed: 1 });
    await shows(page.locator('.readout .position'), /\d\.\d{3}/);
    await shows(page.locator('.readout .next'), 'point 1');
    await shows(page.locator('.scene'), 'point 1');
    await shows(page.locator('.readout'), /[2-9] of 8/, 60_000);
    await shows(page.locator('.readout .next'), /about −?[\d ]+\.\d mm expected/);
    const due = await page.locator('.stop-list tr.is-shown').innerText();
    assert.match(due, /expected now/);
    assert.ok((await page.locator('.scene svg').innerHTML()).includes('point'), 'the point expected is marked in the picture');
    await page.getByRole('button', { name: 'Stop' }).first().click();
    await page.getByRole('dialog').getByRole('button', { name: 'Stop', exact: true }).click();
    await ended(page, /stopped/);
    await shows(page.locator('.ending'), /of 8 lengths are kept/);
    await shows(page.locator('.ending'), /the recording ended before/);
    await page.locator('.ending').getByRole('button', { name: 'Discard' }).click();
    await page.getByRole('dialog').getByRole('button', { name: 'Discard' }).click();
    await page.waitForURL(/\/captures$/);
    await shows(page.locator('main'), /Nothing is being captured/);
  },

  async 'lengths: a broken beam is told while it goes on, and what is to be known at the end'(world) {
    const { page } = await watched(world, { speed: 60, preset: 'broken-beam' });
    await shows(page.locator('.notice.caution').first(), /Before point \d the beam was broken/, 60_000);
    await ended(page);
    await shows(page.locator('.ending'), /have another dead path/);
    await shows(page.locator('.stop-list'), 'new dead path');
  },

  async 'lengths: a killed program has lost nothing, and the capture goes on'(world) {
    const { page } = await watched(world, { speed: 1 });
    await shows(page.locator('.readout'), /[2-9] of 8/, 60_000);
    await world.server.stop('SIGKILL');
    await world.back();
    await ended(page, /interrupted/);
    await page.locator('.ending').getByRole('button', { name: 'Resume' }).click();
    await ended(page);
    await shows(page.locator('.ending'), /8 of 8 lengths are kept/);
    await world.restart();
    await page.reload();
    await ended(page);
    await shows(page.locator('.ending'), /8 of 8 lengths are kept/);
  },

  async 'lengths: one line of the seven is captured, then all, and they are evaluated'(world) {
    const page = await world.page();
    await page.goto('/tracking');
    await page.locator('.tracking-lines tbody tr').nth(6).waitFor();
    await page.getByLabel('Runs', { exact: true }).fill('1');
    await page.getByLabel('Targets', { exact: true }).fill('5');
    await page.getByLabel(/Feed/).first().fill('20000');
    await begin(page, /^Capture: all 7 lines/).waitFor({ timeout: 20_000 });
    await choose(page, 60);
    await begin(page, /^Capture: measuring line x$/).click();
    await page.waitForURL(/\/captures\/\d+$/);
    await ended(page);
    await shows(page.locator('.ending'), /10 of 10 lengths are kept/);
    await begin(page, /^Capture: all 7 lines/).click();
    await shows(page.locator('h1'), 'all 7 lines');
    await ended(page);
    await shows(page.locator('.ending'), /70 of 70 lengths are kept/);
    await parts(page).getByRole('link', { name: 'Evaluate these lengths' }).click();
    await page.waitForURL(/\/tracking\?captures=/);
    await shows(page.locator('section[aria-labelledby="tracking-lengths"]'), 'simulated, not measured');
    await page.locator('section[aria-labelledby="tracking-lengths"]').getByRole('button', { name: 'Report PDF' }).waitFor({ timeout: 20_000 });
  },

  async 'lengths: a capture is usable without sight or mouse, wide and narrow, dark and light'(world) {
    for (const how of [{ width: 390, theme: 'dark' }, { width: 1280 }]) {
      const { page } = await watched(world, { speed: 60 }, how);
      await ended(page);
      await parts(page).locator('tbody tr').first().waitFor();
      assert.deepEqual(await axe_findings(page), []);
      assert.ok((await sideways(page)) <= 0, 'nothing is wider than the window');
    }
  },
};
