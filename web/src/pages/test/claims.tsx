// SPDX-License-Identifier: Apache-2.0
// What the result may be called: three claims, each of its own.
import type { Claim } from '../../api/types';
import { sentence } from '../../components/findings';
import { Formula } from '../../components/formula';
import { Mark } from '../../components/verdict';
import { texts } from '../../i18n/texts';

const t = texts({
  title: 'What may be claimed',
  holds: 'holds',
  fails: 'does not hold',
  missing: '{n} {n|point is|points are} missing',
});

export function Claims({ claims }: { claims: readonly Claim[] }) {
  return (
    <ul class="claims" aria-label={t('title')}>
      {claims.map((claim) => (
        <li key={claim.key}>
          <Mark tone={claim.holds ? 'good' : 'caution'} word={t(claim.holds ? 'holds' : 'fails')} short /> <span class="claim-title"><Formula text={sentence(claim.title).replace(/\.$/, '')} /></span>
          {claim.holds && claim.remark !== undefined && <p class="small quiet"><Formula text={sentence(claim.remark)} /></p>}
          {claim.missing.length > 0 && (
            <details class="small">
              <summary>{t('missing', { n: claim.missing.length })}</summary>
              <ul>{claim.missing.map(({ id, message }, i) => <li key={i}><Formula text={sentence(message)} /> <span class="quiet mono">{id}</span></li>)}</ul>
            </details>
          )}
        </li>
      ))}
    </ul>
  );
}
