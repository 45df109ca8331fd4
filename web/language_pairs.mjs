// SPDX-License-Identifier: Apache-2.0
// node web/language_pairs.mjs: writes src/i18n/TAG.json for each language that is not English, the pairs of
// src/axiometry/language/TAG.txt (phrase_file.h) that the page has a text for. The English texts are the rows that
// texts() is given. A text without its pair is refused, and a pair of the page alone without its text.
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import ts from 'typescript';

const sources = fileURLToPath(new URL('src/', import.meta.url));
const languages = new URL('../src/axiometry/language/', import.meta.url);
const page_subject = '# The page';

const files_in = (folder) => readdirSync(folder, { withFileTypes: true })
  .flatMap((one) => (one.isDirectory() ? files_in(`${folder}${one.name}/`) : [`${folder}${one.name}`]));

/** An expression without "as const". */
const bare = (node) => (ts.isAsExpression(node) || ts.isParenthesizedExpression(node) ? bare(node.expression) : node);

function* nodes_of(node) {
  yield node;
  for (const child of node.getChildren()) yield* nodes_of(child);
}

/** The keys of all rows in one source: "text", or of ['text', 'meaning'] "text [meaning]". */
function* keys_in(path) {
  const file = ts.createSourceFile(path, readFileSync(path, 'utf8'), ts.ScriptTarget.Latest, true);
  const nodes = [...nodes_of(file)];
  const objects = new Map(nodes.filter((node) => ts.isVariableDeclaration(node) && node.initializer)
    .map((node) => [node.name.getText(), bare(node.initializer)]));
  const refused = (node) => new Error(`${path}: found ${node.getText().slice(0, 80)}, expected texts({ name: 'text', other: ['text', 'meaning'] })`);
  for (const call of nodes.filter((node) => ts.isCallExpression(node) && node.expression.getText() === 'texts')) {
    const given = bare(call.arguments[0]);
    const rows = ts.isIdentifier(given) ? objects.get(given.text) : given;
    if (!rows || !ts.isObjectLiteralExpression(rows)) throw refused(call);
    for (const row of rows.properties) {
      const words = row.initializer && ts.isArrayLiteralExpression(row.initializer) ? [...row.initializer.elements] : [row.initializer];
      if (!words.every((word) => word && ts.isStringLiteralLike(word)) || words.length > 2) throw refused(row);
      yield words.length === 2 ? `${words[0].text} [${words[1].text}]` : words[0].text;
    }
  }
}

/** English to the other text, and which of them the page alone has. */
function pairs_of(tag) {
  const pairs = new Map(), of_page = new Set();
  let in_page = false, comment = false, english = null;
  for (const line of readFileSync(new URL(`${tag}.txt`, languages), 'utf8').split('\n')) {
    const was_comment = comment;
    comment = line.startsWith('#');
    if (comment && !was_comment) in_page = line.startsWith(page_subject);
    if (comment || line === '') { english = null; continue; }
    if (english === null) { english = line; continue; }
    pairs.set(english, line);
    if (in_page) of_page.add(english);
  }
  return { pairs, of_page };
}

const keys = new Set(files_in(sources).filter((path) => /\.tsx?$/.test(path)).flatMap((path) => [...keys_in(path)]));
const sorted = [...keys].sort((a, b) => Buffer.compare(Buffer.from(a), Buffer.from(b)));
const tags = readdirSync(languages).filter((name) => name.endsWith('.txt')).map((name) => name.slice(0, -4));
const faults = [];
for (const tag of tags) {
  const { pairs, of_page } = pairs_of(tag);
  faults.push(...sorted.filter((key) => !pairs.has(key)).map((key) => `${tag}.txt: found no pair for the page's "${key}"`));
  faults.push(...[...of_page].filter((key) => !keys.has(key)).map((key) => `${tag}.txt: found "${key}" of the page, expected it among its texts`));
  const own = Object.fromEntries(sorted.filter((key) => pairs.has(key)).map((key) => [key, pairs.get(key)]));
  writeFileSync(`${sources}i18n/${tag}.json`, `${JSON.stringify(own, null, 1)}\n`);
}
for (const fault of faults) console.error(fault);
process.exit(faults.length > 0 ? 1 : 0);
