// SPDX-License-Identifier: Apache-2.0
// Holds what is asked and answered against apps/server/openapi.json.
import Ajv from 'ajv/dist/2020.js';
import { readFileSync } from 'node:fs';

const openapi = JSON.parse(readFileSync(new URL('../../apps/server/openapi.json', import.meta.url), 'utf8'));
const ajv = new Ajv({ strict: true, strictTypes: false, strictRequired: false, allErrors: true, validateFormats: false });
// Whatever is a schema of the description is one by its place in it.
ajv.addVocabulary(['openapi', 'info', 'servers', 'security', 'tags', 'paths', 'components', 'example', 'x-statuses']);
ajv.addSchema(openapi, 'openapi');

const patterns = Object.keys(openapi.paths).map((pattern) => {
  const parts = pattern.split(/\{[a-z]+\}/).map((part) => part.replace(/[.]/g, '\\.'));
  return { pattern, braces: parts.length, expression: new RegExp(`^${parts.join('[^/]+')}$`) };
});
const failure = '/components/responses/Failure';

const at = (pointer) => pointer.split('/').slice(1).reduce((found, part) => found?.[part.replace(/~1/g, '/')], openapi);
const resolved = (pointer) => at(pointer)?.$ref?.slice(1) ?? pointer;
const named = (...parts) => parts.map((part) => `/${part.replace(/\//g, '~1')}`).join('');

/** That fits with the fewest braces, one that has the method before others. */
function pattern_of(method, path) {
  const found = patterns.filter(({ expression }) => expression.test(path));
  const rank = ({ pattern, braces }) => (method in openapi.paths[pattern] ? 0 : 1000) + braces;
  return found.sort((a, b) => rank(a) - rank(b))[0]?.pattern;
}

/** By its innermost errors. */
function faults_of_json(pointer, text) {
  let value;
  try {
    value = JSON.parse(text);
  } catch (error) {
    return [`${error.message}: ${String(text).slice(0, 80)}`];
  }
  const valid = ajv.getSchema(`openapi#${encodeURI(pointer)}`);
  if (valid(value)) return [];
  const depth = ({ instancePath }) => instancePath.split('/').length;
  const deepest = Math.max(...valid.errors.map(depth));
  return valid.errors.filter((error) => depth(error) === deepest).slice(0, 4)
    .map(({ instancePath, message, params }) => `${instancePath}: ${message} ${JSON.stringify(params)}`);
}

function faults_of_content(pointer, method, { type, body }) {
  const content = at(`${pointer}/content`);
  if (content === undefined || method === 'head') return !body ? [] : ['a body, expected none'];
  const kind = (type ?? '').split(';')[0];
  if (!(kind in content)) return [`content of the type ${kind}, which is not described`];
  return kind === 'application/json' && body !== undefined ? faults_of_json(`${pointer}/content${named(kind)}/schema`, body) : [];
}

/** What was taken must be described as it was sent; a body that is not known (undefined) is not looked into. */
function faults_of_request(pointer, { query, sent }) {
  const parameters = (at(`${pointer}/parameters`) ?? []).map((one) => (one.$ref ? at(one.$ref.slice(1)) : one));
  const faults = [...query.keys()].filter((name) => !parameters.some((one) => one.in === 'query' && one.name === name))
    .map((name) => `the query ${name} is not described`);
  const body = at(`${pointer}/requestBody`);
  if (sent === undefined) return faults;
  if (sent === null) return body?.required ? [...faults, 'a request without a body, expected one'] : faults;
  if (body === undefined) return [...faults, 'a request with a body, expected none'];
  const json = 'application/json' in body.content;
  return json ? [...faults, ...faults_of_json(`${pointer}/requestBody/content${named('application/json')}/schema`, sent)] : faults;
}

/** What is not as described; bodies that are not known (undefined) are not looked into, none is null. */
export function undescribed({ method, url, sent, status, type, body }) {
  const { pathname, searchParams: query } = new URL(url);
  if (!pathname.startsWith('/api/')) return [];
  const verb = method === 'HEAD' ? 'get' : method.toLowerCase();
  const pattern = pattern_of(verb, pathname);
  const operation = pattern === undefined ? undefined : openapi.paths[pattern][verb];
  const befalls_any = at(failure)['x-statuses'].includes(status);
  const tell = (faults) => faults.map((fault) => `openapi.json, ${method} ${pathname} with the status ${status}: ${fault}`);
  if (operation === undefined) {
    const expected = status === (pattern === undefined ? 404 : 405) || befalls_any;
    return tell([...(expected ? [] : ['this is not described']), ...faults_of_content(failure, verb, { type, body })]);
  }
  const pointer = named('paths', pattern, verb);
  if (!(status in operation.responses) && !befalls_any) return tell(['a status that is not described']);
  const response = status in operation.responses ? resolved(`${pointer}/responses/${status}`) : failure;
  const of_request = status < 300 ? faults_of_request(pointer, { query, sent }) : [];
  return tell([...faults_of_content(response, verb, { type, body }), ...of_request]);
}
