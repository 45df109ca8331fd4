// SPDX-License-Identifier: Apache-2.0
// An axis that is measured, and the tables that correct it: what tests of these pages have in common.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { example } from './world.mjs';

const published = JSON.parse(readFileSync(example, 'utf8'));
export const targets = [0, 97, 203, 301, 396, 500];
/** What the axis does, µm: too far by its length, with a reversal; runs that scatter a little. */
const deviation = (x, way, run) => 0.03 * x - 4 + 3 * Math.sin(x / 90) + (way === 'up' ? -1.5 : 1.5) + 0.15 * Math.sin(7 * x + 3 * run + (way === 'up' ? 1 : 0));

/** What a table adds at x, by its nodes. */
export function added_by(nodes, x, way) {
  const k = Math.min(Math.max(nodes.findIndex(({ position }) => position >= x), 1), nodes.length - 1);
  const [a, b] = [nodes[k - 1], nodes[k]];
  return a[way] + (b[way] - a[way]) * Math.min(Math.max((x - a.position) / (b.position - a.position), 0), 1);
}

/** A test of X of "Mill 9" on that day; `added`: what the control adds meanwhile, µm; `at`: the targets, mm. */
export async function measured(world, date, added = () => 0, { at = targets, axis = {} } = {}) {
  const rows = (way) => [1, 2, 3, 4, 5].map((run) => at.map((x) => Number((deviation(x, way, run + date.length) + added(x, way)).toFixed(4))));
  const test = {
    ...published, test: { ...published.test, date }, machine: { name: 'Mill 9' }, uncertainty: {}, tolerance: { E: 8, A: 12 },
    axis: { ...published.axis, ...axis },
    series: { quantity: 'deviation', unit: 'um', target_unit: 'mm', targets: at, up: rows('up'), down: rows('down') },
  };
  const { id } = await world.api('POST', '/api/tests', new TextEncoder().encode(JSON.stringify(test)), { 'X-File-Name': `mill-9-${date}.json` });
  return id;
}

/** Keeps the table of a test, as a script would. */
export async function kept_table(world, test, options, existing = null) {
  const form = new FormData();
  form.append('options', JSON.stringify(options));
  if (existing) form.append('existing', new Blob([existing.text]), existing.name);
  const answer = await fetch(`${world.server.address}/api/tests/${test}/compensations`, { method: 'POST', body: form });
  const text = await answer.text();
  assert.equal(answer.status, 201, text);
  return JSON.parse(text);
}

export const milled = (world, controller) => world.api('POST', '/api/machines', { name: 'Mill 9', controller });

export async function with_reason(page, button, reason) {
  await page.getByRole('dialog').getByLabel('Reason (required)').fill(reason);
  await page.getByRole('dialog').getByRole('button', { name: button }).click();
}

/** The cell of a row of figures under a head. */
export async function figure(page, parameter, head) {
  const table = page.locator('.table-results table');
  const heads = (await table.locator('thead th').allInnerTexts()).map((text) => text.trim());
  const at = heads.findIndex((text) => text === head);
  assert.notEqual(at, -1, `${head} is no head of ${heads.join(', ')}`);
  const row = table.locator('tbody tr').filter({ has: page.locator('th', { hasText: new RegExp(`^\\s*${parameter}\\s*$`) }) });
  return row.locator('th, td').nth(at).evaluate((cell) => {
    const copy = cell.cloneNode(true);
    copy.querySelectorAll('.room').forEach((one) => one.remove());
    return copy.innerText ?? copy.textContent;
  }).then((text) => Number(/[-−\d.]+/.exec(text)[0].replace('−', '-')));
}

export const comp_file = (nodes) => nodes.map(([x, forward, reverse]) => `${x} ${(x + forward / 1000).toFixed(6)} ${(x + reverse / 1000).toFixed(6)}`).join('\n') + '\n';
export const given = (name, text) => ({ name, mimeType: 'application/octet-stream', buffer: Buffer.from(text) });
