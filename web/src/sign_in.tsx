// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import { type ApiError, as_error, send } from './api/client';
import { ask_health, returned, signed_in } from './api/session';
import { FailureNotice } from './components/failure';
import { Field } from './components/field';
import { t } from './shell_texts';

/** In place of every page until the server knows this browser. */
export function SignIn() {
  const [token, set_token] = useState('');
  const [busy, set_busy] = useState(false);
  const [error, set_error] = useState<ApiError | null>(null);
  const submit = async () => {
    set_busy(true);
    set_error(null);
    try {
      await send('POST', '/api/login', { token });
      signed_in.value = true;
      returned.value += 1;
      void ask_health();
    } catch (failure) {
      set_error(as_error(failure));
    }
    set_busy(false);
  };
  const wrong = error?.kind === 'unauthorised';
  return (
    <section class="panel sign-in">
      <h1 tabIndex={-1}>{t('sign_in')}</h1>
      <p class="quiet">{t('sign_in_why')}</p>
      <form onSubmit={(event) => { event.preventDefault(); void submit(); }}>
        <Field label={t('token')} fault={wrong ? t('token_wrong') : null}>
          {(ids) => (
            <input {...ids} type="password" autoComplete="current-password" required value={token} onInput={(event) => set_token(event.currentTarget.value)} />
          )}
        </Field>
        <button type="submit" class="primary" disabled={busy || token === ''}>{t('sign_in')}</button>
      </form>
      {error && !wrong && <FailureNotice error={error} />}
    </section>
  );
}
