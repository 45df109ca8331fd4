// SPDX-License-Identifier: Apache-2.0
import type { Change } from '../api/types';
import { texts } from '../i18n/texts';
import { when } from '../numbers';
import { Dialog } from './dialog';

const t = texts({
  title: 'Somebody else was first',
  who: '{actor} saved version {version} on {at}',
  because: 'Reason given: “{reason}”',
  what: 'Nothing is lost: what was typed here is still here, and both versions stay in the history.',
  merges: 'Nothing is lost: what was typed here is still here, and both versions stay in the history. What was not touched here is kept as it is there; where both changed the same, what was typed here counts.',
  theirs: 'Look at theirs',
  mine: 'Keep mine as version {next}',
  back: 'Back to editing',
});

interface Props {
  latest: Change & { version: number };   // what the others made
  on_theirs: () => void;
  on_mine: () => void;
  on_close: () => void;
  busy?: boolean;
  merges?: boolean;   // what the others changed stays where nothing was typed here
}

/** Two people edited the same thing: says who was first and asks what is to become of what was typed here. */
export function ConflictDialog({ latest, on_theirs, on_mine, on_close, busy = false, merges = false }: Props) {
  return (
    <Dialog
      title={t('title')} on_close={on_close}
      actions={
        <>
          <button type="button" onClick={on_close}>{t('back')}</button>
          <button type="button" onClick={on_theirs}>{t('theirs')}</button>
          <button type="button" class="primary" disabled={busy} onClick={on_mine}>{t('mine', { next: latest.version + 1 })}</button>
        </>
      }
    >
      <p>{t('who', { actor: latest.actor, version: latest.version, at: when(latest.at) })}{'. '}
        {latest.reason !== '' && t('because', { reason: latest.reason })}</p>
      <p>{t(merges ? 'merges' : 'what')}</p>
    </Dialog>
  );
}
