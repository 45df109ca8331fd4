// SPDX-License-Identifier: Apache-2.0
// Who signs out leaves nothing of theirs in this browser: no name, no unsaved edits, no chosen files, no set-up, in no tab.
import { send } from './api/client';
import { ask_health, signed_in } from './api/session';
import { forget_drafts } from './pages/test/draft_store';
import { remove_all } from './pages/tests/incoming';
import { tracking_kept } from './pages/tracking/kept';
import { volume_kept } from './pages/volume/kept';
import { actor } from './settings';

const other_tabs = new BroadcastChannel('axiometry.signed-out');

function forget(): void {
  signed_in.value = false;  // takes every page away, and what it holds with it
  remove_all();
  forget_drafts();
  tracking_kept.forget();
  volume_kept.forget();
  actor.value = '';
}

other_tabs.onmessage = () => {
  forget();
  void ask_health();
};

/** Whatever becomes of the request, ask_health() then finds out whether this browser is still known. */
export async function sign_out(): Promise<void> {
  await send<null>('POST', '/api/logout', {}).catch(() => null);
  forget();
  other_tabs.postMessage(null);
  await ask_health();
}
