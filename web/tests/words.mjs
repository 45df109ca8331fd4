// SPDX-License-Identifier: Apache-2.0
// How pages call what sentences of the program call by a flag, without a page.
import assert from 'node:assert/strict';
import { build } from 'esbuild';
import { fileURLToPath } from 'node:url';

const resolveDir = fileURLToPath(new URL('../src/', import.meta.url));
const contents = "export { page_words, words_by } from './components/page_words';";
// In English, without the settings of a browser.
const in_english = {
  name: 'in English',
  setup(building) {
    building.onResolve({ filter: /i18n\/texts$/ }, () => ({ path: 'texts', namespace: 'english' }));
    building.onLoad({ filter: /.*/, namespace: 'english' }, () => ({
      contents: 'export const texts = (rows) => (key, values = {}) => (typeof rows[key] === "string" ? rows[key] : rows[key][0]).replace(/\\{(\\w+)\\}/g, (_, name) => values[name]);',
    }));
  },
};
const { outputFiles } = await build({ stdin: { contents, resolveDir, loader: 'ts' }, bundle: true, format: 'esm', write: false, plugins: [in_english] });
const { page_words, words_by } = await import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString('base64')}`);

export const word_tests = {
  async 'a page calls flags by its fields, and leaves those in brackets out that it has no field for'() {
    const words = words_by((flag) => ({ zero: 'Zero', 'stops keys': 'a key' })[flag]);
    assert.equal(words('the sign differs (--zero, --datum): look at it'), 'the sign differs (“Zero”): look at it');
    assert.equal(words('say which part it is (--elsewhere), if it is one'), 'say which part it is, if it is one');
    assert.equal(words('expected --stops keys, or (--elsewhere legendre needs fewer)'), 'expected “a key”, or (--elsewhere legendre needs fewer)');
    assert.equal(page_words('which has runs (--part)'), 'which has runs');
  },
};
