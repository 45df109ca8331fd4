// SPDX-License-Identifier: Apache-2.0
import { useEffect, useId, useRef, useState } from 'preact/hooks';
import type { CompensatedControl } from '../../api/types';
import { t } from './texts';
import { sign_of, takes } from './uses';

interface Props {
  controls: readonly CompensatedControl[];
  kind: 'linear' | 'rotary';
  chosen: CompensatedControl | null;
  choose: (control: CompensatedControl) => void;
  why?: string | null;    // why this one is chosen, where nobody chose it
  is_turned?: boolean;    // its sign
  can?: (control: CompensatedControl) => boolean;   // which may be chosen; otherwise those that take axes of this kind
}

/** The control of the machine: searched by its name, each with what a positive number in its file does. */
export function ControlChoice({ controls, kind, chosen, choose, why = null, is_turned = false, can = (one) => takes(one, kind) }: Props) {
  const [open, set_open] = useState(false);
  const button = useRef<HTMLButtonElement>(null);
  const close = () => { set_open(false); requestAnimationFrame(() => button.current?.focus()); };
  if (chosen === null || open) {
    return <Search controls={controls} can={can} chosen={chosen} choose={(one) => { choose(one); close(); }} close={chosen === null ? null : close} />;
  }
  return (
    <div class="chosen-control">
      <div class="row spread">
        <strong>{chosen.title}</strong>
        <button ref={button} type="button" class="small no-print" onClick={() => set_open(true)}>{t('another')}</button>
      </div>
      <p class="small quiet">{facts_of(chosen)}{why !== null && <> · {why}</>}</p>
      <p class="small sign"><strong>{t('sign')}</strong> {sign_of(chosen, is_turned)}</p>
    </div>
  );
}

const curves = { 'both-ways': 'curves_both', 'with-backlash': 'curves_backlash', 'each-way': 'curves_each' } as const;

/** "each direction, at most 256 positions" */
export function facts_of({ limits }: CompensatedControl): string {
  const positions = limits.points === 1 ? t('no_table') : limits.points === 2 ? t('scale_only')
    : [limits.points === null ? t('any_positions') : t('most_positions', { n: limits.points }), ...(limits.equidistant ? [t('even')] : [])].join(', ');
  return `${t(curves[limits.curves])}, ${positions}`;
}

const fits = (control: CompensatedControl, words: readonly string[]): boolean => {
  const text = `${control.id} ${control.title}`.toLowerCase();
  return words.every((word) => text.includes(word));
};

/** A field and the list below it: typed words narrow it, arrow keys go through it, Enter chooses. */
function Search({ controls, can, chosen, choose, close }: Pick<Props, 'controls' | 'chosen' | 'choose'> & { can: (control: CompensatedControl) => boolean; close: (() => void) | null }) {
  const [text, set_text] = useState('');
  const [at, set_at] = useState(-1);
  const id = useId();
  const field = useRef<HTMLInputElement>(null);
  const list = useRef<HTMLUListElement>(null);
  const able = controls.filter(can);
  const left_out = controls.length - able.length;
  const words = text.toLowerCase().split(/\s+/).filter((word) => word !== '');
  const found = able.filter((one) => fits(one, words));
  useEffect(() => { if (close !== null) field.current?.focus(); }, []);
  const move = (to: number) => {
    const next = Math.min(Math.max(to, 0), found.length - 1);
    set_at(next);
    list.current?.children[next]?.scrollIntoView({ block: 'nearest' });
  };
  const key = (event: KeyboardEvent) => {
    const wanted = found[at] ?? (found.length === 1 ? found[0] : undefined);
    if (event.key === 'ArrowDown') move(at + 1);
    else if (event.key === 'ArrowUp') move(at - 1);
    else if (event.key === 'Enter') { if (wanted) choose(wanted); }
    else if (event.key === 'Escape' && close !== null) close();
    else return;
    event.preventDefault();
  };
  return (
    <div class="control-search">
      <label for={`${id}-field`} class="visually-hidden">{t('control_search')}</label>
      <input ref={field} id={`${id}-field`} type="text" role="combobox" autocomplete="off" value={text} placeholder={t('control_search')}
        aria-expanded="true" aria-controls={`${id}-list`} aria-autocomplete="list" aria-activedescendant={found[at] ? `${id}-${found[at]?.id}` : undefined}
        onInput={(event) => { set_text(event.currentTarget.value); set_at(-1); }} onKeyDown={key} />
      <ul ref={list} id={`${id}-list`} role="listbox" aria-label={t('controls')}>
        {found.map((one, k) => (
          <li key={one.id} id={`${id}-${one.id}`} role="option" aria-selected={k === at} class={one.id === chosen?.id ? 'chosen' : ''} onClick={() => choose(one)}>
            <strong>{one.title}</strong>
            <span class="small quiet">{facts_of(one)}</span>
            <span class="small">{one.sign}</span>
          </li>
        ))}
      </ul>
      <p class="small quiet" role="status">
        {found.length === 0 ? t('control_none', { text: text.trim() }) : t('control_count', { n: found.length })}
        {left_out > 0 && ` ${t('left_out', { n: left_out })}`}
      </p>
      {close !== null && <button type="button" class="small" onClick={close}>{t('cancel')}</button>}
    </div>
  );
}
