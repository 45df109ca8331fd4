// SPDX-License-Identifier: Apache-2.0
import { axe_findings, sideways } from './world.mjs';
import { settle, visited } from './pages.mjs';

export const accessibility = {};
for (const width of [390, 1280])
  accessibility[`axe finds nothing on any page, light or dark, ${width} px`] = async (world) => {
    const pages = await visited(world);
    const page = await world.page({ width });
    const found = [];
    const grounds = new Set();
    for (const path of pages) {
      await page.goto(path);
      await settle(page);
      for (const colorScheme of ['dark', 'light']) {
        await page.emulateMedia({ colorScheme });
        grounds.add(await page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor));
        for (const finding of await axe_findings(page)) found.push(`${path}, ${colorScheme}: ${finding}`);
      }
      const over = await sideways(page);
      if (over > 0) found.push(`${path}: ${over} px wider than the window`);
      const headings = await page.getByRole('heading', { level: 1 }).count();
      if (headings !== 1) found.push(`${path}: ${headings} headings of the first level`);
    }
    if (grounds.size < 2) found.push(`dark and light have one ground, ${[...grounds]}`);
    if (found.length > 0) throw new Error(found.join('\n'));
  };
