// SPDX-License-Identifier: Apache-2.0
import { shows } from './world.mjs';

// What a user does on the page of a test, in the words of the page.

export async function edit_field(page, label, text) {
  const field = page.getByLabel(label).first();
  const edit = page.getByRole('button', { name: 'Edit', exact: true });
  await field.or(edit).filter({ visible: true }).first().waitFor();
  if (!(await field.isVisible()) && (await edit.isVisible())) await edit.click();  // neither: its group just opens
  await field.fill(text);
}

/** Saves the draft as a new version; with a conflict, up to the point where it is told. */
export async function save_version(page, reason, { conflict = false } = {}) {
  await page.getByRole('button', { name: /^Save/ }).first().click();
  const dialog = page.getByRole('dialog');
  await dialog.waitFor();
  await dialog.getByLabel(/reason/i).fill(reason);
  await dialog.getByRole('button', { name: 'Save', exact: true }).click();
  if (!conflict) await dialog.waitFor({ state: 'hidden', timeout: 60_000 });  // Monte Carlo of record is drawn again
}

/** The uncertainties of the parameters as they are shown. */
export const uncertainties = (page) => page.locator('.headline').innerText();

/** Waits until the page shows that version of the test. */
export const shows_version = (page, version) => shows(page.locator('.archive-panel tbody').first(), new RegExp(`\\b${version}\\s+shown`));
