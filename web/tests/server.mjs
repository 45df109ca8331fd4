// SPDX-License-Identifier: Apache-2.0
// The program under test, as a user starts it.
import { spawn } from 'node:child_process';
import { once } from 'node:events';

const patience_ms = 60_000;

/** Starts `axiometry serve`; answers when it has printed its address. */
export async function start_server(program, { store, port = 0, flags = [] }) {
  const child = spawn(program, ['serve', '--store', store, '--port', String(port), ...flags], { stdio: ['ignore', 'pipe', 'pipe'] });
  let said = '';
  const address = await new Promise((resolve, reject) => {
    const late = setTimeout(() => reject(new Error(`found no address within ${patience_ms / 1000} s: ${said}`)), patience_ms);
    const hear = (chunk) => {
      said += chunk;
      const found = /https?:\/\/127\.0\.0\.1:\d+/.exec(said);
      if (!found) return;
      clearTimeout(late);
      resolve(found[0]);
    };
    child.stdout.on('data', hear);
    child.stderr.on('data', hear);
    child.once('exit', (code) => reject(new Error(`the program ended with ${code}: ${said}`)));
    child.once('error', reject);
  });
  return {
    address, port: Number(new URL(address).port), pid: child.pid, said: () => said,
    async stop(signal = 'SIGTERM') {
      if (child.exitCode !== null || child.signalCode !== null) return;
      const gone = once(child, 'exit');
      child.kill(signal);
      const slow = setTimeout(() => child.kill('SIGKILL'), 10_000);
      await gone;
      clearTimeout(slow);
    },
  };
}
