// SPDX-License-Identifier: Apache-2.0
// node web/tests/run.mjs PROGRAM [PART/PARTS] [WORD…]: the page in Debian's Chromium, against that program. With words only
// the tests whose name has one of them, with -WORD all but those whose name has it; of these with 2/3 the second of three
// parts. Each test has an empty store of its own.
import { chromium } from 'playwright-core';
import { accessibility } from './accessibility.mjs';
import { answers } from './answers.mjs';
import { audit } from './audit.mjs';
import { calibration } from './calibration.mjs';
import { calibrations } from './calibrations.mjs';
import { capture } from './capture.mjs';
import { claims } from './claims.mjs';
import { conflict } from './conflict.mjs';
import { description } from './description.mjs';
import { dynamic } from './dynamic.mjs';
import { editor } from './editor.mjs';
import { figures } from './figures.mjs';
import { keyboard } from './keyboard.mjs';
import { languages } from './languages.mjs';
import { layout } from './layout.mjs';
import { lengths } from './lengths.mjs';
import { motion_captures } from './motion_captures.mjs';
import { motions } from './motions.mjs';
import { offline } from './offline.mjs';
import { periodic } from './periodic.mjs';
import { plan } from './plan.mjs';
import { receipts } from './receipts.mjs';
import { record } from './record.mjs';
import { rules } from './rules.mjs';
import { scene_tests } from './scene.mjs';
import { sign_out } from './sign_out.mjs';
import { stations } from './stations.mjs';
import { story } from './story.mjs';
import { surroundings } from './surroundings.mjs';
import { table_choices } from './table_choices.mjs';
import { tables } from './tables.mjs';
import { timing } from './timing.mjs';
import { tracking } from './tracking.mjs';
import { trend } from './trend.mjs';
import { volume } from './volume.mjs';
import { World, not_as_described, strangers } from './world.mjs';
import { wrong_files } from './wrong_files.mjs';

const [program, ...choices] = process.argv.slice(2);
if (!program) {
  console.error('found no program, expected: node web/tests/run.mjs PROGRAM [PART/PARTS] [WORD…]');
  process.exit(2);
}
const all = { ...story, ...keyboard, ...accessibility, ...wrong_files, ...answers, ...conflict, ...plan, ...scene_tests, ...tracking, ...stations, ...volume, ...calibrations, ...motions, ...dynamic, ...tables, ...table_choices, ...capture, ...lengths, ...motion_captures, ...languages, ...layout, ...audit, ...calibration, ...editor, ...figures, ...receipts, ...sign_out, ...record, ...trend, ...surroundings, ...rules, ...periodic, ...claims, ...description, ...offline, ...timing };
const words = choices.filter((choice) => !/^\d+\/\d+$/.test(choice));
const [part, parts] = (choices.find((choice) => !words.includes(choice)) ?? '1/1').split('/').map(Number);
const has = (name, word) => name.toLowerCase().includes(word.toLowerCase());
const [without, only] = [words.filter((word) => word.startsWith('-')).map((word) => word.slice(1)), words.filter((word) => !word.startsWith('-'))];
const chosen = (name) => (only.length === 0 || only.some((word) => has(name, word))) && !without.some((word) => has(name, word));
const wanted = Object.entries(all).filter(([name]) => chosen(name)).filter((_, index) => index % parts === part - 1);

if (wanted.length === 0) {
  console.error(`found no test in part ${part} of ${parts} with ${words.join(' ') || 'any name'}, expected one or more`);
  process.exit(2);
}

// Chromium's sandbox does not work for root, as which containers of tests mostly run.
const flags = process.getuid() === 0 ? ['--no-sandbox'] : [];
const browser = await chromium.launch({ executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium', args: [...flags, '--disable-background-networking'] });
let passed = 0;
const failures = [];
const report = (name, began, error) => {
  const lines = [`${error ? 'FAILED' : 'passed'}  ${name} (${((Date.now() - began) / 1000).toFixed(1)} s)`];
  if (error) lines.push(String(error.stack ?? error).replace(/^/gm, '        '));
  console.log(lines.join('\n'));
  error ? failures.push(lines.join('\n')) : (passed += 1);
};

// Of a whole test. Its steps have patience of their own; this is for what has none, such as a browser that answers no more.
const patience_ms = 300_000;
const in_time = (work, what) => {
  let late;
  const too_late = new Promise((_, reject) => {
    late = setTimeout(() => reject(new Error(`${what} did not end within ${patience_ms / 1000} s`)), patience_ms);
  });
  return Promise.race([work, too_late]).finally(() => clearTimeout(late));
};

for (const [name, run] of wanted) {
  const began = Date.now();
  let world = null;
  let error = null;
  try {
    world = await in_time(World.make(program, browser), 'the start of the program');
    await in_time(run(world), 'the test');
    if (world.faults.length > 0) throw new Error(`the page reported ${world.faults.join('; ')}`);
  } catch (thrown) {
    error = thrown;
    const page = world?.contexts.at(-1)?.pages()[0];
    const folder = process.env['AXIOMETRY_PICTURES'];
    if (page && folder) await page.screenshot({ path: `${folder}/${name.replace(/\W+/g, '-')}.png`, fullPage: true }).catch(() => undefined);
  }
  if (world) await in_time(world.end(), 'what came after the test').catch((thrown) => { error ??= thrown; });
  const faults = [...new Set(not_as_described.splice(0))];
  if (faults.length > 0) error = new Error([...faults, ...(error ? [error.stack] : [])].join('\n'));
  report(name, began, error);
}
await browser.close();
report('no request leaves this machine', Date.now(), strangers.length > 0 ? new Error(strangers.join('\n')) : null);
// Again at the end, where whoever reads a long log looks first.
console.log([`${passed} passed, ${failures.length} failed`, ...failures].join('\n'));
process.exit(failures.length === 0 ? 0 : 1);
