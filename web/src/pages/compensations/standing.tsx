// SPDX-License-Identifier: Apache-2.0
// What became of the tests that a kept table rests on.
import type { CompensationResult, CompensationTest, KeptCompensation } from '../../api/types';
import { t } from './texts';

/** Beside a test: that it was withdrawn, or that its latest version is another one than what was used. */
export function StandingTags({ test }: { test: CompensationTest }) {
  return (
    <>
      {test.withdrawn && <> <span class="tag bad">{t('withdrawn')}</span></>}
      {test.revised && <> <span class="tag bad">{t('revised', { n: test.latest })}</span></>}
    </>
  );
}

const counts = (test: CompensationTest | null): boolean => test !== null && !test.withdrawn && !test.revised;

/** The result with the findings that are of record, and without a re-test that no longer counts. */
export function counting_result(found: KeptCompensation): CompensationResult {
  const { retest, ...rest } = found.result;
  const result = { ...rest, findings: found.findings };
  return retest && counts(found.retest) ? { ...result, retest } : result;
}
