// SPDX-License-Identifier: Apache-2.0
// How a machine is built, chosen by words and shown as a picture: what stands on what.
import { Field } from '../../components/field';
import { t } from './texts';

export const usual_chains = ['XYFZ', 'YXFZ', 'XFYZ', 'YFXZ', 'FXYZ', 'FYXZ', 'ZFXY', 'XFZY'] as const;
export type UsualChain = (typeof usual_chains)[number];

export const is_chain = (text: string): boolean => [...text].sort().join('') === 'FXYZ';
const word = (link: string): string => (link === 'F' ? t('bed') : link);

/** From a file: the ends may be written, and b for the bed. */
export const chain_of_text = (text: string): string => text.replace(/^w/, '').replace(/t$/, '').replace('b', 'F');

interface Props { chain: string; other: boolean; fault: string | null; set: (chain: string, other: boolean) => void }

export function ChainFields({ chain, other, fault, set }: Props) {
  const is_usual = !other && (usual_chains as readonly string[]).includes(chain);
  return (
    <>
      <Field label={t('chain')} hint={t('chain_hint')}>
        {(ids) => (
          <select {...ids} value={is_usual ? chain : 'other'} onChange={(event) => (event.currentTarget.value === 'other' ? set(chain, true) : set(event.currentTarget.value, false))}>
            {usual_chains.map((one) => <option key={one} value={one}>{t(one)}</option>)}
            <option value="other">{t('other')}</option>
          </select>
        )}
      </Field>
      {!is_usual && (
        <fieldset class="triple links">
          <legend>{t('from_workpiece')}</legend>
          <div>
            {[0, 1, 2, 3].map((k) => (
              <select key={k} aria-label={t('link', { n: k + 1 })} aria-invalid={fault ? 'true' : undefined} value={chain[k]}
                onChange={(event) => set(`${chain.slice(0, k)}${event.currentTarget.value}${chain.slice(k + 1)}`, true)}>
                {['X', 'Y', 'Z', 'F'].map((link) => <option key={link} value={link}>{word(link)}</option>)}
              </select>
            ))}
          </div>
          {fault && <span class="fault">{fault}</span>}
        </fieldset>
      )}
      {is_chain(chain) && <ChainPicture chain={chain} />}
    </>
  );
}

/** Two stacks on the bed: what carries the workpiece, and what carries the tool. */
function ChainPicture({ chain }: { chain: string }) {
  const at = chain.indexOf('F');
  const table = [...chain.slice(0, at)].reverse();  // from the bed upwards
  const head = [...chain.slice(at + 1)];
  const [step, width] = [22, 96];
  const height = Math.max(table.length, head.length) * step + 66;
  const stack = (links: string[], left: number, top_word: string, pointed: boolean) => (
    <>
      {links.map((link, k) => {
        const y = height - 26 - (k + 1) * step;
        return (
          <g key={link}>
            <rect x={left} y={y} width={width} height={step - 4} rx="2" class="link" />
            <path class="moves" d={`M${left + 10} ${y + 9}h${width - 20}m-5 -4l5 4-5 4M${left + 15} ${y + 5}l-5 4 5 4`} />
            <rect class="plate" x={left + width / 2 - 11} y={y + 1} width="22" height={step - 6} />
            <text x={left + width / 2} y={y + 13.5} text-anchor="middle">{link}</text>
          </g>
        );
      })}
      {pointed
        ? <path class="top" d={`M${left + width / 2 - 9} ${height - 30 - links.length * step - 14}h18l-6 14h-6z`} />
        : <rect class="top" x={left + width / 2 - 18} y={height - 30 - links.length * step - 14} width="36" height="14" rx="2" />}
      <text class="name" x={left + width / 2} y={height - 30 - links.length * step - 19} text-anchor="middle">{top_word}</text>
    </>
  );
  const links = [t('workpiece'), ...[...chain].map(word), t('tool')].join(' → ');
  return (
    <svg class="chain" role="img" aria-label={t('chain_told', { links })} viewBox={`0 0 240 ${height}`} width="240" height={height}>
      <rect x="4" y={height - 26} width="232" height="20" rx="2" class="bed" />
      <text x="120" y={height - 12} text-anchor="middle">{t('bed')}</text>
      {stack(table, 14, t('workpiece'), false)}
      {stack(head, 130, t('tool'), true)}
    </svg>
  );
}
