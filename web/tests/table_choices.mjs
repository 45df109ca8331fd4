// SPDX-License-Identifier: Apache-2.0
// What a table of a control leaves open, chosen on the page that corrects an axis: the periodic part, curves, sign, units.
import assert from 'node:assert/strict';
import { added_by, figure, given, measured, milled, with_reason } from './table_world.mjs';
import { axe_findings, shows, sideways } from './world.mjs';

/** What a screw adds with a pitch of 10 mm, and targets that tell it. */
const of_screw = (x) => 2 * Math.sin((2 * Math.PI * x) / 10);
const dense_targets = Array.from({ length: 41 }, (_, k) => 12 * k + ((k * 7) % 5));

/** Chooses a control by words of its title on the page that corrects an axis. */
async function with_control(page, words, title) {
  await page.locator('.chosen-control, .control-search').first().waitFor();
  const another = page.getByRole('button', { name: 'Another…' });
  if (await another.count() > 0) await another.click();
  await page.getByRole('combobox', { name: 'Search a control' }).fill(words);
  await page.keyboard.press('Enter');
  await shows(page.locator('.chosen-control'), title);
}

/** Waits until what is shown was made of what is chosen. */
const made_anew = (page) => page.waitForFunction(() => document.querySelector('.table-outcome')?.getAttribute('aria-busy') === 'false' && document.querySelectorAll('.listing').length === 1);

const nodes_shown = (page) => page.locator('.nodes').first().evaluate((details) => [...details.querySelectorAll('tbody tr')].map((row) => row.textContent));

/** Keeps what is shown; its number in the archive. */
async function keeps(page) {
  await made_anew(page);
  await page.getByRole('button', { name: 'Keep' }).click();
  await page.getByRole('dialog').getByRole('button', { name: 'Keep' }).click();
  await shows(page.locator('h1'), /^Table \d+/);
  return Number(new URL(page.url()).pathname.split('/').pop());
}

export const table_choices = {
  async 'tables: the periodic part is left out where its period is known, says so, and stays so in every version of what is kept'(world) {
    await milled(world, 'LinuxCNC');
    const page = await world.page();
    const untold = await measured(world, '2026-03-02', of_screw, { at: dense_targets });
    await page.goto(`/tests/${untold}/table`);
    await made_anew(page);
    await page.locator('details.more summary').click();
    const [part, period] = [page.getByLabel('Periodic part'), page.getByLabel('Period / mm')];
    await part.selectOption({ label: 'leave it out of the table' });
    await shows(page.locator('.table-options'), 'expected the period to leave out: the test tells none');
    assert.equal(await period.getAttribute('aria-invalid'), 'true');
    await page.locator('.listing').waitFor({ state: 'detached' });
    assert.equal(await page.getByRole('button', { name: 'Keep' }).count(), 0);
    for (const text of ['0', '-10', 'ten']) {
      await period.fill(text);
      await shows(page.locator('.table-options'), `found “${text}”, expected a number`);
    }
    await period.fill('10');
    await made_anew(page);
    await shows(page.locator('.table-results'), /The periodic part with a period of 10 mm, of an amplitude of [\s\S]*is not in the table: it stays, and is in what is predicted/i);
    await shows(page.locator('details.more summary'), '2 options other than usual');
    // Kept in the table, at positions that cannot follow it, it is told by the names of the fields and not by flags.
    await part.selectOption({ label: 'keep it in the table' });
    await made_anew(page);
    await shows(page.locator('.table-results'), /the part can be left out of it/);
    // The test tells the period: nothing is asked for, and an amplitude is taken out of the table.
    const told = await measured(world, '2026-03-03', of_screw, { at: dense_targets, axis: { expected_period: 10 } });
    await page.goto(`/tests/${told}/table`);
    await made_anew(page);
    await page.locator('details.more summary').click();
    assert.equal(await page.getByLabel('Period / mm').getAttribute('placeholder'), '10');
    await shows(page.locator('.table-options'), 'empty: as the test says');
    const with_it = await nodes_shown(page);
    await page.getByLabel('Periodic part').selectOption('leave');
    await shows(page.locator('.table-results'), /is not in the table/);
    await made_anew(page);
    assert.notDeepEqual(await nodes_shown(page), with_it);
    const id = await keeps(page);
    await shows(page.locator('.table-files'), 'Periodic part: leave it out of the table');
    await page.getByRole('button', { name: 'Notes…' }).click();
    await page.getByRole('dialog').getByLabel('Notes').fill('screw stays as it is');
    await with_reason(page, 'Save as version 2', 'said so');
    await shows(page.locator('main'), 'screw stays as it is');
    await shows(page.locator('.table-files'), 'Periodic part: leave it out of the table');
    const { options, versions } = await world.api('GET', `/api/compensations/${id}`);
    assert.deepEqual([options.periodic, versions.length], ['leave', 2]);
  },

  async 'tables: a control with a number beside one curve may use it, others do not offer it'(world) {
    await milled(world, 'SINUMERIK 828D');
    const test = await measured(world, '2026-03-02');
    const page = await world.page();
    await page.goto(`/tests/${test}/table`);
    await made_anew(page);
    await shows(page.locator('.table-results'), 'the reversal error stays as it is');
    const before = await figure(page, 'B', 'Predicted');
    await page.locator('details.more summary').click();
    const curves = page.getByLabel('Curves');
    assert.deepEqual(await curves.locator('option').allInnerTexts(), ['one for both directions', 'one curve, and MD32450 beside it']);
    await curves.selectOption('with-backlash');
    await shows(page.locator('.table-options'), 'MD32450 stands at the head of the file, and the prediction counts on it. Enter it by hand');
    await shows(page.locator('.listing'), /MD32450 = its value while the axis was measured \+ /);
    await made_anew(page);
    assert.ok(await figure(page, 'B', 'Predicted') < 0.5 * before, 'the prediction counts on it');
    await shows(page.locator('main'), 'With one curve, and a number for the reversal beside it, the head of the file says');
    const id = await keeps(page);
    await shows(page.locator('.table-files'), 'Curves: one curve, and a number for the reversal beside it');
    assert.equal((await world.api('GET', `/api/compensations/${id}`)).options.curves, 'with-backlash');
    await page.goto(`/tests/${test}/table`);
    for (const { id, title, limits, backlash } of (await world.api('GET', '/api/controls')).filter(({ limits }) => limits.linear)) {
      await with_control(page, title, title);
      if (await page.locator('details.more[open]').count() === 0) await page.locator('details.more summary').click();
      const values = await curves.locator('option').evaluateAll((all) => all.map(({ value }) => value));
      const wanted = [...(limits.curves === 'both-ways' ? [] : ['both-ways']), ...(limits.curves !== 'with-backlash' && backlash !== '' ? ['with-backlash'] : [])];
      assert.deepEqual(values, wanted.length === 0 ? [] : ['', ...wanted], id);
    }
  },

  async 'tables: only an inferred sign can be turned, with a warning; the table, and the one before it, have the other one then'(world) {
    await milled(world, 'HEIDENHAIN');
    const test = await measured(world, '2026-03-02');
    const controls = await world.api('GET', '/api/controls');
    const page = await world.page();
    await page.goto(`/tests/${test}/table`);
    const turn = page.getByLabel('turn the sign');
    for (const { id, title, options, turned_sign } of controls.filter(({ limits }) => limits.linear)) {
      await with_control(page, title, title);
      assert.equal(await turn.count(), turned_sign === '' ? 0 : 1, id);
      assert.equal(options.includes('turned_sign'), turned_sign !== '', id);
    }
    await with_control(page, 'HEIDENHAIN', 'HEIDENHAIN');
    const { sign, turned_sign } = controls.find(({ id }) => id === 'heidenhain');
    await shows(page.locator('.chosen-control'), sign);
    await shows(page.locator('.turned-sign'), 'was inferred, not seen. Turn it only where a re-test has shown a doubled error.');
    await made_anew(page);
    const numbers = async () => (await page.locator('.listing pre').nth(1).textContent()).split('\n').filter((line) => /^\s*[-\d]/.test(line)).map((line) => line.trim().split(/\s+/).slice(-1).map(Number)[0]);
    const [inferred, added] = [await numbers(), await nodes_shown(page)];
    await turn.check();
    await shows(page.locator('.turned-sign [role=status]'), 'the table doubles the error: only a re-test tells');
    assert.equal(await turn.evaluate((box) => document.getElementById(box.getAttribute('aria-describedby')).className), 'notice caution');
    await shows(page.locator('.chosen-control'), turned_sign);
    await shows(page.locator('.table-results'), 'is turned against what was inferred');
    await made_anew(page);
    assert.ok(inferred.some((value) => value !== 0));
    assert.deepEqual((await numbers()).map((value) => value + 0), inferred.map((value) => 0 - value));
    assert.deepEqual(await nodes_shown(page), added, 'what the control adds stays the same');
    const id = await keeps(page);
    await shows(page.locator('.table-files'), 'the sign is turned');
    await shows(page.locator('.about-format'), turned_sign);
    // Who takes that table for the next one takes its sign with it: the file of this control cannot say it.
    const { result } = await world.api('GET', `/api/compensations/${id}`);
    assert.equal(result.turned_sign, true);
    const later = await measured(world, '2026-03-09', (x, way) => 0.7 * added_by(result.table, x, way));
    await page.goto(`/tests/${later}/table`);
    await made_anew(page);
    assert.equal(await turn.isChecked(), false, 'nobody said so');
    await page.getByRole('button', { name: `Take table ${id}` }).click();
    await shows(page.locator('.chosen-control'), turned_sign);
    assert.equal(await turn.isChecked(), true);
    await made_anew(page);
    const second = (await world.api('GET', `/api/compensations/${await keeps(page)}`)).result;
    second.existing.forEach(({ up }, k) => assert.ok(Math.abs(up - result.table[k].up) < 0.01, `node ${k}`));
  },

  async 'tables: an existing table in the other unit is refused until its unit is said, where the control may count in inches'(world) {
    await milled(world, 'LinuxCNC');
    const test = await measured(world, '2026-03-02');
    const page = await world.page();
    await page.goto(`/tests/${test}/table`);
    await made_anew(page);
    const unit = page.getByLabel('Unit of the existing table');
    assert.equal(await unit.count(), 0, 'there is none');
    const in_inch = [[0, 2, 3], [250, -1, 1], [500, 4, 5]].map(([x, forward, reverse]) => [x, x + forward / 1000, x + reverse / 1000].map((value) => (value / 25.4).toFixed(8)).join(' ')).join('\n') + '\n';
    await page.locator('.file-drop input[type=file]').setInputFiles(given('inches.comp', in_inch));
    await shows(page.locator('.table-outcome .notice.bad'), /which it would fit in inches[\s\S]*or the unit of the existing table stated/);
    assert.equal(await page.locator('.listing').count(), 0);
    await unit.selectOption('inch');
    await shows(page.locator('main'), 'The 3 positions of the existing table');
    await made_anew(page);
    const nodes = page.locator('.nodes').last();
    await nodes.locator('summary').click();
    await shows(nodes, /0\s+−2\.00\s+−3\.00[\s\S]*500\s+−4\.00\s+−5\.00/);
    await shows(page.locator('details.more summary'), 'as usual');
    const id = await keeps(page);
    await shows(page.locator('.table-files'), 'Unit of the existing table: inch');
    assert.equal((await world.api('GET', `/api/compensations/${id}`)).options.existing_unit, 'inch');
    await page.goto(`/tests/${test}/table`);
    const two = await page.evaluateHandle(() => { const all = new DataTransfer(); for (const name of ['old.comp', 'other.comp']) all.items.add(new File(['nothing of it\n'], name)); return all; });
    await page.locator('.file-drop').waitFor();
    await page.dispatchEvent('header.bar', 'drop', { dataTransfer: two });
    await shows(page.locator('.existing-file'), 'old.comp');
    await shows(page.locator('.file-drop'), 'One file at a time: 1 other file was not taken.');
    for (const { id, title, options } of (await world.api('GET', '/api/controls')).filter(({ limits }) => limits.linear)) {
      await with_control(page, title, title);
      assert.equal(await unit.count(), options.includes('inch') ? 1 : 0, id);
    }
  },

  async 'tables: the choices of a table speak German, and axe finds nothing in them'(world) {
    await milled(world, 'HEIDENHAIN');
    const page = await world.page({ locale: 'de-DE' });
    await page.goto(`/tests/${await measured(world, '2026-03-02')}/table`);
    await page.locator('details.more summary').click();
    await page.getByLabel('Vorzeichen umdrehen').check();
    await shows(page.locator('.chosen-control'), 'gegen das Erschlossene gedreht');
    await shows(page.locator('.turned-sign'), 'verdoppelt die Tabelle den Fehler');
    await page.getByLabel('Periodischer Anteil').selectOption({ label: 'aus der Tabelle weglassen' });
    await shows(page.locator('.table-options'), 'erwartet wird die Periode, die wegbleiben soll');
    await page.getByLabel('Periode / mm').fill('10,5');
    await made_anew(page);
    await page.locator('.file-drop input[type=file]').setInputFiles(given('alt.com', 'nichts\n'));
    await page.locator('.listing').waitFor({ state: 'detached' });
    await page.getByLabel('Einheit der vorhandenen Tabelle').selectOption({ label: 'Zoll' });
    await page.getByLabel('Kurven').selectOption({ label: 'eine Kurve für beide Richtungen' });
    await shows(page.locator('.compensate-side .notice.bad'), /\S/);
    assert.equal(await page.locator('.listing').count(), 0);
    assert.deepEqual(await axe_findings(page), []);
    assert.equal(await sideways(page), 0);
    await page.getByRole('button', { name: 'Keine war aktiv' }).click();
    await made_anew(page);
    await page.getByRole('button', { name: 'Speichern' }).click();
    await page.getByRole('dialog').getByRole('button', { name: 'Speichern' }).click();
    await shows(page.locator('.table-files'), /Periode \/ mm: 10,5[\s\S]*Kurven: eine Kurve für beide Richtungen[\s\S]*Periodischer Anteil: aus der Tabelle weglassen[\s\S]*Vorzeichen umgedreht/);
    assert.deepEqual(await axe_findings(page), []);
  },
};
