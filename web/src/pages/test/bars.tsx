// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from 'preact';
import { semicolon } from '../../i18n/colon';

export interface Bar { key: string; title: string; detail: ComponentChildren; size: number | null; value: string; share: string | null }

interface Props { head: { what: string; value: string; share: string | null }; absent: string; bars: readonly Bar[] }

/** Sizes beside each other, as a table whose bars are drawn; what does not act is only named, after `absent`. */
export function Bars({ head, absent, bars }: Props) {
  const acting = bars.filter((bar) => bar.size);
  const others = bars.filter((bar) => !bar.size);
  const largest = Math.max(0, ...acting.map((bar) => bar.size ?? 0));
  return (
    <>
    <div class="table-frame" tabIndex={0} role="region" aria-label={head.what}>
      <table class="bars">
        <thead>
          <tr>
            <th scope="col">{head.what}</th><th scope="col" class="number">{head.value}</th><th scope="col"><span class="visually-hidden">{head.what}</span></th>
            {head.share !== null && <th scope="col" class="number">{head.share}</th>}
          </tr>
        </thead>
        <tbody>
          {acting.map((bar) => (
            <tr key={bar.key}>
              <th scope="row">{bar.title}<div class="small quiet">{bar.detail}</div></th>
              <td class="number">{bar.value}</td>
              <td class="bar-cell">
                <svg viewBox="0 0 100 10" preserveAspectRatio="none" aria-hidden="true">
                  <rect x="0" y="1" height="8" width={largest > 0 ? (100 * (bar.size ?? 0)) / largest : 0} />
                </svg>
              </td>
              {head.share !== null && <td class="number">{bar.share}</td>}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
    {others.length > 0 && <p class="small quiet others">{absent} {others.map((bar) => bar.title).join(semicolon())}</p>}
    </>
  );
}
