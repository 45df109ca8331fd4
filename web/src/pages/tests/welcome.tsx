// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import { type ApiError, as_error, send } from '../../api/client';
import { ask_health, why_read_only } from '../../api/session';
import { FailureNotice } from '../../components/failure';
import { kept_count } from './incoming';
import { t } from './texts';

/** What to do first, in an empty store. */
export function Welcome({ on_choose }: { on_choose: () => void }) {
  return (
    <section class="panel welcome">
      <h2>{t('welcome')}</h2>
      <div class="columns">
        <div class="drop-zone">
          <p>{t('welcome_drop')}</p>
          <button type="button" class="primary" onClick={on_choose}>{t('choose')}</button>
        </div>
        <div>
          <ol>
            <li>{t('welcome_1')}</li>
            <li>{t('welcome_2')} <a href="/plans/new">{t('welcome_plan')}</a></li>
            <li>{t('welcome_3')} <a href="/captures/new">{t('welcome_capture')}</a></li>
          </ol>
          <Examples />
        </div>
      </div>
    </section>
  );
}

/** Instructive tests, so that there is something to look at before there is a file. */
function Examples() {
  const [loading, set_loading] = useState(false);
  const [error, set_error] = useState<ApiError | null>(null);
  const load = async () => {
    set_loading(true);
    try {
      await send('POST', '/api/examples', {});
      set_error(null);
    } catch (failure) {
      set_error(as_error(failure));
    }
    kept_count.value += 1;
    await ask_health();
    set_loading(false);
  };
  return (
    <div class="examples">
      <button type="button" disabled={loading || why_read_only() !== null} onClick={() => void load()}>{t(loading ? 'examples_loading' : 'examples_load')}</button>
      <span class="quiet small">{t('examples_hint')}</span>
      {error && <FailureNotice error={error} />}
    </div>
  );
}
