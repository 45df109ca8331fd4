// SPDX-License-Identifier: Apache-2.0
import { fixed, shortest } from '../../numbers';
import { Swatch } from './legend';
import type { ChartModel, ChartPlace } from './model';
import { colon, semicolon } from '../../i18n/colon';

/** An x as it is written in tips: a date, or a number with no more decimals than it needs. */
export function x_text(model: ChartModel, index: number): string {
  const x = model.x[index] ?? 0;
  return model.x_kind === 'time' ? new Date(x * 1000).toISOString().slice(0, 10) : shortest(x);
}

const shown = (model: ChartModel, index: number) =>
  model.series.flatMap((series, i) => {
    const value = series.values[index];
    return series.hidden || series.quiet || typeof value !== 'number' ? [] : [{ series, i, value }];
  });

/** What is at this x: all visible series, the pointed one strong. */
export function PlainTip({ model, place }: { model: ChartModel; place: ChartPlace }) {
  return (
    <>
      <div class="head">{model.x_label}: <span class="number">{x_text(model, place.index)}</span></div>
      <table>
        <tbody>
          {shown(model, place.index).map(({ series, i, value }) => (
            <tr key={series.key} class={i === place.series ? 'strong' : ''}>
              <td><Swatch series={series} /> {series.label}</td>
              <td class="number">{fixed(value, model.y_decimals ?? 2)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </>
  );
}

export function plain_words(model: ChartModel, place: ChartPlace): string {
  const all = shown(model, place.index);
  const wanted = place.series === null ? all : all.filter(({ i }) => i === place.series);
  const said = wanted.map(({ series, value }) => `${series.label} ${fixed(value, model.y_decimals ?? 2)}`).join(semicolon());
  return `${model.x_label} ${x_text(model, place.index)}${colon()} ${said}`;
}
