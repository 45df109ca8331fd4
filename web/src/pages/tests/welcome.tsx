// SPDX-License-Identifier: Apache-2.0
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
          <p class="quiet">{t('welcome_example')}</p>
        </div>
      </div>
    </section>
  );
}
