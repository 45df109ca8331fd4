// SPDX-License-Identifier: Apache-2.0
// From a kept test to the table that corrects its axis, and to the test that proves it.
import assert from 'node:assert/strict';
import { build } from 'esbuild';
import { fileURLToPath } from 'node:url';
import { added_by, comp_file, figure, given, kept_table, measured, milled, targets, with_reason } from './table_world.mjs';
import { downloaded, shows } from './world.mjs';

const folder = fileURLToPath(new URL('../src/components/chart/', import.meta.url));
const { outputFiles } = await build({ stdin: { contents: "export { rooms_of } from './marks';", resolveDir: folder, loader: 'ts' }, bundle: true, format: 'esm', write: false });
const { rooms_of } = await import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString('base64')}`);

export const tables = {
  async 'tables: the control that the machine names is taken, and before and predicted stand over each other'(world) {
    await milled(world, 'LinuxCNC 2.9');
    const test = await measured(world, '2026-03-02');
    const page = await world.page();
    await page.goto(`/tests/${test}`);
    await page.getByRole('link', { name: 'Correct the axis' }).click();
    await shows(page.locator('h1'), 'Correct axis X');
    await shows(page.locator('.chosen-control'), /LinuxCNC, COMP_FILE_TYPE 0[\s\S]*guessed from “LinuxCNC 2\.9” of the machine[\s\S]*where the axis really was/);
    await shows(page.locator('.table-results'), /Predicted[\s\S]*8 \(table\)|Predicted[\s\S]*8 \(file\)/);
    const { shown } = await world.api('GET', `/api/tests/${test}`);
    const E = shown.find(({ parameter }) => parameter === 'E');
    assert.equal(await figure(page, 'E', 'Before'), Number(E.value));
    assert.ok(await figure(page, 'E', 'Predicted') < 0.2 * Number(E.value));
    assert.ok(await figure(page, 'E', '95 % below') > await figure(page, 'E', 'Predicted'));
    await shows(page.locator('.table-results'), /at each target, once the zero is shifted by [−-]?[\d.]+ µm, if the axis stays as it is\.[\s\S]*Anywhere between the first target and the last/);
    await shows(page.locator('.table-results'), /On how well positions are known[\s\S]*The calibration of the instrument is not in [\s\S]*repeats from target to target alike/);
    assert.equal(await page.locator('.table-results .mark').count(), 2, 'a verdict at E and at A as they were measured, none at a prediction');
    await shows(page.locator('main'), /Verified of this format[\s\S]*Inferred, not seen\s+nothing/);
    const file = await downloaded(page, () => page.getByRole('button', { name: 'Download' }).click());
    assert.equal(file.bytes.toString(), (await page.locator('.listing pre').nth(1).textContent()), 'what is downloaded is what is shown');
    assert.equal(file.bytes.toString().trim().split('\n').length, targets.length);
    const chart = page.locator('.chart').first();
    await chart.focus();
    await page.keyboard.press('ArrowRight');
    await shows(chart.locator('.tip'), /Before ↑[\s\S]*Before ↓[\s\S]*Predicted ↑[\s\S]*Predicted ↓/);
  },

  async 'tables: a control is searched and chosen by keys alone, and remembered for the machine'(world) {
    await milled(world, '');
    const test = await measured(world, '2026-03-02');
    const page = await world.page();
    await page.goto(`/tests/${test}/table`);
    await shows(page.locator('main'), 'Choose the control of the machine');
    assert.equal(await page.locator('.listing').count(), 0, 'no control, no file');
    await page.getByRole('combobox', { name: 'Search a control' }).focus();
    await page.keyboard.type('840d eec');
    await shows(page.locator('.control-search [role=status]'), '1 control.');
    await page.keyboard.press('Enter');
    await shows(page.locator('.chosen-control'), /leadscrew errors \(EEC\)/);
    await shows(page.locator('.listing'), /\$AA_ENC_COMP/);
    await shows(page.locator('.table-results'), 'the reversal error stays as it is');
    await page.reload();
    await shows(page.locator('.chosen-control'), /EEC[\s\S]*as chosen last for this machine/);
    await page.getByRole('button', { name: 'Another…' }).click();
    await page.locator('.control-search input:focus').waitFor();
    await page.keyboard.type('no such control');
    await shows(page.locator('.control-search'), 'No control is called “no such control”.');
    await page.keyboard.press('Escape');
    await shows(page.locator('.chosen-control'), /EEC/);
  },

  async 'tables: every control makes a table of an axis, or says what it would need; only what it has a use for is offered'(world) {
    await milled(world, '');
    const test = await measured(world, '2026-03-02');
    const controls = await world.api('GET', '/api/controls');
    const page = await world.page();
    await page.goto(`/tests/${test}/table`);
    const names = { number: 'Number', resolution: /^One count/, magnification: 'Magnification', largest: 'Largest number', steps_per_unit: /^Steps now/ };
    for (const control of controls.filter(({ limits }) => limits.linear)) {
      if (await page.getByRole('button', { name: 'Another…' }).count() > 0) await page.getByRole('button', { name: 'Another…' }).click();
      await page.getByRole('combobox', { name: 'Search a control' }).fill(control.title);
      await page.getByRole('option').filter({ has: page.getByText(control.title, { exact: true }) }).click();
      await shows(page.locator('.chosen-control'), control.title);
      await page.waitForFunction((id) => document.querySelector('.table-outcome')?.getAttribute('aria-busy') === 'false' && id, control.id);
      await page.locator('.listing, .table-outcome .notice.bad').first().waitFor();
      const made = await page.locator('.listing').count() === 1;
      const refused = await page.locator('.table-outcome .notice.bad').allInnerTexts();
      assert.ok(made !== (refused.length > 0), `${control.id}: ${refused}`);
      for (const text of refused) assert.doesNotMatch(text, /--[a-z]/, `${control.id}: a flag of the command line on the page`);
      if (await page.locator('details.more[open]').count() === 0) await page.locator('details.more summary').click();
      for (const [key, label] of Object.entries(names))
        assert.equal(await page.locator('.table-options').getByLabel(label, { exact: true }).count(), control.options.includes(key) ? 1 : 0, `${control.id}: ${key}`);
      // What is offered is taken: an inch that a control does not know is not there to be ticked.
      const inch = page.getByLabel('the control counts in inches');
      if (made && await inch.count() === 1) {
        const before = await page.locator('.listing').innerText();
        await inch.check();
        await page.waitForFunction((text) => { const now = document.querySelector('.table-outcome'); return now?.getAttribute('aria-busy') === 'false' && document.querySelector('.listing')?.innerText !== text; }, before)
          .catch(() => { throw new Error(`${control.id}: inches change nothing`); });
        assert.equal(await page.locator('.table-outcome .notice.bad').count(), 0, `${control.id}: ${await page.locator('.table-outcome .notice.bad').allInnerTexts()}`);
        await inch.uncheck();
      }
    }
  },

  async 'tables: a wrong field is told where it is, a refused grid in the words of the program, and neither leaves a file'(world) {
    await milled(world, 'LinuxCNC');
    const test = await measured(world, '2026-03-02');
    const page = await world.page();
    await page.goto(`/tests/${test}/table`);
    await page.locator('.listing').waitFor();
    await page.locator('details.more summary').click();
    const step = page.getByLabel('Spacing / mm');
    for (const [text, told] of [['0', 'above 0'], ['-5', 'above 0'], ['ten', 'expected a number']]) {
      await step.fill(text);
      await shows(page.locator('.table-options'), `found “${text}”, expected a number`);
      await shows(page.locator('.table-options'), told);
      await page.locator('.listing').waitFor({ state: 'detached' });
      assert.equal(await page.getByRole('button', { name: 'Keep' }).count(), 0);
    }
    await step.fill('1000');
    await shows(page.locator('.table-outcome .notice.bad'), /No table is made of this[\s\S]*found/);
    assert.equal(await page.locator('.listing').count(), 0);
    await step.fill('25');
    await shows(page.locator('.table-results h2'), /21 positions from 0 to 500 mm/);
    assert.equal(await page.locator('.nodes tbody tr').count(), 21);
    await shows(page.locator('details.more summary'), '1 option other than usual');
    await page.getByRole('button', { name: 'As usual' }).click();
    await page.waitForFunction(() => document.querySelectorAll('.nodes tbody tr').length === 6);
  },

  async 'tables: measured, corrected, measured again: the chain is kept, on the pages of test, table and axis'(world) {
    await milled(world, 'LinuxCNC');
    const test = await measured(world, '2026-03-02');
    const page = await world.page();
    await page.goto(`/tests/${test}/table`);
    await page.locator('.listing').waitFor();
    await page.getByRole('button', { name: 'Keep' }).click();
    await page.getByRole('dialog').getByLabel('Notes').fill('before the fair');
    await page.getByRole('dialog').getByRole('button', { name: 'Keep' }).click();
    await shows(page.locator('h1'), 'Table 1: LinuxCNC, COMP_FILE_TYPE 0');
    await shows(page.locator('.compensation-chain'), /Measured\s[\s\S]*2026-03-02[\s\S]*Table[\s\S]*Only a re-test proves the table/);
    await shows(page.locator('main'), 'before the fair');
    const { result, table } = await world.api('GET', '/api/compensations/1');
    const file = await downloaded(page, () => page.locator('.table-file').getByRole('link', { name: 'Download' }).click());
    assert.equal(file.bytes.toString(), table);
    const earlier = await measured(world, '2026-02-01');
    const wrong = await measured(world, '2026-03-05', (x, way) => -added_by(result.table, x, way));
    const retest = await measured(world, '2026-03-09', (x, way) => added_by(result.table, x, way));
    await page.getByRole('button', { name: 'Choose the re-test…' }).click();
    await shows(page.getByRole('dialog'), /On the day of the test or later[\s\S]*2026-03-05[\s\S]*2026-03-09[\s\S]*Earlier, or undated[\s\S]*2026-02-01/);
    assert.equal(await page.getByRole('radio').count(), 3, 'not the test itself');
    await page.getByRole('radio', { name: /2026-03-05/ }).check();
    await with_reason(page, 'Save as version 2', 'loaded on Tuesday');
    await shows(page.locator('.table-results'), /Serious[\s\S]*sign mistake/);
    await page.getByRole('button', { name: 'Another…' }).click();
    await page.getByRole('radio', { name: /2026-03-09/ }).check();
    await with_reason(page, 'Save as version 3', 'sign put right');
    await shows(page.locator('.compensation-chain'), /Measured again[\s\S]*2026-03-09[\s\S]*% ± \d+ % of the table act/);
    await shows(page.locator('.table-results'), /The table does what it should/);
    assert.ok(await figure(page, 'E', 'Re-test') < 0.2 * await figure(page, 'E', 'Before'));
    await shows(page.locator('.legend').first(), 'Re-test');
    await page.goto(`/tests/${retest}`);
    await shows(page.locator('.tables-of-test'), /This test is the re-test of[\s\S]*Table 1/);
    await page.goto(`/tests/${test}`);
    await shows(page.locator('.tables-of-test'), /Made of this test[\s\S]*Table 1[\s\S]*Re-test: [\s\S]*2026-03-09/);
    await page.goto(`/tests/${earlier}`);
    await shows(page.locator('.archive-panel').first(), /Versions|Documents/);
    assert.equal(await page.locator('.tables-of-test').count(), 0);
    const { axis } = await world.api('GET', `/api/tests/${test}`);
    await page.goto(`/axes/${axis.id}`);
    await shows(page.locator('main'), /Tables of compensation[\s\S]*Table 1[\s\S]*E \d+\.\d → \d+\.\d µm/);
    await shows(page.locator('.trend'), 'Lines from top to bottom: a table was made of the test before them.');
    const chart = page.locator('.trend .chart');
    await chart.focus();
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('ArrowRight');
    await shows(chart.locator('.tip'), /2026-03-02[\s\S]*table 1 was made of it \(LinuxCNC\)/);
    await page.keyboard.press('End');
    await shows(chart.locator('[aria-live]'), /2026-03-09[\s\S]*re-test of table 1 \(LinuxCNC\)/);
    const { machine } = await world.api('GET', `/api/tests/${test}`);
    await page.goto(`/machines/${machine.id}`);
    await shows(page.locator('.trend'), 'Lines from top to bottom: a table was made of the test before them.');
    const of_machine = page.locator('.trend .chart');
    await of_machine.focus();
    await page.keyboard.press('End');
    await shows(of_machine.locator('[aria-live]'), /2026-03-09[\s\S]*re-test of table 1 \(LinuxCNC\)/);
    await page.goto('/compensations');
    await shows(page.locator('.list-page'), /Table 1[\s\S]*Mill 9, X/);
    assert.equal(wrong > test, true);
  },

  async 'tables: a re-test that was withdrawn since is marked wherever the table stands, and nothing of it counts'(world) {
    await milled(world, 'LinuxCNC');
    const test = await measured(world, '2026-03-02');
    const { result } = await kept_table(world, test, { control: 'linuxcnc' });
    const retest = await measured(world, '2026-03-09', (x, way) => added_by(result.table, x, way));
    await world.api('POST', '/api/compensations/1/versions', { base_version: 1, retest, reason: 're-test' });
    const page = await world.page();
    await page.goto('/compensations/1');
    await shows(page.locator('.table-results'), /Before, predicted, measured again[\s\S]*The table does what it should/);
    await world.api('POST', `/api/tests/${retest}/withdraw`, { reason: 'the mirror was loose' });
    await page.reload();
    await shows(page.locator('.compensation-chain'), /Measured again[\s\S]*withdrawn[\s\S]*What was found with it does not count\./);
    await shows(page.locator('.table-results'), /The re-test, test 2, is withdrawn/);
    assert.doesNotMatch(await page.locator('.table-results').innerText(), /does what it should|Re-test/);
    assert.doesNotMatch(await page.locator('.legend').first().innerText(), /Re-test/);
    await page.goto('/compensations');
    await shows(page.locator('.list-page'), /E \d+\.\d → \d+\.\d µm predicted[\s\S]*1 serious finding[\s\S]*withdrawn/);
    await page.goto(`/tests/${test}`);
    await shows(page.locator('.tables-of-test'), /1 serious finding[\s\S]*Re-test: [\s\S]*withdrawn/);
  },

  async 'tables: the table that a re-test was measured with is part of the next one, unless someone says that it was not active'(world) {
    await milled(world, 'LinuxCNC');
    const test = await measured(world, '2026-03-02');
    const { result, table, file_name } = await kept_table(world, test, { control: 'linuxcnc' });
    const half = await measured(world, '2026-03-09', (x, way) => 0.9 * added_by(result.table, x, way));
    const page = await world.page();
    await page.goto(`/tests/${half}/table`);
    await shows(page.locator('main'), 'Table 1 was made for this axis before. Was it active while this test was measured?');
    assert.equal(await page.locator('.existing-file').count(), 0, 'nobody said that it was');
    await page.getByRole('button', { name: 'Take table 1' }).click();
    await shows(page.locator('.existing-file'), file_name);
    await world.api('POST', '/api/compensations/1/versions', { base_version: 1, retest: half, reason: 're-test' });
    await page.reload();
    await shows(page.locator('.existing-file'), file_name);
    await shows(page.locator('.chart-panel').nth(1), 'Existing table');
    await page.waitForFunction(() => document.querySelector('.table-outcome')?.getAttribute('aria-busy') === 'false' && document.querySelectorAll('.listing').length === 1);
    await page.getByRole('button', { name: 'Keep' }).click();
    await page.getByRole('dialog').getByRole('button', { name: 'Keep' }).click();
    await shows(page.locator('h1'), 'Table 2');
    const second = await world.api('GET', '/api/compensations/2');
    assert.ok(second.existing, 'the existing table is kept with it');
    const existing = await downloaded(page, () => page.locator('.table-files').getByRole('link', { name: second.existing.name }).last().click());
    assert.equal(existing.bytes.toString(), table);
    await page.goto(`/tests/${half}/table`);
    await page.locator('.existing-file').waitFor();
    await page.getByRole('button', { name: 'None was active' }).click();
    await shows(page.locator('main'), 'This test is the re-test of table 1, which was active while it was measured.');
  },

  async 'tables: an existing table is drawn as soon as it is there, and one that cannot be read stops the making'(world) {
    await milled(world, 'LinuxCNC');
    const test = await measured(world, '2026-03-02');
    const page = await world.page();
    await page.goto(`/tests/${test}/table`);
    await page.locator('.listing').waitFor();
    const input = page.locator('.file-drop input[type=file]');
    await input.setInputFiles(given('old.comp', comp_file([[0, 2, 3], [250, -1, 1], [500, 4, 5]])));
    await shows(page.locator('main'), 'The 3 positions of the existing table');
    const nodes = page.locator('.nodes').last();
    await nodes.locator('summary').click();
    // COMP_FILE_TYPE 0: where the axis was; 2 µm too far is taken off.
    await shows(nodes, /0\s+−2\.00\s+−3\.00/);
    await input.setInputFiles(given('old.comp', 'this is\nno table\n'));
    await shows(page.locator('.compensate-side .notice.bad'), /found/);
    await page.locator('.listing').waitFor({ state: 'detached' });
    await page.getByRole('button', { name: 'None was active' }).click();
    await page.locator('.listing').waitFor();
    await input.setInputFiles(given('huge.comp', '0'.repeat((1 << 20) + 1)));
    await shows(page.locator('.compensate-side .notice.bad'), 'expected is a table of at most 1.0 MB');
    await page.locator('.listing').waitFor({ state: 'detached' });
  },

  async 'tables: one that was dropped anywhere on the page is read by the control that can, or by the one that is chosen'(world) {
    const page = await world.page();
    await page.goto('/tables');
    await shows(page.locator('main'), 'Choose or drop the file of a table.');
    const drop = async (files, target) => {
      const data = await page.evaluateHandle((given) => { const all = new DataTransfer(); for (const [name, text] of given) all.items.add(new File([text], name)); return all; }, files);
      await page.dispatchEvent(target, 'drop', { dataTransfer: data });
    };
    await drop([['x.comp', comp_file([[0, 2, 3], [250, -1, 1], [500, 4, 5]])], ['other.comp', '0 0 0\n']], 'header.bar');
    await shows(page.locator('.chosen-control'), /LinuxCNC, COMP_FILE_TYPE 0[\s\S]*the only one that can read the file as it is/);
    assert.equal(new URL(page.url()).pathname, '/tables', 'it is not taken for a test');
    await shows(page.locator('main'), 'One file at a time: 1 other file was not taken.');
    const nodes = page.locator('.nodes');
    await nodes.locator('summary').click();
    await shows(nodes, /0\s+−2\.00\s+−3\.00/);
    await drop([['y.comp', 'nothing of it']], 'main');
    await shows(page.locator('main'), 'No control can read it as it is.');
    assert.equal(await nodes.count(), 0, 'not the table before');
    assert.doesNotMatch(await page.locator('main').innerText(), /One file at a time/);
    await page.getByRole('combobox', { name: 'Search a control' }).fill('FILE_TYPE 1');
    await page.keyboard.press('Enter');
    await shows(page.locator('.notice.bad'), /found[\s\S]*line 1/);
    // A trim is added, whatever the other type would make of the same line.
    await drop([['trims.comp', '0 0.002 0.003\n250 -0.001 0.001\n500 0.004 0.005\n']], 'main');
    await nodes.locator('summary').click();
    await shows(nodes, /0\s+2\.00\s+3\.00/);
  },

  async 'tables: what is refused as a test may be looked at as a table'(world) {
    const page = await world.page();
    await page.goto('/');
    const lines = ['%_N_AX_EEC_INI', 'CHANDATA(1)', ...[0, 1, 2].map((k) => `$AA_ENC_COMP[0,${k},X]=${(0.001 * k).toFixed(6)}`),
      '$AA_ENC_COMP_STEP[0,X]=100', '$AA_ENC_COMP_MIN[0,X]=0', '$AA_ENC_COMP_MAX[0,X]=200', '$AA_ENC_COMP_IS_MODULO[0,X]=0', 'M17'];
    await page.locator('.intake input[type=file]').setInputFiles(given('x.ini', lines.join('\n') + '\n'));
    await page.getByRole('button', { name: 'Look at it as a table of a control' }).click();
    await shows(page.locator('.chosen-control'), /EEC[\s\S]*the only one that can read the file as it is/);
    await shows(page.locator('main'), 'The 3 positions of the existing table');
  },

  async 'tables: notes, withdrawal and return are versions, and an old one says that it is'(world) {
    await milled(world, 'LinuxCNC');
    await kept_table(world, await measured(world, '2026-03-02'), { control: 'linuxcnc' });
    const page = await world.page();
    await page.goto('/compensations/1');
    await page.getByRole('button', { name: 'Notes…' }).click();
    await page.getByRole('dialog').getByLabel('Notes').fill('spare control');
    await with_reason(page, 'Save as version 2', 'to find it again');
    await shows(page.locator('main'), 'spare control');
    await page.getByRole('button', { name: 'Withdraw' }).click();
    await with_reason(page, 'Withdraw', 'screw replaced');
    await shows(page.locator('main'), 'This table was withdrawn.');
    for (const name of ['Notes…', 'Choose the re-test…'])
      assert.equal(await page.getByRole('button', { name }).isDisabled(), true, name);
    await page.goto('/compensations');
    await shows(page.locator('main'), 'No table is kept yet.');
    await page.getByLabel('with withdrawn ones').check();
    await page.getByRole('link', { name: /Table 1/ }).click();
    await page.getByRole('button', { name: 'Reinstate' }).click();
    await with_reason(page, 'Reinstate', 'it was another screw');
    await page.getByText('Versions (4)').click();
    await shows(page.locator('.history'), /it was another screw[\s\S]*screw replaced[\s\S]*to find it again/);
    await page.getByRole('link', { name: '1', exact: true }).click();
    await shows(page.locator('main'), 'This is version 1 of 4.');
    assert.equal(await page.getByRole('button', { name: 'Choose the re-test…' }).isDisabled(), true);
    await page.getByRole('link', { name: 'To the latest' }).click();
    // Somebody else was first: what was typed stays, and it is said.
    await page.getByRole('button', { name: 'Notes…' }).click();
    await page.getByRole('dialog').getByLabel('Notes').fill('mine');
    await world.api('POST', '/api/compensations/1/versions', { base_version: 4, notes: 'theirs', reason: 'first' });
    await with_reason(page, 'Save as version 5', 'second');
    await shows(page.getByRole('dialog'), 'Somebody else was first');
    assert.equal(await page.getByRole('dialog').getByLabel('Notes').inputValue(), 'mine');
  },

  async 'a press soon after a page was reached is not lost, whatever had the focus before'(world) {
    await milled(world, 'LinuxCNC');
    const test = await measured(world, '2026-03-02');
    const page = await world.page();
    for (let turn = 0; turn < 4; turn += 1) {
      await page.goto(`/tests/${test}`);
      await page.getByRole('link', { name: 'Correct the axis' }).click();
      await page.locator('.listing').waitFor();
      await page.locator('.chart').first().focus();
      await page.keyboard.press('ArrowRight');
      await page.locator('.chart .tip').waitFor();
      await downloaded(page, () => page.getByRole('button', { name: 'Download' }).click());
    }
  },

  async 'names of marks on a chart lie over no other name, and no line of a mark goes through a name'() {
    let seed = 1;
    const random = () => { seed = (seed * 48271) % 2147483647; return seed / 2147483647; };
    for (let turn = 0; turn < 2000; turn += 1) {
      const wide = 200 + 1000 * random();
      const marks = Array.from({ length: 1 + Math.floor(8 * random()) }, () => ({ at: 40 + (wide - 60) * random(), width: 30 + 120 * random() })).sort((a, b) => a.at - b.at);
      const rooms = rooms_of(marks, 3, [0, wide], 4);
      assert.equal(rooms.length, marks.length);
      rooms.forEach((room, i) => {
        if (room === null) return;
        assert.ok(room.left >= 0 && room.right <= wide && Math.abs(room.right - room.left - marks[i].width) < 1e-9);
        rooms.forEach((other, k) => {
          if (i === k || other === null) return;
          if (other.row === room.row) assert.ok(room.right <= other.left || other.right <= room.left, `turn ${turn}: names ${i} and ${k}`);
          if (other.row >= room.row) assert.ok(marks[k].at < room.left || marks[k].at > room.right, `turn ${turn}: the line of ${k} through the name of ${i}`);
        });
      });
    }
    assert.deepEqual(rooms_of([{ at: 100, width: 50 }], 1, [0, 400], 4), [{ row: 0, left: 104, right: 154 }]);
    assert.equal(rooms_of([{ at: 390, width: 50 }], 1, [0, 400], 4)[0].right, 386, 'at the right end it stands left of its line');
    assert.equal(rooms_of([{ at: 20, width: 500 }], 3, [0, 400], 4)[0], null);
  },
};
