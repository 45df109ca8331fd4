// SPDX-License-Identifier: Apache-2.0
import { fixed } from '../../numbers';
import { useId } from 'preact/hooks';
import type { DrawnDot, DrawnStroke, Drawing } from './drawing';
import type { SceneScale } from './model';
import type { Flat } from './projection';

interface Props { drawing: Drawing; size: Flat; name: string; on_choose?: ((key: string) => void) | undefined }

/** The flat pieces as SVG, from the back to the front. */
export function Picture({ drawing, size: [width, height], name, on_choose }: Props) {
  const choose = (event: MouseEvent) => {
    const key = (event.target as Element).closest('[data-key]')?.getAttribute('data-key');
    if (key) on_choose?.(key);
  };
  return (
    <svg role="img" aria-label={name} width={width} height={height} viewBox={`0 0 ${width} ${height}`} onClick={choose}>
      {drawing.floor && <polygon class="floor" points={drawing.floor} />}
      {drawing.behind.map((stroke) => <Stroke key={stroke.key} stroke={stroke} />)}
      {drawing.patches.map(({ key, points, colour }) => <polygon key={key} class="patch" points={points} style={{ fill: colour }} />)}
      {drawing.faces.map(({ key, points, colour, edge }) => <polygon key={key} class="face" points={points} style={{ fill: colour, stroke: edge ?? 'none' }} />)}
      {drawing.strokes.map((stroke) => <Stroke key={stroke.key} stroke={stroke} />)}
      {drawing.heads.map(({ key, points, colour }) => <polygon key={key} points={points} style={{ fill: colour }} />)}
      {drawing.dots.map((dot) => <Dot key={dot.key} dot={dot} />)}
      {drawing.words.map(({ key, text, x, y, anchor, kind, colour }) => (
        <text key={key} class={`word ${kind}`} x={x.toFixed(1)} y={y.toFixed(1)} text-anchor={anchor} style={colour ? { fill: colour } : undefined}>{text}</text>
      ))}
    </svg>
  );
}

/** The path to which a piece belongs: "xy.0/h1" is of "xy". */
const owner = (key: string): string => key.replace(/\.\d+(\/h?\d+)?$/, '');

function Stroke({ stroke: { key, from, to, colour, width, dash, hidden, quiet } }: { stroke: DrawnStroke }) {
  return (
    <line data-key={owner(key)} x1={from[0].toFixed(1)} y1={from[1].toFixed(1)} x2={to[0].toFixed(1)} y2={to[1].toFixed(1)} stroke-width={width}
      stroke-dasharray={hidden ? '2 4' : dash?.join(' ')} stroke-linecap={dash || hidden ? 'butt' : 'round'}
      class={hidden ? 'hidden' : quiet ? 'quiet-stroke' : ''} style={{ stroke: colour }} />
  );
}

function Dot({ dot: { key, at: [x, y], colour, size, shape, hidden } }: { dot: DrawnDot }) {
  const r = size / 2;
  const look = { class: hidden ? 'hidden' : '', 'data-key': owner(key) };
  if (shape === 'cross') return <path {...look} d={`M${x - r} ${y - r}L${x + r} ${y + r}M${x - r} ${y + r}L${x + r} ${y - r}`} style={{ stroke: colour }} stroke-width="1.5" />;
  const paint = shape === 'ring' ? { fill: 'var(--surface)', stroke: colour } : { fill: colour };
  return <circle {...look} cx={x.toFixed(1)} cy={y.toFixed(1)} r={r} stroke-width={shape === 'ring' ? 1.5 : 0} style={paint} />;
}

/** What the colours mean: a bar from the least to the most. */
export function ScaleLegend({ scale: { label, unit, low, high, decimals = 1 } }: { scale: SceneScale }) {
  const id = useId();
  return (
    <div class="scene-scale" role="group" aria-labelledby={id}>
      <span id={id}>{label} ({unit})</span>
      <span class="bar" aria-hidden="true" />
      <span class="ends number"><span>{fixed(low, decimals)}</span><span>{fixed(high, decimals)}</span></span>
    </div>
  );
}
