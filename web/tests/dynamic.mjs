// SPDX-License-Identifier: Apache-2.0
// A recording without standstills: dropped where tests are expected, recognised, evaluated, shown, saved as files.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { settle } from './pages.mjs';
import { downloaded, shows, sideways } from './world.mjs';

const rtx = readFileSync(fileURLToPath(new URL('../../tests/transcripts/dynamic.files/x-axis.rtx', import.meta.url)));
const given = (name, buffer = rtx) => ({ name, mimeType: 'application/octet-stream', buffer });
/** 10 mm/s for a second, with 50 Hz on it. */
const table = (rows = 1000) => `time_s,position_mm\n${Array.from({ length: rows }, (_, k) => `${(k / 1000).toFixed(3)},${(k / 100 + 0.002 * Math.sin(0.1 * Math.PI * k)).toFixed(6)}`).join('\n')}\n`;

export const dynamic = {
  async 'dynamic: a recording among tests is recognised and leads to its motion, with curves and figures'(world) {
    const page = await world.page();
    await page.goto('/');
    await settle(page);
    await page.setInputFiles('input[type=file]', [given('x-axis.rtx')]);
    await shows(page.locator('main'), 'This is no test, but a continuous recording');
    assert.equal(await page.getByRole('button', { name: 'Keep', exact: true }).count(), 0, 'never kept as a test');
    await page.getByRole('button', { name: 'Look at its motion' }).click();
    await shows(page.locator('h1'), 'Motion without standstills');
    await shows(page.locator('main'), /No test of ISO 230-2/);
    await shows(page.locator('main'), /Highest velocity\s*20\.013 mm\/s\s*0\.0013\s*2\.0550\s*30\.050/);
    await shows(page.locator('main'), /↑\s*0\.6200\s*3\.0850\s*1\.35\s*50\.65\s*1200\.00/);
    await shows(page.locator('main'), /4\.001?\s*0\.4003\s*4\.9988/);
    assert.equal(await page.locator('main canvas').count(), 5, 'position, velocity, acceleration, straying, spectrum');
    await shows(page.locator('main'), 'whether the day or the month stands first it does not say');
    await shows(page.locator('main'), 'The feed that was asked for is not stated:');
    await page.getByLabel('Feed asked for, mm/min').fill('1000');
    await shows(page.locator('main'), /less that asked for \/ %[\s\S]*20\.000/);
    assert.equal(await page.getByText('not stated').count(), 0);
    await page.getByLabel('Only to, s').fill('0,4');
    await shows(page.locator('main'), 'No stretch of even motion was found.');
    await page.getByLabel('Only to, s').fill('word');
    await shows(page.locator('main'), 'A number is wanted.');
    await page.getByLabel('Only to, s').fill('');
    await page.getByLabel('Window of velocities, s').fill('3');
    await shows(page.locator('main'), 'found a window of 3 s');
    await page.getByLabel('Window of velocities, s').fill('');
    await shows(page.locator('main'), /less that asked for \/ %[\s\S]*20\.000/);
    assert.equal((await world.api('GET', '/api/tests')).total, 0);
  },

  async 'dynamic: a recording among tests is recognised in every language'(world) {
    for (const [locale, words] of [['de-DE', ['fortlaufende Aufzeichnung einer bewegten Achse', 'Bewegung ansehen', 'Bewegung ohne Stillstände']], ['fr-FR', ['enregistrement continu d’un axe', 'Regarder son mouvement', 'Mouvement sans arrêts']]]) {
      const page = await world.page({ locale });
      await page.goto('/');
      await settle(page);
      await page.setInputFiles('input[type=file]', [given('run.csv', Buffer.from(table()))]);
      await shows(page.locator('main'), words[0]);
      await page.getByRole('button', { name: words[1] }).click();
      await shows(page.locator('h1'), words[2]);
      await page.locator('main canvas').first().waitFor();
    }
  },

  async 'dynamic: report, result, samples and amplitudes are saved as the command line writes them'(world) {
    const page = await world.page();
    await page.goto('/captures');
    await page.getByRole('link', { name: 'Motion without standstills…' }).click();
    await shows(page.locator('main'), 'No recording has been chosen.');
    await page.locator('.file-drop input[type=file]').setInputFiles(given('run.csv', Buffer.from(table())));
    await shows(page.locator('main'), /50\.00?\s*2\.00/);
    const saved = (name) => downloaded(page, () => page.getByRole('button', { name }).click());
    assert.equal((await saved('Report PDF')).bytes.subarray(0, 5).toString(), '%PDF-');
    const result = JSON.parse((await saved('Report JSON')).bytes);
    assert.equal(result.source.file, 'run.csv');
    assert.equal(result.curves, undefined);
    assert.equal(result.samples, 1000);
    const samples = (await saved('Samples CSV')).bytes.toString().trim().split('\n');
    assert.equal(samples[0], 'time_s,position_mm,velocity_mm_per_s,acceleration_mm_per_s2');
    assert.equal(samples.length, 1001);
    assert.match((await saved('Amplitudes CSV')).bytes.toString(), /^frequency_hz,amplitude_um\n0,/);
  },

  async 'dynamic: what is wrong with a recording is said in the words of the page, and the page goes on'(world) {
    const page = await world.page({ locale: 'de-DE', width: 390, height: 844 });
    await page.goto('/dynamic');
    const input = page.locator('.file-drop input[type=file]');
    await input.setInputFiles(given('cut.rtx', rtx.subarray(0, 6000)));
    await shows(page.locator('main'), 'erwartet: 1500, wie der Kopf sagt');
    const damaged = `${table()}lost\n`;
    await input.setInputFiles(given('run.csv', Buffer.from(damaged)));
    await shows(page.locator('main'), '"lost"');
    await page.getByLabel('Auslassen, was kein Abtastwert ist').check();
    await shows(page.locator('main'), /Schwingungen[\s\S]*50,00?\s*2,00/);
    assert.equal(await sideways(page), 0, 'nothing makes the page wider than a telephone');
  },
};
