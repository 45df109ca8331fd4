// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { downloaded, shows } from './world.mjs';

export const plan = {
  async 'a plan answers while one types, is saved in versions and gives its program'(world) {
    const page = await world.page();
    await page.goto('/plans/new');
    const targets = page.getByRole('table').locator('tbody tr');
    await shows(page.locator('.figures'), /Targets\s*5/);
    await page.getByLabel('to (mm)').fill('1000');
    await shows(page.locator('.figures'), /Targets\s*5/);
    await page.getByRole('combobox', { name: 'Targets', exact: true }).selectOption('count');
    await page.getByLabel('Number of targets').fill('9');
    await shows(page.locator('.figures'), /Targets\s*9/);
    assert.equal(await targets.count(), 9);
    await page.getByLabel('Runs', { exact: true }).fill('2');
    await shows(page.locator('.outcome'), 'departs from ISO 230-2:2014');
    await page.getByLabel('Runs', { exact: true }).fill('zwei');
    await shows(page.locator('.plan-form'), 'found "zwei", expected a number');
    assert.equal(await targets.count(), 9, 'the last good plan stays');
    await page.getByLabel('Runs', { exact: true }).fill('5');
    await page.getByLabel('Title').fill('Mill X, spring');
    await page.getByRole('button', { name: 'Save', exact: true }).click();
    await page.waitForURL(/\/plans\/\d+$/);
    await shows(page.locator('h1'), 'Mill X, spring');
    await page.getByLabel('Dwell (s)').fill('4');
    await page.getByRole('button', { name: 'Save version 2' }).click();
    await shows(page.locator('main'), /Version 2/);

    await page.getByLabel('Control', { exact: true }).selectOption('linuxcnc');
    await shows(page.locator('.listing'), /G1 X/);  // of whichever control: no other's program has this one's name
    const program = await downloaded(page, () => page.getByRole('button', { name: /Download/ }).click());
    assert.match(program.name, /\.ngc$/);
    assert.match(program.bytes.toString(), /G4 P4(\.0)?\b/);
    await page.getByLabel('in inches').check();
    await shows(page.locator('.listing'), /G20/);
    assert.equal(await page.getByLabel(/rollover/).count(), 0, 'a linear axis has none');
    await page.getByLabel('Coordinates', { exact: true }).selectOption('machine');
    await shows(page.locator('.listing'), /G53 G1 X/);
    await page.getByLabel('Coordinates', { exact: true }).selectOption('offset');
    await shows(page.locator('.listing'), /POSITIONS IN THE WORK OFFSET G54/);
    await page.getByLabel('Work offset', { exact: true }).fill('G70');
    await shows(page.locator('.program'), /found the frame "G70", expected one of active, machine/);
    await page.getByLabel('Coordinates', { exact: true }).selectOption('active');
    await shows(page.locator('.listing'), /THAT IS ACTIVE/);
    const sheet = await downloaded(page, () => page.getByRole('button', { name: 'Plan sheet PDF' }).click());
    assert.equal(sheet.bytes.subarray(0, 5).toString(), '%PDF-');
    const id = Number(new URL(page.url()).pathname.split('/').pop());
    const kept = await world.api('GET', `/api/plans/${id}`);
    assert.equal(kept.version, 2);
    assert.equal(kept.request.dwell_s, 4);
  },

  async 'a rotary axis is programmed with rollover where its control has it'(world) {
    const page = await world.page();
    await page.goto('/plans/new');
    await page.getByLabel('Name of the axis').fill('C');
    await page.getByLabel('Kind').selectOption('rotary');
    await page.getByLabel('Control', { exact: true }).selectOption('siemens-840d');
    await shows(page.locator('.listing'), /ROLLOVER OFF/);
    await page.getByLabel(/rollover/).check();
    await shows(page.locator('.listing'), /=ACP\(/);
    await shows(page.locator('.listing'), /=ACN\(/);
    await page.getByLabel('Control', { exact: true }).selectOption('grbl');
    await shows(page.locator('.program'), /found rollover asked for, expected none/);
  },

  async 'plan files are imported as they are, chosen or dropped, and one that is none says where'(world) {
    const { id } = await world.plan('To be imported');
    const kept = await world.api('GET', `/api/plans/${id}/plan.json`);
    const buffer = Buffer.from(JSON.stringify(kept));
    const page = await world.page();
    await page.goto('/plans');
    const choose = (...files) => page.setInputFiles('input[type=file]', files.map(([name, bytes]) => ({ name, mimeType: 'application/json', buffer: bytes })));
    await choose(['plan.json', buffer]);
    await page.waitForURL(/\/plans\/\d+$/);
    await shows(page.locator('.figures'), /Targets\s*5/);
    await shows(page.locator('.listing'), /G1 X/);
    const file = await downloaded(page, () => page.getByRole('link', { name: 'Plan file' }).click());
    assert.deepEqual(JSON.parse(file.bytes.toString()), kept);

    await page.goto('/plans');
    await choose(['broken.json', Buffer.from('{"format": "axiometry-plan/1",\n "targets": [1, 2,, 3]}')], ['good.json', buffer]);
    await shows(page.getByRole('alert'), /expected/);
    await shows(page.getByRole('alert'), 'line 2:');
    await shows(page.locator('main'), 'broken.json');
    await page.waitForFunction(() => document.querySelectorAll('main tbody tr').length === 3);

    const dropped = await page.evaluateHandle((text) => {
      const files = new DataTransfer();
      files.items.add(new File([text], 'dropped.json', { type: 'application/json' }));
      return files;
    }, buffer.toString());
    await page.dispatchEvent('main', 'drop', { dataTransfer: dropped });
    await page.waitForURL(/\/plans\/\d+$/);
    assert.equal((await world.api('GET', '/api/plans')).plans.length, 4);

    // Taken for a test, it is told what it is.
    await page.goto('/');
    await choose(['plan.json', buffer]);
    await page.getByRole('button', { name: 'Keep it as a plan' }).click();
    await page.waitForURL(/\/plans\/\d+$/);
    assert.equal((await world.api('GET', '/api/plans')).plans.length, 5);
    assert.equal((await world.api('GET', '/api/tests')).total, 0);
  },

  async 'the controls that most machines have come first, and the one chosen last is chosen'(world) {
    const page = await world.page();
    await page.goto('/plans/new');
    const control = page.getByLabel('Control', { exact: true });
    await shows(page.locator('.listing'), /G1 X/);
    assert.equal(await control.inputValue(), 'siemens-840d');
    const all = await control.locator('option').evaluateAll((options) => options.map((one) => one.value));
    assert.deepEqual(all.slice(0, 4), ['siemens-840d', 'heidenhain', 'fanuc', 'linuxcnc']);
    const { dialects } = await world.api('GET', '/api/vocabulary');
    assert.deepEqual([...all].sort(), dialects.map(({ id }) => id).sort());
    await control.selectOption('okuma');
    await page.reload();
    await shows(page.locator('.listing'), /G1 X/);
    assert.equal(await control.inputValue(), 'okuma');
  },

  async 'a plan that two people edit loses nothing of either'(world) {
    const { id } = await world.plan();
    const [mine, theirs] = [await world.page(), await world.page()];
    for (const page of [mine, theirs]) {
      await page.goto(`/plans/${id}`);
      await shows(page.locator('.figures'), /Targets/);
    }
    await theirs.getByLabel('Dwell (s)').fill('6');
    await theirs.getByRole('button', { name: 'Save version 2' }).click();
    await shows(theirs.locator('main'), /Version 2/);
    await mine.getByLabel('Runs', { exact: true }).fill('7');
    await mine.getByRole('button', { name: 'Save version 2' }).click();
    await mine.getByRole('dialog').getByRole('button', { name: /version 3/ }).click();
    await shows(mine.locator('main'), /Version 3/);
    assert.equal((await world.api('GET', `/api/plans/${id}`)).request.runs, 7);
    assert.equal((await world.api('GET', `/api/plans/${id}?version=2`)).request.dwell_s, 6);
  },
};
