// SPDX-License-Identifier: Apache-2.0
// A straightness captured live: what is said at each stop, taken back, kept and evaluated.
import assert from 'node:assert/strict';
import { createServer } from 'node:net';
import { downloaded, shows, sideways } from './world.mjs';
import { start_server } from './server.mjs';

/** An instrument that sends a reading a hundred times a second to whoever connects: 1.5 µm, and a little noise. */
async function instrument(head = 'time_s,straightness_um') {
  const server = createServer((socket) => {
    const began = Date.now();
    let sent = 0;
    socket.write(`${head}\n`);
    const timer = setInterval(() => {
      for (; sent < (Date.now() - began) / 10; sent++) socket.write(`${(sent / 100).toFixed(2)},${(1.5 + 0.01 * Math.sin(sent)).toFixed(4)}\n`);
    }, 20);
    socket.on('error', () => undefined);
    socket.on('close', () => clearInterval(timer));
  });
  await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
  return server;
}

/** The program again, with that instrument as a source. */
async function listening(world, server) {
  const { port } = world.server;
  await world.server.stop();
  const flags = ['--source', `laser=tcp://127.0.0.1:${server.address().port}`];
  world.server = await start_server(world.program, { store: world.store, port, flags });
}

const request = { axis: 'X', kind: 'linear', from: 0, to: 220, positions: [30, 100, 190], cycle: 'unidirectional', runs: 1, feed: 20000, dwell_s: 1, seed: 7, further: { error: 'EYX' } };

export const motion_captures = {
  async 'motion captures: readings are taken and taken back at the stops, and their evaluation opens'(world) {
    const server = await instrument();
    try {
      await listening(world, server);
      await world.api('POST', '/api/plans', { title: 'Straightness of X', axis: null, request });
      const page = await world.page();
      await page.goto('/plans/1');
      await page.getByRole('link', { name: 'Capture with this plan' }).click();
      await shows(page.locator('form'), 'Readings of EYX do not show where the axis stops.');
      await page.getByLabel('Source', { exact: true }).selectOption('laser');
      await page.getByLabel('Positive towards').fill('+Y');
      await page.getByRole('button', { name: 'Start' }).click();
      await page.waitForURL(/\/captures\/\d+$/);
      await shows(page.locator('h1'), 'Readings of EYX');
      await shows(page.locator('.readout .position'), /1\.[45]\d\s*µm/);
      await shows(page.locator('.readout .next'), /1 ↑\s*30\.000 mm/);
      const take = page.getByRole('button', { name: 'Take this reading' });
      await take.click();
      await shows(page.locator('.readout'), '1 of 3');
      await page.getByRole('button', { name: 'Take back the last' }).click();
      await shows(page.locator('.readout'), '0 of 3');
      await shows(page.locator('.event-list'), 'target 1↑ run 1 is due again');
      for (const [n, how] of [[1, 'click'], [2, 'enter'], [3, 'click']]) {
        await page.waitForTimeout(1_500);  // as long as the axis is on its way
        if (how === 'click') await take.click();
        else {
          await page.locator('h1').focus();
          await page.keyboard.press('Enter');
        }
        if (n < 3) await shows(page.locator('.readout'), `${n} of 3`);
      }
      await shows(page.locator('.stop-keys'), 'until then the last reading can be taken back');
      await page.getByRole('button', { name: 'Take back the last' }).click();
      await shows(page.locator('.readout'), '2 of 3');
      await take.click();
      await page.waitForURL(/\/motions\?capture=\d+$/);
      await shows(page.locator('main'), /EYX \d{4}-.*\.csv, \+Y/);
      await shows(page.locator('main'), /Straightness, range of the residuals\s*↑\s*0\.0/);
      await page.goto('/captures');
      await shows(page.locator('main'), /Straightness of X[\s\S]*3 of 3 readings/);
      const raw = await downloaded(page, () => page.getByRole('link', { name: 'raw recording' }).click());
      assert.match(raw.bytes.toString(), /^time_s,straightness_um\n/);
    } finally {
      server.close();
    }
  },

  async 'motion captures: the simulator stands at each target until its reading is taken, and what it made says so'(world) {
    await world.api('POST', '/api/plans', { title: 'Straightness of X', axis: null, request });
    const page = await world.page();
    await page.goto('/captures/new?plan=1');
    await shows(page.locator('form'), 'The readings will be simulated');
    assert.equal(await page.getByLabel('Source', { exact: true }).inputValue(), 'simulator');
    assert.equal(await page.getByLabel('Unit of the stream').count(), 0, 'it says itself what it sends');
    await page.getByLabel('Size of the bow (µm)').fill('8');
    await page.getByLabel('Speed').selectOption('10');
    await page.getByRole('button', { name: 'Start' }).click();
    await page.waitForURL(/\/captures\/\d+$/);
    await shows(page.locator('main'), 'These readings are simulated, not measured. The simulated axis stands at each target');
    for (const [n, position] of [[1, '30'], [2, '100'], [3, '190']]) {
      await shows(page.locator('.readout .simulated-axis'), `The simulated axis stands at ${position}.000 mm`, 30_000);
      await page.getByRole('button', { name: 'Take this reading' }).click();
      if (n < 3) await shows(page.locator('.readout'), `${n} of 3`);
    }
    await page.waitForURL(/\/motions\?capture=\d+$/);
    await shows(page.locator('main'), 'readings that were simulated, expected those of a machine');
    const table = await world.api('GET', '/api/captures');
    assert.equal(table.captures[0].source.kind, 'simulator');
  },

  async 'motion captures: what was chosen for one plan is not asked of another'(world) {
    const server = await instrument();
    try {
      await listening(world, server);
      await world.api('POST', '/api/plans', { title: 'Angles of X', axis: null, request: { ...request, further: { error: 'EAX,EBX' } } });
      await world.api('POST', '/api/plans', { title: 'Straightness of X', axis: null, request });
      const page = await world.page();
      await page.goto('/captures/new?plan=1');
      await page.getByLabel('Source', { exact: true }).selectOption('laser');
      await page.getByLabel('What is read').selectOption('EBX');
      await page.getByLabel('Unit of the stream').selectOption({ label: '″' });
      await page.getByLabel('Measuring instrument').fill('0012');
      await page.getByLabel('Plan').selectOption({ label: 'Straightness of X' });
      await shows(page.locator('form'), 'Readings of EYX do not show where the axis stops.');
      assert.equal(await page.getByLabel('Unit of the stream').inputValue(), '');
      await shows(page.getByLabel('Unit of the stream'), 'µm');
      const [asked] = await Promise.all([page.waitForRequest('**/api/captures'), page.getByRole('button', { name: 'Start' }).click()]);
      assert.deepEqual(asked.postDataJSON().options, { stops: 'keys', equipment: '0012' });
      await page.waitForURL(/\/captures\/\d+$/);
      await shows(page.locator('h1'), 'Readings of EYX');
    } finally {
      server.close();
    }
  },

  async 'motion captures: a refusal names the field that was left empty, in the words of the page'(world) {
    const server = await instrument('time_s,reading');
    try {
      await listening(world, server);
      const { id: plan } = await world.api('POST', '/api/plans', { title: 'Straightness of X', axis: null, request });
      const { id } = await world.api('POST', '/api/captures', { plan, source: 'laser', options: { stops: 'keys' } });
      for (const [locale, field] of [['en-GB', 'unit of the stream'], ['de-DE', 'Einheit des Stroms'], ['fr-FR', 'unité du flux']]) {
        const page = await world.page({ locale });
        await page.goto(`/captures/${id}`);
        assert.doesNotMatch(await shows(page.locator('.ending'), field), /--/);
      }
    } finally {
      server.close();
    }
  },

  async 'motion captures: one that is ended early keeps its readings, and is discarded'(world) {
    const server = await instrument();
    try {
      await listening(world, server);
      const { id: plan } = await world.api('POST', '/api/plans', { title: 'Straightness of X', axis: null, request });
      const { id } = await world.api('POST', '/api/captures', { plan, source: 'laser', options: { stops: 'keys' } });
      const page = await world.page();
      await page.goto(`/captures/${id}`);
      await shows(page.locator('.readout .position'), /µm/);
      const narrow = await world.page({ width: 390, locale: 'de-DE' });
      await narrow.goto(`/captures/${id}`);
      await narrow.getByRole('button', { name: 'Die nächste Zielposition hat keinen Messwert' }).waitFor();
      assert.ok((await sideways(narrow)) <= 0, 'what is said has room on a phone in the longer language');
      await page.getByRole('button', { name: 'The next target has no reading' }).click();
      await shows(page.locator('.readout .next'), /2 ↑/);
      await page.getByRole('button', { name: 'Take this reading' }).click();
      await shows(page.locator('.readout'), '1 of 3');
      await page.getByRole('button', { name: 'Stop' }).first().click();
      await page.getByRole('dialog').getByRole('button', { name: 'Stop', exact: true }).click();
      await shows(page.locator('.ending'), /stopped[\s\S]*1 of 3 readings are kept/);
      await shows(page.locator('.ending'), 'has no reading');
      const keys = await downloaded(page, () => page.getByRole('link', { name: 'What was said' }).click());
      assert.match(keys.bytes.toString(), /,skip\n.*,take\n/s);
      await page.getByRole('button', { name: 'Discard' }).click();
      await page.getByRole('dialog').getByRole('button', { name: 'Discard' }).click();
      await page.waitForURL(/\/captures$/);
      await shows(page.locator('main'), /Nothing is being captured/);
    } finally {
      server.close();
    }
  },
};
