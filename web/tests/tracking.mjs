// SPDX-License-Identifier: Apache-2.0
// The tracking interferometer: from machine and travels to the program, and from lengths to results.
import assert from 'node:assert/strict';
import { axe_findings, downloaded, shows } from './world.mjs';

const apart = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
const station = [100, 80, -600];
const rows = (page) => page.locator('.tracking-lines tbody tr');
const csv = (name, text) => ({ name, mimeType: 'text/csv', buffer: Buffer.from(text) });

/** Eight points from which the instrument stands at `at`. */
function points_table(at) {
  const places = [[0, 0, -620], [800, 0, -620], [800, 600, -620], [0, 600, -120], [0, 0, -120], [800, 0, -120], [400, 600, -300], [300, 100, -150]];
  return ['x_mm,y_mm,z_mm,length_difference_mm', ...places.map((place) => [...place, (apart(place, at) - apart(places[0], at)).toFixed(5)].join())].join('\n');
}

/** What is shown along the lines of a plan by a machine that is too long in Y. */
async function lengths_table(world, plan, scale_y) {
  const { lines } = await world.api('POST', '/api/tracking/lines', { plan });
  const table = ['line,target,direction,run,length_difference_mm'];
  for (const { id, targets, runs } of lines)
    for (let run = 1; run <= runs; run += 1)
      for (const direction of ['up', 'down'])
        targets.forEach(([x, y, z], k) => table.push([id, k + 1, direction, run, apart([x, y + scale_y * (y - station[1]), z], station).toFixed(6)].join()));
  return table.join('\n');
}

async function opened(world, how = {}) {
  const page = await world.page(how);
  await page.goto('/tracking');
  await rows(page).nth(6).waitFor();
  return page;
}
const plan_file = async (page) => JSON.parse((await downloaded(page, () => page.getByRole('button', { name: 'Plan file', exact: true }).click())).bytes.toString());
const triple = (page, name, axis) => page.getByRole('group', { name }).getByLabel(axis, { exact: true });

export const tracking = {
  async 'tracking: from machine and travels to the finished program, without a manual'(world) {
    const page = await opened(world);
    await page.getByLabel('Name', { exact: true }).fill('Mill 5');
    await page.getByLabel('X from').fill('-100');
    await shows(page.locator('.tracking-lines'), /x\s*ISO 230-2\s*200 … 700/);
    await page.getByLabel('Runs', { exact: true }).fill('2');
    await shows(page.locator('.figures').first(), /Readings\s*140/);
    await page.getByLabel('Control', { exact: true }).selectOption('linuxcnc');
    await shows(page.locator('.listing'), /G1 X/);
    await page.getByLabel('stop before each line').check();
    await shows(page.locator('.listing'), /M0/);
    const program = await downloaded(page, () => page.getByRole('button', { name: /Download/ }).click());
    assert.match(program.name, /^Mill-5-Lines.*\.ngc$/);
    const sheet = await downloaded(page, () => page.getByRole('button', { name: 'Sheet PDF' }).click());
    assert.equal(sheet.bytes.subarray(0, 5).toString(), '%PDF-');
    const plan = await plan_file(page);
    assert.equal(plan.format, 'axiometry-tracking-plan/1');
    assert.equal(plan.machine, 'Mill 5');
    assert.deepEqual(plan.setup.travel.lowest_mm, [-100, 0, -500]);
    await page.reload();
    await rows(page).nth(6).waitFor();
    assert.equal(await page.getByLabel('X from').inputValue(), '-100', 'what was typed stays');
    assert.deepEqual((await plan_file(page)).lines, plan.lines, 'and makes the same plan');
    await page.getByLabel('X from').fill('wide');
    await shows(page.locator('main'), 'found "wide", expected a number');
    assert.equal(await rows(page).count(), 7, 'the last good plan stays');
  },

  async 'tracking: diagonals of the travels ask for no station, and tell the squareness of a face'(world) {
    const page = await opened(world);
    await triple(page, /^Place/, 'Y').fill('nowhere');
    await shows(page.locator('main'), 'found "nowhere", expected a number');
    await page.getByLabel('Which lines').selectOption('both');
    await page.waitForFunction(() => document.querySelectorAll('.tracking-lines tbody tr').length === 10);
    assert.equal(await page.getByRole('group', { name: /^Place/ }).count(), 0, 'nobody asks where it stands');
    await shows(page.locator('main'), /ask for no station/);
    await shows(page.locator('.tracking-lines'), /NN0-PP0\s*ISO 230-6\s*–/);
    assert.deepEqual(await axe_findings(page), []);
    const plan = await plan_file(page);
    assert.equal(plan.setup.station, undefined);
    assert.equal(plan.setup.limits, undefined);
    await page.getByLabel('Control', { exact: true }).selectOption('linuxcnc');
    await shows(page.locator('.listing'), /G1 X/);
    assert.equal((await page.locator('.listing').innerText()).match(/\bM0\b/g)?.length, 10, 'it is aligned with each line first');
    assert.equal(await page.getByLabel('stop before each line').count(), 0);
    const sheet = await downloaded(page, () => page.getByRole('button', { name: 'Sheet PDF' }).click());
    assert.equal(sheet.bytes.subarray(0, 5).toString(), '%PDF-');
    // Y leans by 20 µm/m towards −X.
    const { lines } = await world.api('POST', '/api/tracking/lines', { plan });
    const table = ['line,target,direction,run,length_difference_mm'];
    for (const { id, targets, runs } of lines)
      for (let run = 1; run <= runs; run += 1)
        for (const direction of ['up', 'down'])
          targets.forEach(([x, y, z], k) => {
            const [x0, y0, z0] = targets[0];
            table.push([id, k + 1, direction, run, Math.hypot(x - x0 - 20e-6 * (y - y0), y - y0, z - z0).toFixed(6)].join());
          });
    await page.setInputFiles('section[aria-labelledby=tracking-lengths] input[accept*=csv]', csv('lengths.csv', table.join('\n')));
    await shows(page.locator('.results'), /aligned with each line in turn, without a station/);
    await shows(page.locator('.results div', { has: page.getByRole('heading', { name: 'Squareness from the diagonals of a face' }) }).last(), /XY[\s\S]*C0Y −?(19\.99|20\.0)/);
    // Every run is the same, which is told along each of the lines and not of the chosen one alone.
    assert.equal(await page.locator('.results summary', { hasText: 'Findings of' }).count(), lines.length);
    assert.ok(!(await page.locator('.results').innerText()).includes('Nothing to say against it'));
    await page.getByLabel('Which lines').selectOption('seven');
    await shows(page.locator('main'), 'found "nowhere", expected a number');
  },

  async 'tracking: lines that cannot be measured are told with their reasons, and a better place is proposed'(world) {
    const page = await opened(world);
    await triple(page, /^Place/, 'Y').fill('-12');
    await shows(page.locator('.tracking-lines'), /Lost x\b/);
    await shows(page.locator('.tracking-lines'), /12.* mm outside the travel of Y/);
    await page.getByRole('button', { name: 'Find a better place' }).click();
    await shows(page.locator('main'), /it would keep \d of 7 lines/);
    const before = await rows(page).count();
    await page.getByRole('button', { name: 'Take this place' }).first().click();
    await page.waitForFunction((n) => document.querySelectorAll('.tracking-lines tbody tr').length > n, before);
    await triple(page, /^Place/, 'X').fill('90000');
    await shows(page.getByRole('alert'), /found/);
    await page.getByRole('button', { name: 'Begin anew' }).click();
    await shows(page.locator('.tracking-lines'), 'Mount the reflector');
  },

  async 'tracking: an obstacle is drawn and cuts what is behind it'(world) {
    const page = await opened(world);
    await page.getByText('Obstacles, limits, instrument').click();
    await page.getByRole('button', { name: 'Add a box' }).click();
    await shows(page.locator('main'), 'a number is wanted');
    const box = page.getByRole('group', { name: 'Obstacle 1' });
    await box.getByLabel('Name').fill('vice');
    for (const [name, place] of [[/^from/, [500, 0, -700]], [/^to/, [560, 200, -500]]])
      for (const [k, axis] of ['X', 'Y', 'Z'].entries()) await box.getByRole('group', { name }).getByLabel(axis, { exact: true }).fill(String(place[k]));
    await shows(page.locator('.tracking-lines'), /vice/);
    await page.locator('.scene svg .face').nth(3).waitFor();
  },

  async 'tracking: the station is found from a table of points, with its uncertainty, and takes part in the plan'(world) {
    const page = await opened(world);
    await page.getByText('Find it exactly').click();
    await page.getByRole('button', { name: 'Plan 8 points' }).click();
    const table = await downloaded(page, () => page.getByRole('button', { name: 'Table to fill in' }).click());
    assert.match(table.bytes.toString(), /length_difference_mm/);
    assert.equal(await page.locator('.scene text.name').filter({ hasText: /^[1-8]$/ }).count(), 8, 'the points are in the picture');
    const choose = page.getByLabel('Choose a table of points…');
    await choose.setInputFiles(csv('broken.csv', 'x_mm,y_mm,z_mm,length_difference_mm\n1,2,three,4\n'));
    await shows(page.getByRole('alert'), 'line 2');
    // What is typed and is no number is never passed over.
    const sigma = page.getByLabel('Standard uncertainty of the machine’s points (µm)');
    await sigma.fill('some');
    await choose.setInputFiles(csv('points.csv', points_table([101.5, 80.25, -600.75])));
    await shows(page.getByRole('alert'), 'found "some", expected a number');
    assert.equal(await page.locator('.located').count(), 0);
    await sigma.fill('');
    await choose.setInputFiles(csv('points.csv', points_table([101.5, 80.25, -600.75])));
    await shows(page.locator('.located'), /points\.csv/);
    await shows(page.locator('.located'), /X\s*101\.5000/);
    await page.waitForFunction(() => !document.querySelector('[role=alert]'));
    const { setup } = await plan_file(page);
    assert.ok(apart(setup.station.position_mm, [101.5, 80.25, -600.75]) < 1e-3);
    assert.ok(setup.station.covariance_mm2[0][0] > 0);
    const report = await downloaded(page, () => page.getByRole('button', { name: 'Report PDF' }).first().click());
    assert.equal(report.bytes.subarray(0, 5).toString(), '%PDF-');
    await page.locator('.located').getByRole('button', { name: 'Discard' }).click();
    assert.equal(await triple(page, /^Place/, 'X').inputValue(), '100');
  },

  async 'tracking: lengths that are dropped give results of all lines, findings, verdicts and the report'(world) {
    const page = await opened(world);
    const plan = await plan_file(page);
    const lengths = await lengths_table(world, plan, 40e-6);
    const drop = await page.evaluateHandle((text) => {
      const files = new DataTransfer();
      files.items.add(new File([text], 'lengths.csv', { type: 'text/csv' }));
      files.items.add(new File(['another'], 'other.csv', { type: 'text/csv' }));
      return files;
    }, lengths);
    await page.dispatchEvent('.file-drop:has-text("Drop the lengths here")', 'drop', { dataTransfer: drop });
    await shows(page.locator('.file-drop'), 'One file at a time: 1 other file was not taken.');
    await shows(page.locator('.results'), /y\s*2\d\d … \d+/);
    assert.equal(await page.locator('.results tbody tr').count(), 7);
    await shows(page.locator('.results'), /\bey\s*40\.0/);
    await shows(page.locator('.results'), /Deviations along x/);
    await page.locator('.results').getByRole('button', { name: 'xyz' }).click();
    await shows(page.locator('.results'), /Deviations along xyz/);
    await page.getByLabel('Limits').fill('E=20um');
    await page.getByLabel('Limits').press('Enter');
    await shows(page.locator('.results'), /undecided/);
    await shows(page.locator('.results .notice'), /station/);
    const report = await downloaded(page, () => page.getByRole('button', { name: 'Report PDF' }).last().click());
    assert.equal(report.name, 'lengths.pdf');
    assert.equal(report.bytes.subarray(0, 5).toString(), '%PDF-');
    const choose = page.getByLabel('Choose lengths…');
    await choose.setInputFiles(csv('wrong.csv', lengths.replace('\nx,1,', '\nw,1,')));
    await shows(page.getByRole('alert'), /"w"/);
    // A plan that was taken along goes on where the page of that time is gone.
    await page.evaluate(() => localStorage.clear());
    await page.getByRole('button', { name: 'Begin anew' }).click();
    await page.getByLabel('Use another plan file…').setInputFiles({ name: 'kept.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(plan)) });
    await choose.setInputFiles(csv('lengths.csv', lengths));
    await shows(page.locator('main'), 'with the plan kept.json');
    await shows(page.locator('.results'), /\bey\s*40\.0/);
    assert.equal((await world.api('GET', '/api/tests')).total, 0, 'nothing is kept');
  },

  async 'tracking: the picture is turned by keys, mouse and buttons, and says from where it is seen'(world) {
    const page = await opened(world);
    const frame = page.locator('.scene-frame');
    const edges = () => page.locator('.scene svg line[data-key^="edge-"]').evaluateAll((lines) => lines.map((line) => line.outerHTML).sort().join());
    const first = await edges();
    await frame.focus();
    await page.keyboard.press('ArrowRight');
    await page.waitForFunction(() => /37\.5|38/.test(document.querySelector('.scene [aria-live]').textContent));
    assert.notEqual(await edges(), first);
    await page.keyboard.press('+');
    await page.keyboard.press('Home');
    assert.equal(await edges(), first, 'Home shows it as at first');
    await page.keyboard.press('Tab');
    assert.ok(await page.evaluate(() => document.activeElement.closest('.scene-views') !== null), 'Tab leads out of it');
    const box = await frame.boundingBox();
    await page.mouse.move(box.x + 300, box.y + 200);
    await page.mouse.down();
    await page.mouse.move(box.x + 400, box.y + 240);
    await page.mouse.up();
    const dragged = await edges();
    assert.notEqual(dragged, first);
    await page.mouse.move(box.x + 200, box.y + 100);
    assert.equal(await edges(), dragged, 'only while it is pressed');
    await page.getByRole('button', { name: 'Top' }).click();
    assert.equal(await page.getByRole('button', { name: 'Top' }).getAttribute('aria-pressed'), 'true');
    const told = await page.locator('.scene svg').getAttribute('aria-label');
    assert.match(told, /reaches X 0 … 800, Y 0 … 600, Z −620 … −120 mm.*7 lines can be measured/);
    await page.locator('.tracking-lines').getByRole('button', { name: 'xy', exact: true }).click();
    assert.ok(await page.locator('.scene svg line[data-key="xy"]').evaluateAll((lines) => lines.some((line) => Number(line.getAttribute('stroke-width')) > 4)), 'the chosen line stands out');
  },

  async 'tracking: on a phone a finger turns the picture to its sides, and the page scrolls under it'(world) {
    const page = await opened(world, { width: 390, height: 844, locale: 'de-DE' });
    assert.equal(await page.locator('.scene-frame').evaluate((frame) => getComputedStyle(frame).touchAction), 'pan-y');
    const line = () => page.locator('.scene svg line[data-key="x"]').first().getAttribute('x2');
    const before = await line();
    await page.locator('.scene-frame').evaluate((frame) => {
      const at = frame.getBoundingClientRect();
      const send = (type, dx, dy, target) => target.dispatchEvent(new PointerEvent(type, { pointerId: 5, pointerType: 'touch', bubbles: true, clientX: at.left + 100 + dx, clientY: at.top + 100 + dy }));
      send('pointerdown', 0, 0, frame);
      send('pointermove', 60, 0, window);
      send('pointerup', 60, 0, window);
    });
    await page.waitForFunction((was) => document.querySelector('.scene svg line[data-key="x"]').getAttribute('x2') !== was, before);
  },
};
