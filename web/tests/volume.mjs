// SPDX-License-Identifier: Apache-2.0
// The volumetric calibration: from the machine over plan, programs and lengths to errors, slices, before and after, tables.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { attribute_shows, axe_findings, downloaded, shows, sideways } from './world.mjs';

const run = promisify(execFile);

const words = {
  'en-GB': {
    plan: 'Make the plan', told: 'All 21 errors will be told', points: 'Points per station and tool', plan_file: 'Plan JSON', points_file: 'Points CSV',
    sheet: 'Sheet PDF', run: 'Run', control: 'Control', lengths: 'Choose lengths', found: 'All 21 errors found', table: 'All errors as numbers',
    report: 'Report PDF', result: 'Result JSON', residuals: 'Residuals CSV', slice: 'Slice across', before: 'Choose the earlier result', moved: /moved by up to \d+\.\d µm/,
    sure: 'a change, not chance', line: 'Line', systematic: 'E of the mean of both directions', save: 'Download', which: 'Table', open: 'Open a result', name: 'Name',
    search: 'Search a control', along: 'Table over the positions of', moves: 'It moves', one_axis: /It corrects EXX\.[\s\S]*Range on the line[\s\S]*\d+\.\d → \d+\.\d µm/,
    cross: /3 of \d+ controls have cross tables/, both: 'It corrects EXY, C0Y.', refused: 'No table is made of this', first: 'First position / mm',
    smoothness: 'Smoothness', smoothness_fault: '“auto”, or one or two numbers',
    at: /^Slice at/, slice_told: /Slice at Z −?\d+ mm/,
  },
  'de-DE': {
    plan: 'Plan machen', told: 'Alle 21 Abweichungen werden bestimmt', points: 'Punkte je Station und Werkzeug', plan_file: 'Plan JSON', points_file: 'Punkte CSV',
    sheet: 'Blatt PDF', run: 'Lauf', control: 'Steuerung', lengths: 'Längen wählen', found: 'Alle 21 Abweichungen gefunden', table: 'Alle Abweichungen als Zahlen',
    report: 'Bericht PDF', result: 'Ergebnis JSON', residuals: 'Residuen CSV', slice: 'Schnitt quer zu', before: 'Früheres Ergebnis wählen', moved: /um bis zu \d+,\d µm verschoben/,
    sure: 'eine Änderung, kein Zufall', line: 'Linie', systematic: 'E des Mittelwerts beider Richtungen', save: 'Herunterladen', which: 'Tabelle', open: 'Ergebnis öffnen', name: 'Name',
    search: 'Steuerung suchen', along: 'Tabelle über den Positionen von', moves: 'Sie bewegt', one_axis: /Sie korrigiert EXX\.[\s\S]*Spanne auf der Linie[\s\S]*\d+,\d → \d+,\d µm/,
    cross: /3 von \d+ Steuerungen haben Kreuztabellen/, both: 'Sie korrigiert EXY, C0Y.', refused: 'Daraus entsteht keine Tabelle', first: 'Erste Position / mm',
    smoothness: 'Glattheit', smoothness_fault: 'Gesucht ist „auto“',
    at: /^Schnitt bei/, slice_told: /Schnitt bei Z −?\d+ mm/,
  },
};

const json = (name, bytes) => ({ name, mimeType: 'application/json', buffer: Buffer.from(bytes) });
const of_panel = (page, id) => page.locator(`section[aria-labelledby="${id}"]`);

async function opened(world, how = {}) {
  const page = await world.page(how);
  await page.goto('/volume');
  await page.locator('svg.chain').waitFor();
  return page;
}

/** Lengths that the instrument would measure after the plan, at a machine whose errors the seed draws. */
async function simulated(world, plan, seed) {
  const [file, out] = [join(world.folder, 'plan.json'), join(world.folder, `lengths-${seed}.csv`)];
  await writeFile(file, plan);
  await run(world.program, ['volumetric', 'simulate', '--plan', file, '--seed', String(seed), '--lengths', out, '--quiet']);
  return { name: `lengths-${seed}.csv`, mimeType: 'text/csv', buffer: await readFile(out) };
}

async function planned(page, w, points = '30') {
  await of_panel(page, 'volume-machine').getByLabel(w.name, { exact: true }).first().fill('Mill 5');
  await page.getByLabel(w.points).fill(points);
  await page.getByRole('button', { name: w.plan }).click();
  await shows(of_panel(page, 'volume-plan'), w.told, 60_000);
  return downloaded(page, () => page.getByRole('button', { name: w.plan_file }).click());
}

const measured = async (page, w, file) => {
  await page.getByLabel(w.lengths, { exact: true }).last().setInputFiles(file);
  await shows(of_panel(page, 'volume-found'), w.found);
};

/** The table that a control takes of one axis, refused, made, and of two axes. */
async function table_of_one_axis(page, w) {
  const panel = of_panel(page, 'volume-control-table');
  const search = panel.getByRole('combobox', { name: w.search });
  await search.fill('FILE_TYPE 0');
  await search.press('Enter');
  await shows(panel, w.one_axis);
  const [before, after] = /([\d.,]+) → ([\d.,]+) µm/.exec(await panel.innerText()).slice(1).map((text) => Number(text.replace(',', '.')));
  assert.ok(after < 0.5 * before, `${before} → ${after}`);
  const file = await downloaded(page, () => page.locator('.table-file').getByRole('button', { name: w.save }).click());
  assert.equal(file.name, 'X-linuxcnc.comp');
  assert.equal(file.bytes.toString(), await page.locator('.table-file .listing pre').last().textContent());
  await panel.getByLabel(w.first).fill('-900');
  await shows(panel, w.refused);
  assert.equal(await page.locator('.table-file').count(), 0, 'no file beside what is refused');
  await panel.getByLabel(w.first).fill('');
  await page.locator('.table-file').waitFor();
  await panel.getByLabel(w.along).selectOption('Y');
  await panel.getByLabel(w.moves).selectOption('X');
  await shows(panel, w.cross);
  assert.equal(await page.locator('.table-file').count(), 0, 'LinuxCNC has no cross table');
  assert.equal(await panel.locator('.control-search li').count(), 3, 'one that has cross tables alone too');
  await search.fill('CEC');
  await search.press('Enter');
  await shows(panel, w.both);
  await shows(page.locator('.table-file'), /\$AN_CEC/);
  await panel.locator('.turned-sign input').check();
  await shows(panel.locator('.turned-sign .caution'), /\S/);
  await shows(page.locator('.table-file'), /A positive number moves the axis in the positive/);
  await panel.locator('.chosen-control button').click();
  await search.fill('M852');
  await search.press('Enter');
  await shows(page.locator('.table-file'), /M852/);
}

/** Curves that are taken to be smooth say so, and a smoothness that is none is refused in its field. */
async function smoothed(page, w) {
  const panel = of_panel(page, 'volume-lengths');
  const field = panel.getByLabel(w.smoothness, { exact: true });
  await field.fill('0.01');
  await shows(panel, w.smoothness_fault);
  await field.fill('auto');
  await shows(of_panel(page, 'volume-found'), /volumetric-smoothness/);
  await field.fill('');
  await of_panel(page, 'volume-found').getByText('volumetric-smoothness', { exact: true }).waitFor({ state: 'detached' });
}

async function whole_way(world, locale) {
  const w = words[locale];
  const page = await opened(world, { locale });
  const plan = await planned(page, w);
  assert.equal(JSON.parse(plan.bytes).format, 'axiometry-volumetric-plan/1');
  const points = await downloaded(page, () => page.getByRole('button', { name: w.points_file }).click());
  assert.match(points.bytes.toString(), /^station,tool,segment,x_mm,y_mm,z_mm,length_mm\n/);
  const sheet = await downloaded(page, () => page.getByRole('button', { name: w.sheet }).click());
  assert.equal(sheet.bytes.subarray(0, 5).toString(), '%PDF-');
  await page.getByLabel(w.control).selectOption('linuxcnc');
  await of_panel(page, 'program-title').getByLabel(w.run, { exact: true }).selectOption('3');
  await shows(page.locator('.listing'), /RUN 4 OF 12/);
  const program = await downloaded(page, () => of_panel(page, 'program-title').getByRole('button', { name: '.ngc' }).click());
  assert.match(program.bytes.toString(), /RUN 4 OF 12/);

  await measured(page, w, await simulated(world, plan.bytes, 7));
  assert.equal(await page.locator('.curve .chart').count(), 18, 'a chart of each motion');
  await smoothed(page, w);
  await page.getByText(w.table).click();
  assert.equal(await of_panel(page, 'volume-errors').locator('tbody tr').count(), 21);
  for (const [button, begin] of [[w.report, '%PDF-'], [w.result, '{'], [w.residuals, 'station,tool,']]) {
    const file = await downloaded(page, () => of_panel(page, 'volume-found').getByRole('button', { name: button }).click());
    assert.ok(file.bytes.toString().startsWith(begin), `${button}: ${file.bytes.subarray(0, 20)}`);
  }
  const result = await downloaded(page, () => of_panel(page, 'volume-found').getByRole('button', { name: w.result }).click());

  const field = of_panel(page, 'volume-field');
  await shows(field, w.slice_told);
  const slider = field.getByLabel(w.at);
  const told = await field.locator('.field-picture > p').innerText();
  await slider.focus();
  await page.keyboard.press('ArrowRight');
  await page.waitForFunction((was) => document.querySelector('.field-picture > p').innerText !== was, told);
  await field.getByLabel(w.slice).selectOption('0');
  await shows(field, / X \d+ mm/);
  assert.ok((await field.locator('.scene svg .patch').count()) > 50, 'the slice is drawn');

  await measured(page, w, await simulated(world, plan.bytes, 8));
  await field.getByLabel(w.before).last().setInputFiles(json('before.json', result.bytes));
  await shows(field, w.moved);
  await shows(field, w.sure);
  assert.equal(await field.locator('.scene').count(), 2, 'both beside each other');
  const scales = await field.locator('.scene-scale .ends').allInnerTexts();
  assert.equal(scales[0], scales[1], 'on one scale');

  const line = of_panel(page, 'volume-line');
  await shows(line, w.systematic);
  await line.getByLabel(w.line, { exact: true }).selectOption('PPP-NNN');
  await shows(line, /PPP-NNN/);
  const tables = of_panel(page, 'volume-tables');
  for (const id of ['axis-csv', 'general-csv', 'twincat-cnc']) {
    await tables.getByLabel(w.which, { exact: true }).selectOption(id);
    await tables.getByRole('button', { name: w.save }).and(page.locator(':enabled')).waitFor();
    const table = await downloaded(page, () => tables.getByRole('button', { name: w.save }).click());
    assert.ok(table.bytes.length > 200, id);
  }
  await tables.getByLabel(w.which, { exact: true }).selectOption('axis-csv');
  await shows(tables.locator('pre'), /with these tables, predicted/);
  await table_of_one_axis(page, w);
  assert.equal((await world.api('GET', '/api/tests')).total, 0, 'nothing is kept');
  return { page, result };
}

const of_theme = (theme, width) => async (world) => {
  const w = words['en-GB'];
  const page = await opened(world, { theme, width });
  const plan = await planned(page, w, '24');
  await measured(page, w, await simulated(world, plan.bytes, 7));
  await shows(of_panel(page, 'volume-field'), w.slice_told);
  await shows(of_panel(page, 'volume-line'), w.systematic);
  assert.deepEqual(await axe_findings(page), []);
  assert.ok((await sideways(page)) <= 0, 'nothing is wider than the window');
};

export const volume = {
  async 'volume: from the machine to errors, slices, before and after and tables'(world) {
    const { page, result } = await whole_way(world, 'en-GB');
    // A result that was taken along is looked at again on another day.
    await page.reload();
    assert.equal(await of_panel(page, 'volume-machine').getByLabel('Name', { exact: true }).first().inputValue(), 'Mill 5', 'what was typed stays');
    await page.getByLabel('Open a result').last().setInputFiles(json('wrong.json', '{"errors": 3}'));
    await shows(page.getByRole('alert'), /errors/);
    await page.getByLabel('Open a result').last().setInputFiles(json('mill.result.json', result.bytes));
    await shows(of_panel(page, 'volume-found'), 'All 21 errors found');
    await shows(of_panel(page, 'volume-field'), /Slice at Z/);
  },

  async 'volume: the same in German, with decimal commas'(world) {
    await whole_way(world, 'de-DE');
  },

  async 'volume: what one tool does not tell has no number, and it is said why, before and after measuring'(world) {
    const page = await opened(world);
    for (const name of ['T3', 'T2']) await page.getByRole('button', { name: `Remove: ${name}` }).click();
    await page.getByLabel('Points per station and tool').fill('60');
    await page.getByRole('button', { name: 'Make the plan' }).click();
    await shows(of_panel(page, 'volume-plan'), /\d+ of 21 errors will be told/);
    await shows(of_panel(page, 'volume-plan'), /same tool point/);
    const plan = await downloaded(page, () => page.getByRole('button', { name: 'Plan JSON' }).click());
    await page.getByLabel('Choose lengths', { exact: true }).last().setInputFiles(await simulated(world, plan.bytes, 7));
    await shows(of_panel(page, 'volume-found'), /\d+ of 21 errors found/);
    await shows(of_panel(page, 'volume-found'), 'volumetric-unseen-errors');
    assert.ok((await page.locator('.curve .untold').count()) > 0);
    await shows(of_panel(page, 'volume-errors'), 'no number');
    await shows(of_panel(page, 'volume-tables'), /found/);
  },

  async 'volume: a machine is saved and opened again, built otherwise, with stations that are given'(world) {
    const page = await opened(world);
    const machine = of_panel(page, 'volume-machine');
    await machine.getByLabel('How it is built').selectOption('ZFXY');
    await attribute_shows(page.locator('svg.chain'), 'aria-label', /workpiece → Z → bed → X → Y → tool/);
    await machine.getByLabel('How it is built').selectOption('other');
    await machine.getByLabel('Link 1').selectOption('X');
    await shows(machine, 'X, Y, Z and the bed once each');
    assert.ok(await page.getByRole('button', { name: 'Make the plan' }).isDisabled());
    await machine.getByLabel('Link 3').selectOption('Z');
    await page.getByLabel('Stations', { exact: true }).selectOption('given');
    for (const [k, axis] of ['X', 'Y', 'Z'].entries()) await page.getByRole('group', { name: 'Station S1' }).first().getByLabel(axis, { exact: true }).fill(String([-100, -50, -700][k]));
    const saved = await downloaded(page, () => page.getByRole('button', { name: 'Save machine.json' }).click());
    assert.deepEqual([JSON.parse(saved.bytes).chain, JSON.parse(saved.bytes).stations_mm], ['XFZY', { S1: [-100, -50, -700] }]);
    await page.getByRole('button', { name: 'Begin anew' }).click();
    assert.equal(await machine.getByLabel('How it is built').inputValue(), 'XFYZ');
    await page.getByLabel('Open machine.json').last().setInputFiles(json('no.json', '[1]'));
    await shows(page.getByRole('alert'), /found no chain/);
    await page.getByLabel('Open machine.json').last().setInputFiles(json('null.json', '{"chain": "XFYZ", "travel_mm": null, "tools_mm": {}}'));
    await shows(page.getByRole('alert'), /found no travel_mm/);
    await page.getByLabel('Open machine.json').last().setInputFiles(json('number.json', '{"name": 5, "chain": "XFYZ", "travel_mm": {}, "tools_mm": {}}'));
    await page.waitForFunction(() => document.querySelector('input[list="volume-machines"]')?.value === '5');
    await page.getByLabel('Open machine.json').last().setInputFiles(json('mill.json', saved.bytes));
    await page.waitForFunction(() => document.querySelector('svg.chain').getAttribute('aria-label').includes('workpiece → X → bed → Z → Y → tool'));
    await page.getByRole('button', { name: 'Make the plan' }).click();
    await shows(of_panel(page, 'volume-plan'), 'volumetric-few-stations');
  },

  'volume: axe finds nothing in a plan and a result, light, 1280 px': of_theme('light', 1280),
  'volume: axe finds nothing in a plan and a result, dark, 390 px': of_theme('dark', 390),
};
