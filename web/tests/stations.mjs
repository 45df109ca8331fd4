// SPDX-License-Identifier: Apache-2.0
// Points from several stations, and errors of a machine that were measured one by one: from files to results.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { axe_findings, downloaded, shows, sideways } from './world.mjs';

const data = (name) => readFile(new URL(`../../tests/transcripts/${name}`, import.meta.url));
const file = async (name, from) => ({ name, mimeType: name.endsWith('.json') ? 'application/json' : 'text/csv', buffer: await data(from) });
const points = (page) => page.locator('section[aria-labelledby=tracking-coordinates]');
const singles = (page) => page.locator('section[aria-labelledby=volume-singles]');

async function opened(world, path, how = {}) {
  const page = await world.page(how);
  await page.goto(path);
  return page;
}

export const stations = {
  async 'stations: lengths of five stations become points with their uncertainties'(world) {
    const page = await opened(world, '/tracking');
    const input = points(page).locator('input[type=file]');
    await input.setInputFiles([await file('ranges.csv', 'tracking-multilaterate.files/ranges.csv')]);
    await shows(points(page).getByRole('alert'), /no columns x_mm, y_mm, z_mm/);
    await input.setInputFiles([await file('nominal.csv', 'tracking-multilaterate.files/nominal.csv')]);
    await shows(points(page), /Points found/);
    await shows(points(page).locator('.figures').first(), /120 \/ 86/);
    await shows(points(page), /P1\s*49\.9965\s*49\.9898\s*19\.9975/);
    await shows(points(page), /From lengths alone: every coordinate lies along some beam/);
    assert.ok(await points(page).locator('.scene svg').count() > 0);
    await points(page).getByLabel('Scale of the lengths').selectOption('common');
    await points(page).getByLabel('Standard uncertainty of the scale (10⁻⁶)').fill('0.1');
    await shows(points(page), /Scale − 1/);
    const csv = await downloaded(page, () => points(page).getByRole('button', { name: 'Points CSV' }).click());
    assert.match(csv.bytes.toString(), /^point,x_mm,y_mm,z_mm,dx_um/);
    const residuals = await downloaded(page, () => points(page).getByRole('button', { name: 'Residuals CSV' }).click());
    assert.match(residuals.bytes.toString(), /^point,station,segment,length_mm,residual_um,normalised/);
    const json = await downloaded(page, () => points(page).getByRole('button', { name: 'Report JSON' }).click());
    assert.equal(JSON.parse(json.bytes.toString()).result, 'multilateration');
    await points(page).getByLabel('Standard uncertainty of the scale (10⁻⁶)').fill('wide');
    await shows(points(page), 'found "wide", expected a number');
    assert.deepEqual(await axe_findings(page), []);
    assert.equal(await sideways(page), 0);
  },

  async 'stations: angles are joined with lengths, and the page says why lengths alone are better'(world) {
    const page = await opened(world, '/tracking', { locale: 'de-DE' });
    const input = points(page).locator('input[type=file]');
    await input.setInputFiles([await file('tracker.csv', 'tracking-polar.files/tracker.csv')]);
    await shows(points(page).getByRole('alert'), /Unsicherheit/);
    await points(page).getByLabel('Art des Geräts', { exact: true }).selectOption('leica-at901');
    await shows(points(page), /Gefundene Punkte/);
    await shows(points(page), /Die Winkel bestimmen 5\d % der Unbekannten/);
    await input.setInputFiles([await file('tracer.csv', 'tracking-polar.files/tracer.csv'), await file('nominal.csv', 'tracking-polar.files/nominal.csv')]);
    await points(page).getByLabel('Art des Geräts von TR').selectOption('etalon-lasertracer');
    await shows(points(page).locator('.figures').first(), /70 \/ 40/);
    await shows(points(page), /relativ zu den Punkten als Ganzem/);
    await points(page).getByLabel('in den Koordinaten der ersten Station mit Winkeln').check();
    await shows(points(page), /Koordinaten der ersten Station mit Winkeln; Standard/);
    const pdf = await downloaded(page, () => points(page).getByRole('button', { name: 'Bericht PDF' }).click());
    assert.equal(pdf.bytes.subarray(0, 5).toString(), '%PDF-');
    assert.deepEqual(await axe_findings(page), []);
  },

  async 'stations: errors measured one by one become a model, and the page says what lacks'(world) {
    const page = await opened(world, '/volume');
    await page.getByLabel('Open machine.json').setInputFiles(await file('machine.json', 'volumetric-assemble.files/machine.json'));
    const from = (name) => file(name, `volumetric-assemble.files/${name}`);
    await singles(page).locator('input[type=file]').setInputFiles([await from('exx.csv'), await from('eyx.csv'), await from('ecx.csv'), await from('exy.csv')]);
    await shows(singles(page), /4 of 21 given/);
    await shows(singles(page).getByRole('alert'), /not where the other axes stood/);
    const at = async (axis, places) => {
      const group = singles(page).getByRole('group', { name: `While ${axis} was measured` });
      for (const [other, mm] of Object.entries(places)) await group.getByLabel(`${other} at (mm)`).fill(mm);
    };
    await at('X', { Y: '300', Z: '-200' });
    await at('Y', { X: '500', Z: '-200' });
    await singles(page).getByText('Squareness as a number').click();
    await singles(page).getByLabel('C0Y (µrad)', { exact: true }).fill('-12.5');
    await singles(page).getByLabel('U of C0Y (µrad)').fill('1.2');
    await shows(singles(page), /5 of 21 given/);
    await shows(page.locator('#volume-assembled'), /of 21 errors put together/);
    await shows(page.locator('section[aria-labelledby=volume-assembled]'), /EYX\s*eyx\.csv\s*3\s*both/);
    await shows(page.locator('section[aria-labelledby=volume-errors]'), /Nothing that was measured tells it/);
    await shows(page.locator('section[aria-labelledby=volume-field]'), /volumetric-singles-remark/);
    const saved = await downloaded(page, () => page.locator('section[aria-labelledby=volume-assembled]').getByRole('button', { name: 'Result JSON' }).click());
    assert.equal(JSON.parse(saved.bytes.toString()).result, 'volumetric-assembled');
    assert.deepEqual(await axe_findings(page), []);
    assert.equal(await sideways(page), 0);
    // The file is a result that the page opens again.
    const again = await opened(world, '/volume');
    await again.getByLabel('Open a result').setInputFiles({ name: 'errors.result.json', mimeType: 'application/json', buffer: saved.bytes });
    await shows(again.locator('#volume-assembled'), /of 21 errors put together/);
  },
};
