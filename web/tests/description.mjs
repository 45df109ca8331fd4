// SPDX-License-Identifier: Apache-2.0
// What holds answers against the description must see what is wrong with them.
import assert from 'node:assert/strict';
import { undescribed } from './described.mjs';

export const description = {
  async 'answers that are not as the API is described are seen'(world) {
    const url = `${world.server.address}/api/health`;
    const whole = await world.api('GET', '/api/health');
    const good = { method: 'GET', url, sent: null, status: 200, type: 'application/json', body: JSON.stringify(whole) };
    assert.deepEqual(undescribed(good), []);
    const health = (change) => ({ ...good, body: JSON.stringify({ ...whole, ...change }) });
    const others = [
      health({ colour: 'red' }), health({ status: 'ill' }), health({ store: { ...whole.store, schema: 1.5 } }), { ...good, body: '{' },
      { ...good, status: 201 }, { ...good, status: 409 }, { ...good, type: 'text/plain' }, { ...good, url: `${url}y` },
      { ...good, url: `${url}?colour=red` }, { ...good, method: 'PUT' }, { ...good, sent: '{}' },
    ];
    for (const other of others) assert.notDeepEqual(undescribed(other), [], JSON.stringify(other).slice(0, 200));
    const login = { method: 'POST', url: `${world.server.address}/api/login`, sent: '{"token": ""}', status: 204, body: '' };
    assert.deepEqual(undescribed(login), []);
    for (const sent of [null, '{}', '{"token": 1}']) assert.notDeepEqual(undescribed({ ...login, sent }), [], String(sent));
  },
};
