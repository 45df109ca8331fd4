// SPDX-License-Identifier: Apache-2.0
// What a browser test has: a program on an empty store of its own, a browser, and what went wrong meanwhile.
import assert from 'node:assert/strict';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { undescribed } from './described.mjs';
import { start_server } from './server.mjs';

export const example = fileURLToPath(new URL('../../examples/iso230-2-table2.json', import.meta.url));
const axe_source = await readFile(fileURLToPath(new URL('../node_modules/axe-core/axe.min.js', import.meta.url)), 'utf8');

// With AXIOMETRY_LATE=200 every request waits up to so many milliseconds, so that answers come in any order: a test that
// looks before the page has what it asks for fails then, and not only on a busy machine.
const latest_ms = Number(process.env['AXIOMETRY_LATE'] ?? 0);

// Of one step. It costs nothing where the page answers, and a busy machine may keep it from answering for long.
const patience_ms = 60_000;

/** Of all tests together: requests to anywhere else than this machine's loopback. */
export const strangers = [];

/** Since the last test: what the server answered otherwise than apps/server/openapi.json describes. */
export const not_as_described = [];

// What tests ask themselves.
const plain_fetch = globalThis.fetch;
globalThis.fetch = async (url, options = {}) => {
  const response = await plain_fetch(url, options);
  const { body: sent = null, method = 'GET' } = options;
  const body = await response.clone().text();
  const type = response.headers.get('content-type');
  not_as_described.push(...undescribed({ method, url, sent: typeof sent === 'string' || sent === null ? sent : undefined, status: response.status, type, body }));
  return response;
};

export class World {
  constructor(program, browser, folder) {
    Object.assign(this, { program, browser, folder, contexts: [], faults: [], dialogs: [], heard: [] });
    this.store = join(folder, 'store.db');
  }

  static async make(program, browser) {
    const world = new World(program, browser, await mkdtemp(join(tmpdir(), 'axiometry-page-')));
    world.server = await start_server(program, { store: world.store });
    return world;
  }

  async end() {
    // An answer that the page gave up in the middle ends with its context alone, or not at all.
    const heard = () => Promise.race([Promise.all(this.heard), new Promise((later) => setTimeout(later, 3_000))]);
    await heard();
    for (const context of this.contexts) await context.close();
    await heard();
    await this.server.stop();
    await rm(this.folder, { recursive: true, force: true });
  }

  /** Ends the program and starts it again on the same store and port. */
  async restart() {
    await this.server.stop();
    await this.back();
  }
  /** Another program may have been lent the port meanwhile, for a connection of its own. */
  async back() {
    const end = Date.now() + 10_000;
    for (;;) {
      try {
        this.server = await start_server(this.program, { store: this.store, port: this.server.port });
        return;
      } catch (error) {
        if (Date.now() > end) throw error;
        await new Promise((later) => setTimeout(later, 200));
      }
    }
  }

  /** A browser of its own: nothing cached, nothing chosen. */
  async page({ width = 1280, height = 900, theme = 'light', locale = 'en-GB', reduced = true } = {}) {
    const context = await this.browser.newContext({
      viewport: { width, height }, colorScheme: theme, locale, baseURL: this.server.address, acceptDownloads: true,
      reducedMotion: reduced ? 'reduce' : 'no-preference', timezoneId: 'Europe/Berlin',
    });
    context.setDefaultTimeout(patience_ms);
    this.contexts.push(context);
    context.on('request', (request) => {
      const url = new URL(request.url());
      if (!['data:', 'blob:', 'about:'].includes(url.protocol) && url.hostname !== '127.0.0.1') strangers.push(request.url());
    });
    context.on('response', (response) => this.heard.push(this.hold(response)));
    if (latest_ms > 0) await context.route('**/api/**', async (route) => {
      await new Promise((later) => setTimeout(later, Math.random() * latest_ms));
      await route.continue().catch(() => undefined);
    });
    const page = await context.newPage();
    page.on('pageerror', (error) => this.faults.push(`error: ${error.message}`));
    page.on('console', (message) => {
      // An answer of 400 or more is told by the browser too; what the page makes of it is tested.
      if (message.type() === 'error' && !message.text().startsWith('Failed to load resource')) this.faults.push(message.text());
    });
    page.on('dialog', (dialog) => {
      this.dialogs.push(dialog.message());
      void dialog.accept();
    });
    return page;
  }

  /** What a page was answered, against the description. Bodies that the browser keeps for itself are not looked into. */
  async hold(response) {
    const request = response.request();
    const is_json = (headers) => headers['content-type']?.startsWith('application/json');
    const body = is_json(response.headers()) ? await response.text().catch(() => undefined) : undefined;
    not_as_described.push(...undescribed({
      method: request.method(), url: response.url(), sent: is_json(request.headers()) ? (request.postData() ?? undefined) : undefined,
      status: response.status(), type: response.headers()['content-type'], body,
    }));
  }

  /** Says something to the server as a script would. */
  async api(method, path, body, headers = {}) {
    const raw = body instanceof Uint8Array || typeof body === 'string';
    const response = await fetch(this.server.address + path, {
      method, headers: { ...(body === undefined || raw ? {} : { 'Content-Type': 'application/json' }), ...headers },
      ...(body === undefined ? {} : { body: raw ? body : JSON.stringify(body) }),
    });
    const text = await response.text();
    assert.ok(response.ok, `${method} ${path}: ${response.status} ${text.slice(0, 300)}`);
    return text === '' ? null : JSON.parse(text);
  }

  /** A file kept as a test, by its path; its id. */
  async kept(path = example, name = 'table2.json') {
    const received = await this.api('POST', '/api/tests', await readFile(path), { 'X-File-Name': encodeURIComponent(name) });
    return received.id;
  }

  /** A plan of an axis X of 500 mm. */
  async plan(title = 'X of the mill', more = {}) {
    const request = {
      axis: 'X', kind: 'linear', from: 0, to: 500, positions: null, targets: null, cycle: 'standard', runs: null, feed: null,
      dwell_s: null, overrun: null, seed: 7, further: {}, ...more,
    };
    return this.api('POST', '/api/plans', { title, axis: null, request });
  }
}

/** Waits until the text of an element fits; says what it was instead. */
export async function shows(locator, wanted, patience = patience_ms) {
  const end = Date.now() + patience;
  let found = '';
  do {
    found = (await locator.allInnerTexts().catch(() => [])).join('\n');
    if (wanted instanceof RegExp ? wanted.test(found) : found.includes(wanted)) return found;
    await new Promise((later) => setTimeout(later, 40));
  } while (Date.now() < end);
  throw new Error(`found the text ${JSON.stringify(found.slice(0, 1500))}, expected ${wanted}`);
}

/** Waits until an attribute says so: what a page draws before its answers came may have it too, with less in it. */
export async function attribute_shows(locator, name, wanted, patience = patience_ms) {
  const end = Date.now() + patience;
  let found = null;
  do {
    found = await locator.getAttribute(name);
    if (wanted.test(found ?? '')) return;
    await new Promise((later) => setTimeout(later, 40));
  } while (Date.now() < end);
  throw new Error(`found ${name}=${JSON.stringify(found)}, expected ${wanted}`);
}

/** Waits until nothing of it is there: what a page was told before stands until the next answer has come. */
export async function is_gone(locator, patience = patience_ms) {
  const end = Date.now() + patience;
  while ((await locator.count()) > 0) {
    if (Date.now() > end) throw new Error(`found ${JSON.stringify(await locator.first().innerText())}, expected it to be gone`);
    await new Promise((later) => setTimeout(later, 40));
  }
}

/** The bytes that a click downloads, and their suggested name. */
export async function downloaded(page, click) {
  const [download] = await Promise.all([page.waitForEvent('download'), click()]);
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}

/** What axe finds on the page as it is shown now; WCAG 2.2 AA and its own good practice. */
export async function axe_findings(page) {
  // By the debugger, so that the page's own rules about scripts stay as they are.
  await page.evaluate(axe_source);
  return page.evaluate(async () => {
    const { violations } = await globalThis.axe.run(document, { iframes: false });
    return violations.map(({ id, help, nodes }) => `${id}: ${help}: ${nodes.slice(0, 3).map(({ target, failureSummary }) => `${target} (${failureSummary.replace(/\s+/g, ' ')})`).join('; ')}`);
  });
}

/** The page wider than its window: on a phone everything else would have to be searched for. */
export const sideways = (page) => page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);

export const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];
