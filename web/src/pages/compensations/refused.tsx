// SPDX-License-Identifier: Apache-2.0
import type { ApiError } from '../../api/client';
import { FailureNotice } from '../../components/failure';
import { t } from './texts';

/** Why no table comes of it, in the words of the program. */
export function Refused({ error, again }: { error: ApiError; again: () => void }) {
  if (error.kind !== 'bad_input') return <FailureNotice error={error} retry={again} />;
  return (
    <div class="notice bad" role="alert">
      <p class="heading">{t('no_table_made')}</p>
      <p>{error.message}</p>
    </div>
  );
}
