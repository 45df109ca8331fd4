// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { settle } from './pages.mjs';
import { shows } from './world.mjs';

export const audit = {
  async 'the audit trail names what an entry tells in the language of the page'(world) {
    await world.kept();
    const page = await world.page({ locale: 'de-DE' });
    await page.goto('/audit');
    assert.doesNotMatch(await shows(page.locator('.audit'), /Datei table2\.json[\s\S]*Bytes \d+/), /\b(sha256|content|file|size)\b/);
  },

  async 'a hash of the audit trail is whole under the focus, within the window, and is copied whole'(world) {
    await world.kept();
    const { entries } = await world.api('GET', '/api/audit');
    for (const width of [390, 820, 1024, 1440]) {
      const page = await world.page({ width, height: 900 });
      await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
      await page.goto('/audit');
      await settle(page);
      const frame = page.locator('.audit .table-frame');
      assert.equal(await frame.evaluate((box) => box.scrollWidth - box.clientWidth), 0, `${width} px: the table is wider than its frame`);
      const rows = page.locator('.audit tbody tr');
      for (const n of [0, entries.length - 1]) {
        const button = rows.nth(n).locator('.chained button');
        await page.keyboard.press('Tab');   // the browser shows a focus that keys have set
        await button.focus();
        const whole = button.locator('.whole');
        assert.equal(await whole.innerText(), entries[n].sha256);
        const at = await whole.boundingBox();
        const box = await frame.boundingBox();
        assert.ok(at.x >= box.x && at.x + at.width <= box.x + box.width + 1 && at.y >= box.y - 1 && at.y + at.height <= box.y + box.height + 1,
          `${width} px, row ${n}: ${JSON.stringify(at)} is not within ${JSON.stringify(box)}`);
      }
      await rows.nth(0).locator('.chained button').press('Enter');
      await shows(rows.nth(0).locator('.chained'), 'copied');
      assert.equal(await page.evaluate(() => navigator.clipboard.readText()), entries[0].sha256);
    }
  },
};
