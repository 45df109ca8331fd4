// SPDX-License-Identifier: Apache-2.0
// Every page there is, on a store with something in it.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const of_examples = (name) => fileURLToPath(new URL(`../../examples/${name}`, import.meta.url));

/** Keeps what a transcript of the command line measures: files by what they are for. */
async function calibrated(world, kind, files) {
  const form = new FormData();
  form.append('kind', kind);
  for (const [role, path] of Object.entries(files)) {
    const bytes = readFileSync(fileURLToPath(new URL(`../../tests/transcripts/${path}`, import.meta.url)));
    form.append(role, new Blob([bytes]), path.replace(/.*\//, ''));
  }
  const answer = await fetch(`${world.server.address}/api/calibrations`, { method: 'POST', body: form });
  return (await answer.json()).id;
}

/** Keeps the table that a control takes of a test, and the test that is held against it. */
async function corrected(world, test, options, retest) {
  const form = new FormData();
  form.append('options', JSON.stringify(options));
  const answer = await fetch(`${world.server.address}/api/tests/${test}/compensations`, { method: 'POST', body: form });
  assert.equal(answer.status, 201, await answer.clone().text());
  const { id } = await answer.json();
  if (retest) await world.api('POST', `/api/compensations/${id}/versions`, { base_version: 1, retest, reason: 're-test' });
  return id;
}

/** A volume whose lengths are captured within a minute: two stations, one tool, few points. */
export const small_volume = {
  machine: {
    name: 'Mill 5', chain: 'XFYZ', travel_mm: { X: [0, 800], Y: [0, 500], Z: [-500, 0] }, tools_mm: { T1: [0, 0, -120] },
    stations_mm: { S1: [-100, -50, -700], S2: [900, -50, -800] }, repeatability_um: 0.5,
  },
  limits: { incidence_most_deg: 85 }, points: 8, dwell_s: 2, feed_mm_per_min: 20000, date: '2026-11-25',
};

/** Fills the store of the world; the paths of all pages. */
export async function visited(world) {
  const first = await world.kept();
  const second = await world.kept(of_examples('simulated-backlash.json'), 'backlash.json');
  const third = await world.kept(of_examples('simulated-ball-screw.json'), 'ball-screw.json');
  const { id: plan } = await world.plan();
  const capture = await world.api('POST', '/api/captures', {
    plan, source: 'simulator', layout: '', options: { speed: '60', preset: 'good', seed: '1' },
  });
  const { plan: of_volume } = await world.api('POST', '/api/volumetric/plan', small_volume);
  const lengths = await world.api('POST', '/api/captures', {
    lengths: { kind: 'volume', plan: of_volume, part: 1 }, source: 'simulator', options: { speed: '10', preset: 'broken-beam' },
  });
  await world.api('POST', '/api/instruments', {
    role: 'Laser interferometer', manufacturer: 'Example', type: 'LI-1', serial_number: '1234', certificate: 'C-77',
    calibrated_on: '2026-01-10', calibration_due: '2027-01-10', inputs: {}, notes: '',
  });
  const lines = await calibrated(world, 'lines', { lengths: 'tracking-evaluate.files/lengths.csv', plan: 'tracking-evaluate.files/seven.json' });
  const volume = await calibrated(world, 'volumetric', { lengths: 'volumetric.files/lengths.csv', machine: 'volumetric.files/machine.json' });
  const square = await calibrated(world, 'squareness', { readings: 'error-motions.files/x-in-y.csv', 'readings-2': 'error-motions.files/y-in-x.csv' });
  const table = await corrected(world, third, { control: 'linuxcnc' }, second);
  await corrected(world, first, { control: 'heidenhain', turned_sign: true });
  const { machines } = await world.api('GET', '/api/machines');
  const machine = machines.find((one) => one.axes.length > 0) ?? machines[0];
  const axis = machine?.axes[0];
  const { instruments } = await world.api('GET', '/api/instruments');
  return [
    '/', `/tests/${first}`, `/tests/${second}`, `/tests/${first}/report`, `/compare?tests=${first},${second},${third}`,
    '/machines', ...(machine ? [`/machines/${machine.id}`] : []), ...(axis ? [`/axes/${axis.id}`] : []),
    '/instruments', `/instruments/${instruments[0].id}`, '/plans', '/plans/new', `/plans/${plan}`,
    '/tracking', '/volume', '/calibrations', `/calibrations/${lines}`, `/calibrations/${volume}`, `/calibrations/${square}`, '/motions', '/dynamic', '/compensations', `/compensations/${table}`, `/tests/${third}/table`, `/tests/${first}/rules`, '/tables', '/captures', '/captures/new', `/captures/${capture.id}`, `/captures/${lengths.id}`, '/settings', '/audit', '/no/such/page',
  ];
}

/** Until the page has what it asked for, and has drawn it. A live page asks for ever: it gets its time. */
export async function settle(page) {
  await page.waitForLoadState('networkidle', { timeout: 2500 }).catch(() => undefined);
  await page.waitForTimeout(150);
}
