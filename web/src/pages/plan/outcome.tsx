// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from 'preact';
import type { PlanDraft, PlanFile, PlanPart } from '../../api/types';
import { CopyButton } from '../../components/copy';
import { FindingList } from '../../components/findings';
import { picture } from '../../components/report_parts';
import { fixed, shortest } from '../../numbers';
import { t } from './texts';

/** Whether positions (EXX) are among what is read at its stops; of others the standard says nothing, and their readings do not show the stops. */
export const is_of_positions = ({ errors }: PlanFile): boolean => !errors || errors.length === 0 || errors.some((name) => name[1] === name[2]);

/** What a plan comes to: the figures first, then what the standard says, then the way of the axis in the chosen test. */
export function Outcome({ draft, figure_on_paper, unit, part, choose, children }: {
  draft: PlanDraft; figure_on_paper: string | null; unit: string; part: PlanPart | null;
  choose: (part: number) => void; children?: ComponentChildren;
}) {
  const chosen = draft.plan;
  const targets = part?.targets ?? draft.targets;
  const runs = part?.runs ?? chosen.runs;
  const errors = chosen.errors ?? [];
  const of_positions = is_of_positions(chosen);
  const accords = draft.conforming && !(of_positions && draft.findings.some((finding) => finding.severity === 'missing'));
  const alt = t('figure_of', { n: targets.length, runs });
  return (
    <section class="panel outcome" aria-label={t('programme')}>
      <div class="row spread">
        <dl class="figures">
          {errors.length > 0 && <Figure name={t('errors')} value={errors.join(', ')} />}
          <Figure name={t('targets')} value={String(targets.length)} />
          <Figure name={t('runs')} value={String(runs)} />
          {part && <Figure name={t('readings')} value={String(part.readings)} />}
          <Figure name={t('duration')} value={lasting(draft.duration_s)} />
          <Figure name={t('feed')} value={shortest(chosen.feed)} unit={`${unit}/min`} />
          <Figure name={t('overrun')} value={shortest(chosen.overrun)} unit={unit} />
        </dl>
        <p class={`mark ${accords ? 'good' : 'bad'}`}>
          <svg width="14" height="14" viewBox="0 0 14 14" aria-hidden="true">
            <path d={accords ? 'M2.5 7.5l3 3 6-7' : 'M3 3l8 8M11 3l-8 8'} fill="none" stroke="currentColor" stroke-width="2" />
          </svg>
          {t(of_positions ? (accords ? 'conforming' : draft.conforming ? 'not_yet' : 'departing') : draft.conforming ? 'made_for' : 'cannot_follow')}
        </p>
      </div>
      {draft.findings.length > 0 && <FindingList findings={draft.findings} />}
      <PartChoice parts={draft.parts ?? []} part={part} choose={choose} />
      <div class="drawn-frame" role="group" aria-label={t('way')} tabIndex={0}>
        <img class={`drawn ${figure_on_paper ? 'no-print' : ''}`} src={picture(part?.figure_svg ?? draft.figure_svg)} alt={alt} />
        {figure_on_paper && <img class="drawn only-print" src={picture(figure_on_paper)} alt={alt} />}
      </div>
      {children}
    </section>
  );
}

/** A long axis is tested in several parts, each of which is a test of its own. */
function PartChoice({ parts, part, choose }: { parts: PlanPart[]; part: PlanPart | null; choose: (part: number) => void }) {
  if (parts.length < 2) return null;
  return (
    <div class="row" role="group" aria-label={t('part')}>
      {parts.map((one) => (
        <button key={one.part} type="button" aria-pressed={one.part === part?.part} onClick={() => choose(one.part)}>
          {one.part} {one.title}
        </button>
      ))}
    </div>
  );
}

function Figure({ name, value, unit }: { name: string; value: string; unit?: string }) {
  return (
    <div>
      <dt>{name}</dt>
      <dd class="number">{value}{unit && <span class="unit"> {unit}</span>}</dd>
    </div>
  );
}

/** As a picture of its own: what the drawing says can do nothing here. */

export function lasting(seconds: number): string {
  if (seconds < 90) return t('seconds', { n: Math.round(seconds) });
  const minutes = Math.round(seconds / 60);
  return minutes < 120 ? t('minutes', { n: minutes }) : t('hours', { h: Math.floor(minutes / 60), m: minutes % 60 });
}

export function TargetTable({ targets, unit }: { targets: number[]; unit: string }) {
  return (
    <section class="panel flush targets">
      <header>
        <h2>{t('targets')}</h2>
        <div class="no-print"><CopyButton label={t('copy_targets')} text={() => targets.map((target) => shortest(target, 6).replace('\u2212', '-')).join('\n')} /></div>
      </header>
      <div class="table-frame" role="region" aria-label={t('targets')} tabIndex={0}>
        <table>
          <thead>
            <tr>
              <th scope="col" class="number">i</th>
              <th scope="col" class="number">{t('position')} / {unit}</th>
              <th scope="col" class="number">{t('interval')} / {unit}</th>
            </tr>
          </thead>
          <tbody>
            {targets.map((target, i) => (
              <tr key={i}>
                <th scope="row" class="number">{i + 1}</th>
                <td class="number">{fixed(target, 3)}</td>
                <td class="number quiet">{i === 0 ? '' : fixed(target - (targets[i - 1] as number), 3)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </section>
  );
}
