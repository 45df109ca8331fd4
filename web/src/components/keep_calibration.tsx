// SPDX-License-Identifier: Apache-2.0
// Keeping what a tracking interferometer found, with the files it was evaluated from: the button, and the form behind it.
import { useState } from 'preact/hooks';
import { ApiError, as_error, made_of_files } from '../api/client';
import { why_read_only } from '../api/session';
import type { KeptCalibration, CalibrationKind, Receipt } from '../api/types';
import { texts } from '../i18n/texts';
import { CalibrationFields, empty_words, type CalibrationWords } from './calibration_fields';
import { Dialog } from './dialog';
import { FailureNotice } from './failure';

const t = texts({
  keep: 'Keep in the archive',
  keep_title: 'Keep this calibration',
  keep_how: 'The files are kept as they are, with the options and the result. What you leave empty is taken from the files.',
  cancel: 'Cancel',
  close: 'Close',
  do_keep: 'Keep',
  kept: 'Kept as calibration {id}',
  same: 'the same files as calibration {list}',
});

/** Files under what they are for: of lines lengths, plan and perhaps station; of the 21 errors lengths and machine. */
export interface SentCalibration { kind: CalibrationKind; files: Readonly<Record<string, File | null>>; options: string }

function form_of({ kind, files, options }: SentCalibration, words: CalibrationWords): FormData {
  const form = new FormData();
  form.append('kind', kind);
  form.append('options', options);
  form.append('about', JSON.stringify(words));
  for (const [role, file] of Object.entries(files)) if (file) form.append(role, file, file.name);
  return form;
}

async function keep(sent: SentCalibration, words: CalibrationWords): Promise<KeptCalibration> {
  const answer = await made_of_files('/api/calibrations', form_of(sent, words));
  const content = (await answer.json()) as KeptCalibration | Receipt;
  if ('kept' in content) throw new ApiError('kept', content.message, answer.status, '', content);
  return content;
}

/** A button; once it is kept, the way to it. `sent` is what was evaluated, so that a change of it is another one. */
export function KeepCalibration({ sent }: { sent: SentCalibration }) {
  const [open, set_open] = useState(false);
  const [kept, set_kept] = useState<{ sent: SentCalibration; of: KeptCalibration } | null>(null);
  if (kept?.sent === sent) {
    const { id, same_files: same = [] } = kept.of;
    return <><a class="button" href={`/calibrations/${id}`}>{t('kept', { id })}</a>{same.length > 0 && <span class="quiet small"> {t('same', { list: same.join(', ') })}</span>}</>;
  }
  return (
    <>
      <button type="button" class="primary" disabled={why_read_only() !== null} onClick={() => set_open(true)}>{t('keep')}</button>
      {open && <KeepDialog sent={sent} on_close={() => set_open(false)} on_kept={(of) => { set_kept({ sent, of }); set_open(false); }} />}
    </>
  );
}

function KeepDialog({ sent, on_close, on_kept }: { sent: SentCalibration; on_close: () => void; on_kept: (of: KeptCalibration) => void }) {
  const [words, set_words] = useState<CalibrationWords>(empty_words);
  const [busy, set_busy] = useState(false);
  const [error, set_error] = useState<ApiError | null>(null);
  const is_kept = error?.kind === 'kept';  // though it cannot be shown: another time would be another one
  const submit = async () => {
    if (busy || is_kept) return;
    set_busy(true);
    set_error(null);
    try {
      on_kept(await keep(sent, words));
    } catch (thrown) {
      set_error(as_error(thrown));
      set_busy(false);
    }
  };
  return (
    <Dialog
      title={t('keep_title')} on_close={on_close} on_submit={() => void submit()}
      actions={
        <>
          <button type="button" onClick={on_close}>{t(is_kept ? 'close' : 'cancel')}</button>
          <button type="submit" class="primary" disabled={busy || is_kept}>{t('do_keep')}</button>
        </>
      }
    >
      <div class="stack">
        <p class="hint">{t('keep_how')}</p>
        <CalibrationFields words={words} on_change={set_words} />
        {error && <FailureNotice error={error} />}
      </div>
    </Dialog>
  );
}
