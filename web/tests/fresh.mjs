// SPDX-License-Identifier: Apache-2.0
// node web/tests/fresh.mjs: the types of the API must be those of its description, every text must have its pair in each
// language, and the sources must build to what web/bundle holds, byte for byte, since the program is built from the bundle
// without node. Installs the packages where they are missing or others than package-lock.json says.
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const web = fileURLToPath(new URL('..', import.meta.url));
const mend = 'run: cd web && npm install --no-save && npm run build';
const run = (command, flags) => execFileSync(command, flags, { cwd: web, stdio: ['ignore', 'pipe', 'inherit'] });

/** npm keeps what it has installed in a file of its own. */
function installed() {
  const kept = join(web, 'node_modules', '.package-lock.json');
  if (!existsSync(kept)) return false;
  const have = JSON.parse(readFileSync(kept, 'utf8')).packages;
  const want = JSON.parse(readFileSync(join(web, 'package-lock.json'), 'utf8')).packages;
  return Object.entries(want).every(([path, { version, optional }]) => path === '' || optional || have[path]?.version === version);
}

const files_of = (folder) => (existsSync(folder) ? readdirSync(folder).sort() : []);

if (!installed()) run('npm', ['install', '--no-save', '--no-audit', '--no-fund', '--ignore-scripts']);
const folder = await mkdtemp(join(tmpdir(), 'axiometry-bundle-'));
const faults = [];
try {
  const types = join(folder, 'types.ts');
  run(process.execPath, [join(web, 'api_types.mjs'), types]);
  if (!readFileSync(types).equals(readFileSync(join(web, 'src/api/types.ts')))) faults.push('web/src/api/types.ts is not what apps/server/openapi.json describes');
  await rm(types);
  run(process.execPath, [join(web, 'language_pairs.mjs')]);
  run(process.execPath, [join(web, 'node_modules/typescript/bin/tsc'), '--noEmit']);
  run(process.execPath, [join(web, 'node_modules/vite/bin/vite.js'), 'build', '--outDir', folder, '--emptyOutDir', '--logLevel', 'error']);
  const [built, kept] = [files_of(folder), files_of(join(web, 'bundle'))];
  for (const name of new Set([...built, ...kept])) {
    if (!kept.includes(name)) faults.push(`web/bundle/${name} is missing`);
    else if (!built.includes(name)) faults.push(`web/bundle/${name} is of no source`);
    else if (!readFileSync(join(folder, name)).equals(readFileSync(join(web, 'bundle', name)))) faults.push(`web/bundle/${name} is not what the sources build to`);
  }
} finally {
  await rm(folder, { recursive: true, force: true });
}
for (const fault of faults) console.error(fault);
if (faults.length > 0) console.error(mend);
else console.log('web/bundle is what the sources build to');
process.exit(faults.length === 0 ? 0 : 1);
