// SPDX-License-Identifier: Apache-2.0
// What a file says to a control, how it gets there, what of its format is sure; and the file itself.
import { offer } from '../../api/client';
import type { CompensatedControl, CompensationResult } from '../../api/types';
import { CopyButton } from '../../components/copy';
import { Listing, line_count } from '../../components/listing';
import { t } from './texts';
import { sign_of } from './uses';

type Described = Pick<CompensationResult, 'sign'> & { verified: CompensationResult['verified']; loading: string | null };

export function described_by(control: CompensatedControl, is_turned = false): Described {
  const { loading, verified, inferred } = control;
  return { sign: sign_of(control, is_turned), loading, verified: { verified, inferred } };
}

export function AboutFormat({ sign, loading, verified: { verified, inferred } }: Described) {
  return (
    <dl class="about-format">
      <div><dt>{t('sign')}</dt><dd>{sign}</dd></div>
      {loading !== null && <div><dt>{t('loading_title')}</dt><dd>{loading}</dd></div>}
      <div><dt>{t('verified')}</dt><dd>{verified}</dd></div>
      <div class={inferred === '' ? '' : 'inferred'}><dt>{t('inferred')}</dt><dd>{inferred === '' ? t('nothing_inferred') : inferred}</dd></div>
    </dl>
  );
}

/** The file for the control: to be looked at, copied, and taken along where `href` is none yet. */
export function TableText({ text, name, stale = false, href = null }: { text: string; name: string; stale?: boolean; href?: string | null }) {
  return (
    <section class="panel table-file" aria-labelledby="table-text">
      <header>
        <h2 id="table-text">{t('file')} <span class="quiet small mono">{name}</span></h2>
        <div class="row no-print">
          <CopyButton text={() => text} disabled={stale} />
          {href === null
            ? <button type="button" disabled={stale} onClick={() => offer(new Blob([text], { type: 'application/octet-stream' }), name)}>{t('download')}</button>
            : <a class="button" href={href} download={name}>{t('download')}</a>}
        </div>
      </header>
      <Listing text={text} label={t('file')} stale={stale} />
      <p class="quiet small">{t('lines', { n: line_count(text) })}</p>
    </section>
  );
}
