// SPDX-License-Identifier: Apache-2.0
// node web/api_types.mjs [FILE]: writes src/api/types.ts, the shapes of apps/server/openapi.json, which must be sound
// OpenAPI.
import { createConfig, lintFromString } from '@redocly/openapi-core';
import openapiTS, { astToString } from 'openapi-typescript';
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const described = fileURLToPath(new URL('../apps/server/openapi.json', import.meta.url));
const [file = fileURLToPath(new URL('src/api/types.ts', import.meta.url))] = process.argv.slice(2);
const head = `// SPDX-License-Identifier: Apache-2.0
// Made of apps/server/openapi.json by api_types.mjs, which "npm run build" runs. What is to change changes there.

`;

const source = readFileSync(described, 'utf8');
// What may befall any request is said once, as the default.
const config = await createConfig({ extends: ['recommended-strict'], rules: { 'operation-4xx-response': 'off' } });
const faults = await lintFromString({ source, config, absoluteRef: described });
for (const { ruleId, message, location } of faults) console.error(`apps/server/openapi.json${location[0]?.pointer ?? ''}: ${message} (${ruleId})`);
if (faults.length > 0) process.exit(1);

const { components, ...rest } = JSON.parse(source);
const shapes = await openapiTS({ ...rest, paths: {}, components: { schemas: components.schemas } },
  { rootTypes: true, rootTypesNoSchemaPrefix: true, silent: true });
const exported = shapes.filter(({ name }) => !['paths', 'webhooks', 'operations', '$defs'].includes(name?.text));
writeFileSync(file, head + astToString(exported));
