// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import { type ApiError, as_error, send } from '../../api/client';
import type { Capture } from '../../api/types';
import { Dialog } from '../../components/dialog';
import { FailureNotice } from '../../components/failure';
import { t } from './texts';

/** Asks before it ends a capture: it cannot be gone on with. */
export function StopButton({ capture, what, stopped }: { capture: Capture; what: string; stopped: (capture: Capture) => void }) {
  const [asking, set_asking] = useState(false);
  const [error, set_error] = useState<ApiError | null>(null);
  const stop = () => {
    set_asking(false);
    send<Capture>('POST', `/api/captures/${capture.id}/stop`, {}).then(
      stopped,
      (failure: unknown) => set_error(as_error(failure)),
    );
  };
  return (
    <>
      <button type="button" class="stop" onClick={() => set_asking(true)}>{t('stop')}</button>
      {error && <FailureNotice error={error} retry={stop} />}
      {asking && (
        <Dialog
          title={t('stop_ask')} on_close={() => set_asking(false)}
          actions={
            <>
              <button type="button" data-first onClick={() => set_asking(false)}>{t('go_on')}</button>
              <button type="button" class="stop" onClick={stop}>{t('stop')}</button>
            </>
          }
        >
          <p>{what}</p>
        </Dialog>
      )}
    </>
  );
}
