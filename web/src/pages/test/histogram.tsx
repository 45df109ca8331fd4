// SPDX-License-Identifier: Apache-2.0
import type { MonteCarloOutput, MonteCarloRun } from '../../api/types';
import { texts } from '../../i18n/texts';
import { fixed, marked } from '../../numbers';

const t = texts({
  picture: ['Distribution of {symbol} over the trials', 'Verteilung von {symbol} über die Versuche'],
  value: ['measured', 'gemessen'],
  mean: ['mean', 'Mittel'],
  u: ['u', 'u'],
  symmetric: ['{percent} % interval', '{percent}-%-Intervall'],
  shortest: ['shortest {percent} %', 'kürzestes {percent} %'],
  trials: ['{trials} trials, seed {seed}', '{trials} Versuche, Startwert {seed}'],
  unstable: ['the last digit is not yet stable', 'die letzte Stelle ist noch nicht stabil'],
  outside: ['The measured value lies outside its interval: noise of the readings enlarges it.', 'Der gemessene Wert liegt außerhalb seines Intervalls: das Rauschen der Messwerte vergrößert ihn.'],
});

const width = 520;
const height = 150;
const foot = 20;

/** What the trials say of one parameter: their histogram, both intervals, the measured value. */
export function Histogram({ output, run, unit, symbol }: {
  output: MonteCarloOutput; run: MonteCarloRun | null; unit: string; symbol: string;
}) {
  const { lower, width: bin, counts } = output.histogram;
  const last = lower + bin * counts.length;
  const ends = [lower, last, output.value, ...output.symmetric];
  const [low, high] = [Math.min(...ends), Math.max(...ends)];
  const reach = high > low ? high - low : 1;
  const x = (value: number): number => 8 + ((value - low) / reach) * (width - 16);
  const most = Math.max(1, ...counts);
  const bottom = height - foot;
  const outline = counts.map((count, i) => `L${x(lower + i * bin)} ${bottom - (count / most) * (bottom - 14)}H${x(lower + (i + 1) * bin)}`).join('');
  const percent = fixed(100 * (run?.coverage ?? 0.95), 0);
  const inside = output.value >= output.symmetric[0] && output.value <= output.symmetric[1];
  const rows: [string, string][] = [
    [t('value'), fixed(output.value, 3)], [t('mean'), fixed(output.mean, 3)], [t('u'), fixed(output.u, 3)],
    [t('symmetric', { percent }), `${fixed(output.symmetric[0], 3)} … ${fixed(output.symmetric[1], 3)}`],
    [t('shortest', { percent }), `${fixed(output.shortest[0], 3)} … ${fixed(output.shortest[1], 3)}`],
  ];
  return (
    <div class="histogram">
      <svg viewBox={`0 0 ${width} ${height}`} role="img" aria-label={t('picture', { symbol })}>
        <rect class="interval" x={x(output.symmetric[0])} y="4" width={x(output.symmetric[1]) - x(output.symmetric[0])} height={bottom - 4} />
        <path class="counts" d={`M${x(lower)} ${bottom}${outline}V${bottom}Z`} />
        <line class="floor" x1="8" x2={width - 8} y1={bottom} y2={bottom} />
        {output.symmetric.map((end) => <line key={end} class="end" x1={x(end)} x2={x(end)} y1="4" y2={bottom} />)}
        <line class="measured" x1={x(output.value)} x2={x(output.value)} y1="4" y2={bottom + 4} />
        {output.symmetric.map((end, i) => (
          <text key={i} x={x(end)} y={height - 5} text-anchor={i === 0 ? 'start' : 'end'}>{fixed(end, 2)}</text>
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
      {!inside && <p class="small">{t('outside')}</p>}
    </div>
  );
}
