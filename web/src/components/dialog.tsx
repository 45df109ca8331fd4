// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from 'preact';
import { useEffect, useId, useRef } from 'preact/hooks';
import { texts } from '../i18n/texts';
import './dialog.css';

const t = texts({ close: 'Close' });

interface Props {
  title: ComponentChildren;
  on_close: () => void;            // Escape, the cross, or a click beside it
  children: ComponentChildren;
  actions?: ComponentChildren;     // at the bottom; the main one last
  on_submit?: () => void;          // makes the dialog a form: Enter does it
  side?: boolean;                  // a drawer at the right edge, full height
  wide?: boolean;
}

/** A question or a form over the page; the browser keeps the focus in it and gives it back afterwards. */
export function Dialog({ title, on_close, children, actions, on_submit, side = false, wide = false }: Props) {
  const dialog = useRef<HTMLDialogElement>(null);
  const heading = useId();
  useEffect(() => {
    const shown = dialog.current;
    const before = document.activeElement;
    shown?.showModal();
    shown?.querySelector<HTMLElement>('[data-first]')?.focus();
    return () => { if (before instanceof HTMLElement && before.isConnected) before.focus(); };
  }, []);
  const inner = (
    <>
      <header>
        <h2 id={heading}>{title}</h2>
        <button type="button" class="plain" onClick={on_close} aria-label={t('close')}>
          <svg width="14" height="14" viewBox="0 0 14 14" aria-hidden="true"><path d="M2 2l10 10M12 2L2 12" stroke="currentColor" stroke-width="1.6" /></svg>
        </button>
      </header>
      <div class="content" tabIndex={side ? 0 : undefined}>{children}</div>
      {actions && <footer>{actions}</footer>}
    </>
  );
  return (
    <dialog
      ref={dialog} class={`${side ? 'side' : ''} ${wide ? 'wide' : ''}`} aria-labelledby={heading}
      onCancel={(event) => { event.preventDefault(); on_close(); }}
      onMouseDown={(event) => { if (event.target === dialog.current && !on_submit) on_close(); }}
    >
      {on_submit
        ? <form noValidate onSubmit={(event) => { event.preventDefault(); on_submit(); }}>{inner}</form>
        : <div class="form">{inner}</div>}
    </dialog>
  );
}

/** Help or details beside the page. */
export function Drawer(props: Pick<Props, 'title' | 'on_close' | 'children'>) {
  return <Dialog {...props} side />;
}
