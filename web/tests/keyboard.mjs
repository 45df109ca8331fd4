// SPDX-License-Identifier: Apache-2.0
// The same way once more with nothing but Tab, Enter, Space, arrows and letters. The mouse is never moved.
import assert from 'node:assert/strict';
import { shows_version } from './steps.mjs';
import { downloaded, example, shows } from './world.mjs';

/** What has the focus: its name as a screen reader says it, and whether its focus can be seen. */
const focused = (page) => page.evaluate(() => {
  const one = document.activeElement;
  const style = getComputedStyle(one);
  const labels = [...(one.labels ?? [])].map((label) => label.textContent).join(' ');
  const named = (one.getAttribute('aria-labelledby') ?? '').split(' ').map((id) => document.getElementById(id)?.textContent ?? '').join(' ');
  const own = one.matches('input, select, textarea') ? '' : one.textContent;
  const outlined = style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 1;
  return {
    name: (one.getAttribute('aria-label') || named.trim() || labels || own || one.getAttribute('title') || '').trim().replace(/\s+/g, ' '),
    tag: one.tagName.toLowerCase(), visible: outlined || style.boxShadow !== 'none' || one === document.body || one.type === 'file',
  };
});

/** Presses Tab until the focus is on that; every stop on the way must be visible. */
async function tab_to(page, name, tags) {
  const passed = [];
  for (let i = 0; i < 250; i++) {
    await page.keyboard.press('Tab');
    const now = await focused(page);
    assert.ok(now.visible, `the focus on ${now.tag} "${now.name.slice(0, 60)}" cannot be seen`);
    passed.push(`${now.tag}:${now.name.slice(0, 30)}`);
    if (name.test(now.name) && (!tags || tags.includes(now.tag))) return;
  }
  throw new Error(`Tab never came to ${name}; it passed ${[...new Set(passed)].join(' | ')}`);
}

export const keyboard = {
  async 'by keyboard only: drop, keep, edit, save, report, issue'(world) {
    const page = await world.page();
    // Asked for before the page is there: the browser needs a moment until it hands its own dialog over.
    const chosen = page.waitForEvent('filechooser', { timeout: 60_000 });
    await page.goto('/');
    await page.getByRole('heading', { level: 1 }).waitFor();
    await tab_to(page, /^Choose files/, ['button']);
    await page.keyboard.press('Enter');
    await (await chosen).setFiles(example);
    await page.getByRole('button', { name: 'Keep', exact: true }).waitFor();
    await tab_to(page, /^Keep$/);
    await page.keyboard.press('Enter');
    await page.waitForURL(/\/tests\/\d+$/);
    await shows(page.locator('main'), /9\.6/);

    await tab_to(page, /^Edit$/);
    await page.keyboard.press('Space');
    await page.getByLabel(/misalignment/i).first().waitFor();
    await tab_to(page, /misalignment/i, ['input']);
    await page.keyboard.press('Control+A');
    await page.keyboard.type('2');
    await page.waitForTimeout(300);
    await tab_to(page, /^Save/, ['button']);
    await page.keyboard.press('Enter');
    await page.getByRole('dialog').waitFor();
    if (!/reason/i.test((await focused(page)).name)) await tab_to(page, /reason/i);
    await page.keyboard.type('by keyboard');
    await tab_to(page, /^Save$/, ['button']);
    await page.keyboard.press('Enter');
    await page.getByRole('dialog').waitFor({ state: 'hidden' });
    await shows_version(page, 2);

    await page.keyboard.press('Home');
    await tab_to(page, /^Report$/, ['a']);
    await page.keyboard.press('Enter');
    await page.waitForURL(/\/report/);
    await page.getByRole('link', { name: 'PDF' }).first().waitFor();
    await tab_to(page, /PDF/, ['a']);
    const pdf = await downloaded(page, () => page.keyboard.press('Enter'));
    assert.equal(pdf.bytes.subarray(0, 5).toString(), '%PDF-');
    await tab_to(page, /^Issue$/, ['button']);
    await page.keyboard.press('Space');
    await shows(page.locator('.issued'), /SHA-256/);
  },

  async 'the chart is walked by arrow keys, and says what is there'(world) {
    const id = await world.kept();
    const page = await world.page();
    await page.goto(`/tests/${id}`);
    await shows(page.locator('main'), /9\.6/);
    const chart = page.getByRole('application').first();
    await chart.focus();
    await page.keyboard.press('ArrowRight');
    const first = await shows(chart.locator('[aria-live]'), /6\.711/);
    await page.keyboard.press('ArrowRight');
    await shows(chart.locator('[aria-live]'), /175\.077/);
    assert.match(first, /\d/);
  },
};
