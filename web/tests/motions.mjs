// SPDX-License-Identifier: Apache-2.0
// Straightness, angles and squareness: dropped where tests are expected, recognised, shown, kept, found again.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { settle } from './pages.mjs';
import { downloaded, shows } from './world.mjs';

const measured = (name) => readFileSync(fileURLToPath(new URL(`../../tests/transcripts/error-motions.files/${name}`, import.meta.url)));
const given = (name) => ({ name, mimeType: 'text/csv', buffer: measured(name) });

export const motions = {
  async 'motions: a straightness among tests is recognised, shown with its curve, kept and found again'(world) {
    await world.api('POST', '/api/machines', { name: 'Mill 5' });
    const page = await world.page();
    await page.goto('/');
    await settle(page);
    await page.setInputFiles('input[type=file]', [given('z-of-x.csv')]);
    await shows(page.locator('main'), 'no test of positions');
    assert.equal(await page.getByRole('button', { name: 'Keep', exact: true }).count(), 0, 'never kept as a test');
    await page.getByRole('button', { name: 'Look at it' }).click();
    await shows(page.locator('h1'), 'Straightness, angles, squareness');
    await shows(page.locator('main'), /EZX.*z-of-x\.csv/s);
    await shows(page.locator('main'), /Straightness, range of the residuals\s*mean\s*1\.08/);
    assert.equal(await page.locator('main canvas').count(), 1, 'the curve is drawn');
    await page.getByLabel('U of a reading (k = 2)').fill('0,1');
    await shows(page.locator('main'), /Straightness, range of the residuals\s*mean\s*1\.08 µm\s*0\.30/);
    await page.getByLabel('Positive towards').fill('-Z');
    await shows(page.locator('main'), /positive towards -Z: their signs are turned/i);
    await page.getByLabel('Positive towards').fill('-Y');
    await shows(page.locator('main'), 'expected +Z or -Z as EZX is');
    await page.getByLabel('Positive towards').fill('+Z');
    await page.getByRole('button', { name: 'Keep in the archive' }).click();
    await page.getByRole('dialog').getByLabel('Measured on').fill('2026-11-26');
    await page.getByRole('dialog').getByRole('button', { name: 'Keep', exact: true }).click();
    await page.getByRole('link', { name: /Kept as calibration 1/ }).click();
    await shows(page.locator('h1'), 'EZX');
    await shows(page.locator('main'), /Mill 5/);
    assert.equal(await page.locator('main canvas').count(), 1);
    const report = await downloaded(page, () => page.getByRole('link', { name: 'Report PDF' }).click());
    assert.equal(report.bytes.subarray(0, 5).toString(), '%PDF-');
    await page.goto('/calibrations?kind=straightness');
    await shows(page.locator('main'), /EZX.*Straightness.*EZX 1\.08 µm/s);
    await page.goto('/machines/1');
    await shows(page.locator('main'), /EZX 1\.08 µm/);
    assert.equal((await world.api('GET', '/api/tests')).total, 0);
  },

  async 'motions: two straightnesses are the squareness of two axes, with its sign once the senses are told'(world) {
    const page = await world.page();
    await page.goto('/motions');
    const input = page.locator('.file-drop input[type=file]');
    await input.setInputFiles(given('x-in-y.csv'));
    await shows(page.locator('main'), /EYX/);
    await input.setInputFiles(given('y-in-x.csv'));
    await shows(page.locator('main'), /θ₂ − θ₁ \+ error of the square\s*−5\.17/);
    await shows(page.locator('main'), 'Nothing states which way the readings of both lines are positive');
    await page.getByLabel('Positive towards').fill('+Y, -X');
    await shows(page.locator('main'), /Location error C0Y\s*−25\.1/);
    await page.getByLabel('Error of the optical square, ″').fill('0.5');
    await shows(page.locator('main'), /Location error C0Y\s*−22\.6/);
    await page.getByRole('button', { name: 'Keep in the archive' }).click();
    await page.getByRole('dialog').getByRole('button', { name: 'Keep', exact: true }).click();
    await page.getByRole('link', { name: /Kept as calibration 1/ }).click();
    await page.getByRole('button', { name: 'Evaluate again' }).click();
    await page.getByRole('dialog').getByLabel('Error of the optical square, ″').fill('');
    await page.getByRole('dialog').getByLabel('Reason (required)').fill('another square');
    await page.getByRole('dialog').getByRole('button', { name: 'Save as version 2' }).click();
    await shows(page.locator('main'), /Location error C0Y\s*−25\.1/);
    await page.goto('/calibrations');
    await shows(page.locator('main'), /Squareness.*C0Y −25\.07 µrad/s);
  },

  async 'motions: both lines of a squareness may come at once'(world) {
    const page = await world.page();
    await page.goto('/motions');
    await page.locator('.file-drop input[type=file]').setInputFiles([given('x-in-y.csv'), given('y-in-x.csv')]);
    await shows(page.locator('main'), /x-in-y\.csv[\s\S]*y-in-x\.csv/);
    await shows(page.locator('main'), /θ₂ − θ₁ \+ error of the square\s*−5\.17/);
  },

  async 'motions: the same error of a machine stands over time, and no other beside it'(world) {
    await world.api('POST', '/api/machines', { name: 'Mill 5' });
    const keep = async (page, name, text, measured_on) => page.evaluate(async ({ name, text, measured_on }) => {
      const form = new FormData();
      form.append('kind', 'straightness');
      form.append('about', JSON.stringify({ measured_on }));
      form.append('readings', new File([text], name));
      return (await fetch('/api/calibrations', { method: 'POST', body: form })).status;
    }, { name, text, measured_on });
    const page = await world.page();
    await page.goto('/calibrations');
    const readings = measured('z-of-x.csv').toString();
    assert.equal(await keep(page, 'first.csv', readings, '2025-11-26'), 201);
    await page.goto('/calibrations/1');
    await shows(page.locator('main'), 'EZX');
    assert.equal(await page.locator('.calibration-history').count(), 0, 'one point is no course');
    assert.equal(await keep(page, 'second.csv', readings.replaceAll('EZX', 'EYX'), '2026-05-26'), 201);
    await page.reload();
    await shows(page.locator('main'), 'EZX');
    await settle(page);
    assert.equal(await page.locator('.calibration-history').count(), 0, 'EYX is another error');
    assert.equal(await keep(page, 'third.csv', `${readings.trim()}\n`, '2026-11-26'), 201);
    await page.reload();
    await shows(page.locator('.calibration-history'), /Over time.*EZX: Straightness, µm/s);
    await page.locator('.calibration-history canvas').waitFor();
  },

  async 'motions: the rotations of an axis, and what they do at another point'(world) {
    const page = await world.page();
    await page.goto('/motions');
    const input = page.locator('.file-drop input[type=file]');
    for (const name of ['roll.csv', 'pitch.csv', 'yaw.csv']) {
      await input.setInputFiles(given(name));
      await shows(page.locator('main'), name);
    }
    await shows(page.locator('main'), /EAX.*EBX.*ECX/s);
    for (const [k, mm] of ['0', '100', '250'].entries()) await page.getByLabel(/^Offset to another point/).nth(k).fill(mm);
    await shows(page.locator('main'), 'At another point');
    await page.getByRole('button', { name: 'Take roll.csv away' }).click();
    await shows(page.locator('main'), /Not known without[\s\S]*EAX/);
  },

  async 'motions: readings without positions get the places of their plan, of a file or of the archive'(world) {
    const request = { axis: 'X', kind: 'linear', from: 0, to: 220, positions: [10, 100, 200], cycle: 'unidirectional', runs: 1, seed: 7, further: { error: 'EYX' } };
    const { plan } = await world.api('POST', '/api/plans', { title: 'Straightness of X', axis: null, request });
    assert.deepEqual(plan.errors, ['EYX']);
    const page = await world.page();
    await page.goto('/plans/1');
    await shows(page.locator('.outcome'), /Errors\s*EYX/);
    await shows(page.locator('.outcome'), 'can be followed');
    assert.equal(await page.locator('.outcome').getByText('in accordance with ISO 230-2').count(), 0, 'the standard says nothing of it');
    assert.equal(await page.getByRole('link', { name: 'Capture with this plan' }).count(), 1);
    await page.goto('/motions');
    const input = page.locator('.file-drop input[type=file]');
    const text = (name, content) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(content) });
    await input.setInputFiles(text('alone.csv', 'straightness_um\n0\n0.6\n0\n'));
    await shows(page.locator('main'), 'no column position_mm');
    await page.getByLabel('Add a plan of the archive').selectOption({ label: 'Straightness of X' });
    await shows(page.locator('main'), /Straightness of X\.plan\.json.*plan/s);
    await shows(page.locator('main'), /EYX.*alone\.csv/s);   // the plan names the error
    await shows(page.locator('main'), /Straightness, range of the residuals\s*↑\s*0\.61/);
    await page.getByRole('button', { name: 'Keep in the archive' }).click();
    await page.getByRole('dialog').getByRole('button', { name: 'Keep', exact: true }).click();
    await page.getByRole('link', { name: /Kept as calibration 1/ }).click();
    await shows(page.locator('h1'), 'EYX');
    await page.goto('/motions');
    await input.setInputFiles(text('other.csv', 'EZX_um\n0\n0.6\n0\n'));
    await input.setInputFiles(text('x.json', JSON.stringify(plan)));
    await shows(page.locator('main'), 'readings of EZX with a plan made for EYX');
    await page.getByRole('button', { name: 'Take other.csv away' }).click();
    await input.setInputFiles(text('first.csv', 'EYX_um\n0\n1\n2\n'));
    await input.setInputFiles(text('second.csv', 'EXY_um\n0\n2\n4\n'));
    await shows(page.locator('main'), 'for squareness: found 1, expected 2');
    await input.setInputFiles(text('y.json', JSON.stringify({ ...plan, axis: { ...plan.axis, name: 'Y' }, errors: ['EXY'] })));
    await shows(page.locator('main'), 'θ₂ − θ₁ + error of the square');
    await shows(page.locator('main'), 'plan of line 2');
  },
};
