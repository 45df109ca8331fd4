// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { settle } from './pages.mjs';
import { shows } from './world.mjs';

/** A stage whose errors are some hundredths of a micrometre. */
function fine_stage() {
  const rows = ['target_mm,direction,run,deviation_um'];
  for (let run = 1; run <= 5; run += 1)
    for (const direction of ['up', 'down'])
      for (let i = 0; i < 5; i += 1)
        rows.push(`${10 * i + 0.1 * i * i},${direction},${run},${(0.006 * i + (direction === 'up' ? 0 : 0.012) + 0.002 * ((run * 7 + i * 3) % 5)).toFixed(4)}`);
  return new TextEncoder().encode(rows.join('\n'));
}

export const figures = {
  async 'a stage of hundredths of a micrometre keeps its digits in the list, and its decimal marks in line'(world) {
    await world.kept();
    const { id } = await world.api('POST', '/api/tests', fine_stage(), { 'X-File-Name': 'fine.csv' });
    const { result } = await world.api('GET', `/api/tests/${id}`);
    assert.ok(result.parameters.B > 0.005 && result.parameters.A < 0.095, `A ${result.parameters.A}, B ${result.parameters.B}`);
    const page = await world.page();
    await page.goto('/');
    await settle(page);
    for (const parameter of ['A', 'E', 'R', 'B'])
      await shows(page.locator('.test-list tbody tr').first(), result.parameters[parameter].toFixed(3));
    // Where the last digit before the decimal mark ends, in each row of the column of B.
    const marks = await page.locator('.test-list tbody tr').evaluateAll((all) => all
      .map((row) => {
        const text = [...row.querySelectorAll('td.number')].at(3).querySelector('span').firstChild;
        const range = document.createRange();
        range.setStart(text, 0);
        range.setEnd(text, text.data.indexOf('.'));
        return range.getBoundingClientRect().right;
      }));
    assert.equal(marks.length, 2);
    assert.ok(Math.abs(marks[0] - marks[1]) < 0.6, `decimal marks at ${marks}`);
  },
};
