// SPDX-License-Identifier: Apache-2.0
// What must fit: on a tablet, on a phone in the longer language, on paper.
import assert from 'node:assert/strict';
import { fileURLToPath } from 'node:url';
import { settle } from './pages.mjs';
import { example, shows, sideways } from './world.mjs';

const bare = fileURLToPath(new URL('../../examples/simulated-backlash.json', import.meta.url));
/** Readings in one direction of approach, which are marked in the list. */
const one_way = ['target_mm,direction,run,deviation_um', ...[1, 2, 3, 4, 5].flatMap((run) => [0, 100, 200, 300, 400].map((x) => `${x},up,${run},${run + x / 100}`))].join('\n');

export const layout = {
  async 'on a tablet the list of tests shows every column'(world) {
    await world.kept();
    for (const locale of ['en-GB', 'de-DE']) {
      const page = await world.page({ width: 1024, height: 768, locale });
      await page.goto('/');
      await settle(page);
      const hidden = await page.locator('.test-list .table-frame').evaluate((frame) => frame.scrollWidth - frame.clientWidth);
      assert.equal(hidden, 0, `${locale}: ${hidden} px of the list are out of sight`);
    }
  },

  async 'on a phone the pages stand in one row, and nothing is wider than the window'(world) {
    const test = await world.kept(bare, 'backlash.json');
    for (const locale of ['en-GB', 'de-DE']) {
      const page = await world.page({ width: 390, height: 844, locale });
      await page.goto(`/tests/${test}`);
      await settle(page);
      const found = await page.evaluate(() => ({
        over: document.documentElement.scrollWidth - innerWidth,
        tops: [...document.querySelectorAll('.bar nav a')].map((link) => Math.round(link.getBoundingClientRect().top)),
      }));
      assert.ok(found.over <= 0, `${locale}: ${found.over} px wider than the window`);
      const pages = found.tops.slice(0, -1);
      assert.ok(pages.every((top) => top === pages[0] && top > found.tops.at(-1)), `${locale}: the links stand at ${found.tops.join(', ')}`);
    }
  },

  async 'on a tablet held upright and on a phone every verdict of the list is in sight, with U'(world) {
    await world.kept();
    for (const locale of ['en-GB', 'de-DE'])
      for (const width of [390, 641, 820, 1016]) {
        const page = await world.page({ width, height: 844, locale });
        await page.goto('/');
        await settle(page);
        const frame = page.locator('.test-list .table-frame');
        assert.equal(await frame.evaluate((box) => box.scrollWidth - box.clientWidth), 0, `${locale}, ${width} px`);
        for (const seen of ['tbody .mark svg', 'tbody .plus-minus', 'tbody input'])
          assert.ok(await frame.locator(seen).first().evaluate((one) => one.getBoundingClientRect().width >= 10), `${locale}, ${width} px: ${seen}`);
      }
  },

  async 'a long title is cut after two lines, and no verdict of the list is out of sight because of it'(world) {
    await world.kept(example, `${'Werkzeugmaschine_Halle_2_Achse_X_'.repeat(4)}.json`);
    await world.api('POST', '/api/tests', one_way, { 'X-File-Name': 'one_way.csv' });
    for (const locale of ['en-GB', 'de-DE'])
      for (const width of [390, 900, 1280]) {
        const page = await world.page({ width, height: 844, locale });
        await page.goto('/');
        await settle(page);
        assert.equal(await page.locator('.test-list .table-frame').evaluate((box) => box.scrollWidth - box.clientWidth), 0, `${locale}, ${width} px`);
        const heights = await page.locator('.test-list .title > a').evaluateAll((all) => all.map((one) => one.getBoundingClientRect().height));
        assert.ok(Math.max(...heights) < 45, `${locale}, ${width} px: titles of ${heights} px`);
      }
  },

  async 'a name without a blank, longer than the window, stands within it'(world) {
    const name = 'W'.repeat(150);
    const { id } = await world.api('POST', '/api/machines', { name, location: name });
    for (const width of [390, 1280]) {
      const page = await world.page({ width });
      for (const path of [`/machines/${id}`, '/machines']) {
        await page.goto(path);
        await shows(page.locator('main'), name);
        assert.ok((await sideways(page)) <= 0, `${width} px: ${path} is wider than the window`);
      }
      const hidden = await page.locator('.machines .table-frame').evaluate((frame) => frame.scrollWidth - frame.clientWidth);
      assert.ok(hidden <= 0, `${width} px: ${hidden} px of the list are out of sight`);
    }
  },

  async 'the fields of the editor and the figures of a test stay within their panels'(world) {
    const id = await world.kept();
    for (const locale of ['en-GB', 'de-DE'])
      for (const width of [390, 820, 1440]) {
        const page = await world.page({ width, height: 900, locale });
        await page.goto(`/tests/${id}`);
        await page.getByRole('button', { name: /^(Edit|Bearbeiten)$/ }).click();
        await page.locator('.edit-field').first().waitFor();
        const over = await page.evaluate(() => [...document.querySelectorAll('.edit-panel, .glance')]
          .filter((one) => one.scrollWidth > one.clientWidth).map((one) => `${one.className} ${one.scrollWidth} > ${one.clientWidth}`));
        assert.deepEqual(over, [], `${locale}, ${width} px`);
      }
  },

  async 'a capture that runs fits the screen with what fills in, and a figure that cannot be given yet is a dash'(world) {
    const { id: plan } = await world.plan('Quick', { dwell_s: 1, runs: 40, targets: 5, feed: 10000, to: 4000 });
    const { id } = await world.api('POST', '/api/captures', { plan, source: 'simulator', layout: '', options: { speed: '10', preset: 'good', seed: '1' } });
    const pages = [];
    for (const locale of ['en-GB', 'de-DE'])
      for (const width of [390, 820, 1024, 1600]) pages.push([`${locale}, ${width} px`, await world.page({ width, height: 844, locale })]);
    for (const [, page] of pages) await page.goto(`/captures/${id}`);
    for (const done of [/\b[1-9]\d* (of|von) 400/, /\b[1-9]\d+ (of|von) 400/])
      for (const [name, page] of pages) {
        await shows(page.locator('.readout'), done, 60_000);
        const outside = await page.evaluate(() => [...document.querySelectorAll('.readout *, .so-far *, h1')]
          .filter((one) => one.getBoundingClientRect().right > one.closest('.panel, main').getBoundingClientRect().right + 1)
          .map((one) => one.className || one.tagName));
        assert.deepEqual(outside, [], name);
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), name);
        const due_in_sight = await page.evaluate(() => {
          const due = document.querySelector('.filling td.due')?.getBoundingClientRect();
          const frame = document.querySelector('.filling .table-frame').getBoundingClientRect();
          return !due || (due.left >= frame.left && due.right <= frame.right);
        });
        assert.ok(due_in_sight, `${name}: what fills in is out of sight`);
        const figures = await page.locator('.so-far dd').evaluateAll((all) => all.map((one) => one.firstChild.textContent.trim()));
        assert.ok(figures.every((text) => /^(–|[\d.,\u2212]+)$/.test(text)), `${name}: ${figures}`);
      }
  },

  async 'on paper a chart is whole and drawn for white, and the figure of the report is there'(world) {
    const test = await world.kept();
    const page = await world.page({ width: 1400, theme: 'dark' });
    await page.goto(`/tests/${test}`);
    await settle(page);
    await page.waitForFunction(() => document.querySelector('img.library-figure')?.complete);
    await page.setViewportSize({ width: 700, height: 1000 });
    await page.emulateMedia({ media: 'print' });
    await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
    const found = await page.evaluate(() => {
      const chart = document.querySelector('.chart');
      return {
        theme: document.documentElement.dataset.theme,
        over: Math.ceil(chart.querySelector('canvas').getBoundingClientRect().right - chart.getBoundingClientRect().right),
      };
    });
    assert.equal(found.theme, 'light');
    assert.ok(found.over <= 0, `the chart is ${found.over} px wider than its place`);
  },

  async 'on paper a plan is its figure for white, its whole program and no form, with nothing fetched meanwhile'(world) {
    const { id } = await world.plan();
    const page = await world.page({ theme: 'dark' });
    await page.goto(`/plans/${id}`);
    await shows(page.locator('.listing'), /G1 X/);
    const on_paper = page.locator('.drawn.only-print');
    await on_paper.waitFor({ state: 'attached' });
    assert.ok(!(await on_paper.isVisible()), 'the figure for paper is on the screen');
    // The pages that come once this one is shown, however slowly.
    await page.waitForFunction(() => performance.getEntriesByName('all-pages-loaded').length > 0);
    const fetched = [];
    page.on('request', (request) => fetched.push(request.url()));
    await page.emulateMedia({ media: 'print' });
    await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
    await settle(page);
    assert.deepEqual(fetched.filter((url) => !url.startsWith('data:')), []);
    assert.deepEqual(await page.locator('.drawn').evaluateAll((all) => all.map((one) => one.checkVisibility())), [false, true]);
    for (const gone of ['.plan-form', 'main button', 'main input']) assert.equal(await page.locator(gone).locator('visible=true').count(), 0, gone);
    const cut = await page.locator('.listing').evaluate((box) => box.scrollHeight - box.clientHeight);
    assert.ok(cut <= 0, `${cut} px of the program are not on the paper`);
  },

  async 'on a phone three tests are compared without scrolling sideways, differences below the values'(world) {
    const ids = [await world.kept(), await world.kept(bare, 'bare.json'), await world.kept(example, 'again.json')];
    const page = await world.page({ width: 390, height: 844 });
    await page.goto(`/compare?tests=${ids.join(',')}`);
    const table = page.locator('.side-by-side');
    await page.waitForFunction(() => document.querySelectorAll('.side-by-side tbody tr:first-child td').length === 3);
    const frame = page.locator('.table-frame', { has: table });
    assert.equal(await frame.evaluate((box) => box.scrollWidth - box.clientWidth), 0);
    await page.setViewportSize({ width: 900, height: 844 });
    await page.waitForFunction(() => document.querySelectorAll('.side-by-side tbody tr:first-child td').length === 5);
    // The names of the curves stand beside the chart or right below it, and the table below both.
    for (const width of [390, 900, 1100, 1600]) {
      await page.setViewportSize({ width, height: 844 });
      const [chart, names, parameters] = await page.locator('.curves, .chosen, .parameters-table').evaluateAll((all) =>
        all.map((one) => one.getBoundingClientRect()).map(({ top, bottom }) => ({ top, bottom })));
      assert.ok(width < 1100 ? names.top >= chart.bottom : names.top === chart.top, `${width} px: names at ${names.top}`);
      assert.ok(parameters.top >= chart.bottom && parameters.top >= names.bottom, `${width} px: parameters at ${parameters.top}`);
    }
  },
};
