// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { shows } from './world.mjs';

export const calibration = {
  async 'the calibration that the archive lends follows the date of the test and is no change of it'(world) {
    await world.api('POST', '/api/instruments', {
      role: 'Laser interferometer', manufacturer: 'Example Instruments', type: 'LI-1', serial_number: '1234',
      certificate: 'C-2014', calibrated_on: '2014-01-10', calibration_due: '2015-01-10', inputs: {}, notes: '',
    });
    const id = await world.kept();
    const page = await world.page();
    await page.goto(`/tests/${id}`);
    await shows(page.locator('main'), /9\.6/);
    await page.getByRole('button', { name: 'Edit', exact: true }).click();
    for (const part of [/^\s*Test\s*\d/, /^\s*Test equipment/]) await page.locator('summary', { hasText: part }).click();
    await page.getByLabel('Date of test').fill('2016-05-15');
    await shows(page.locator('main'), /out of calibration: Laser interferometer \(2014-01-10 – 2015-01-10\)/);
    const laser = page.getByRole('group', { name: 'Test equipment, row 1' });
    await shows(page.locator('main'), /Calibration from the archive: 1: C-2014, 2014-01-10 – 2015-01-10/);
    assert.equal(await laser.getByLabel('Certificate').inputValue(), '', 'what the archive lends is not what the file states');
    await laser.getByLabel('Component').fill('Laser head');
    await shows(page.locator('main'), /out of calibration: Laser head \(2014-01-10/);
    await laser.getByLabel('Calibration due').fill('2017-01-10');
    await page.locator('main', { hasText: 'out of calibration' }).waitFor({ state: 'detached' });
  },
};
