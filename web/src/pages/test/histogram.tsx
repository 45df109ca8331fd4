// SPDX-License-Identifier: Apache-2.0
import type { MonteCarloOutput, MonteCarloRun } from '../../api/types';
import { stated_interval } from '../../components/uncertainty';
import { texts } from '../../i18n/texts';
import { decimals_for, fixed, marked } from '../../numbers';

const t = texts({
  picture: 'Distribution of {symbol} over the trials',
  value: 'measured',
  mean: 'mean',
  u: 'u',
  stated: '{percent} % interval',
  refused: 'No interval is stated: {reason}.',
  of_one: 'Mean, u and histogram are those of the hypothesis about the noise with the largest u; the interval holds for all of them.',
  trials: '{trials} trials, seed {seed}',
  unstable: 'the last digit is not yet stable',
});

const width = 520;
const height = 150;
const foot = 20;

/** What the trials say of one parameter: their histogram, the interval that is stated, the measured value. */
export function Histogram({ output, run, decimals, unit, symbol }: {
  output: MonteCarloOutput; run: MonteCarloRun | null; unit: string; symbol: string;
  decimals: number;      // of the parameter
}) {
  const interval = stated_interval(output);
  if (interval === null) return <p class="notice caution">{t('refused', { reason: output.refusal ?? '' })}</p>;
  const { lower, width: bin, counts } = output.histogram;
  const last = lower + bin * counts.length;
  const ends = [lower, last, output.value, ...interval];
  const [low, high] = [Math.min(...ends), Math.max(...ends)];
  const reach = high > low ? high - low : 1;
  const x = (value: number): number => 8 + ((value - low) / reach) * (width - 16);
  const most = Math.max(1, ...counts);
  const bottom = height - foot;
  const outline = counts.map((count, i) => `L${x(lower + i * bin)} ${bottom - (count / most) * (bottom - 14)}H${x(lower + (i + 1) * bin)}`).join('');
  const percent = fixed(100 * (run?.coverage ?? 0.95), 0);
  const rows: [string, string][] = [
    [t('value'), fixed(output.value, decimals)], [t('mean'), fixed(output.mean, decimals)], [t('u'), fixed(output.u, Math.max(decimals, decimals_for(output.u, 2)))],
    [t('stated', { percent }), interval.map((end) => fixed(end, decimals)).join(' … ')],
  ];
  return (
    <div class="histogram">
      <svg viewBox={`0 0 ${width} ${height}`} role="img" aria-label={t('picture', { symbol })}>
        <rect class="interval" x={x(interval[0])} y="4" width={x(interval[1]) - x(interval[0])} height={bottom - 4} />
        <path class="counts" d={`M${x(lower)} ${bottom}${outline}V${bottom}Z`} />
        <line class="floor" x1="8" x2={width - 8} y1={bottom} y2={bottom} />
        {interval.map((end) => <line key={end} class="end" x1={x(end)} x2={x(end)} y1="4" y2={bottom} />)}
        <line class="measured" x1={x(output.value)} x2={x(output.value)} y1="4" y2={bottom + 4} />
        {interval.map((end, i) => (
          <text key={i} x={x(end)} y={height - 5} text-anchor={i === 0 ? 'start' : 'end'}>{fixed(end, decimals)}</text>
        ))}
      </svg>
      <dl class="test-facts small">
        {rows.map(([label, text]) => <div key={label}><dt>{label}</dt><dd class="number">{text} {unit}</dd></div>)}
      </dl>
      {run && (
        <p class="small quiet">
          {t('trials', { trials: marked(String(run.trials).replace(/\B(?=(\d{3})+$)/g, '\u2009')), seed: run.seed })}
          {!output.stable && <>; {t('unstable')}</>}
        </p>
      )}
      {run && (run.hypotheses ?? []).filter(({ refuted }) => !refuted).length > 1 && <p class="small">{t('of_one')}</p>}
    </div>
  );
}
