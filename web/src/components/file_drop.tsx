// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { drop_taker } from '../drop_anywhere';
import { texts } from '../i18n/texts';
import './file_drop.css';

const t = texts({
  one_at_a_time: 'One file at a time: {n} {n|other file was|other files were} not taken.',
});

interface Props {
  label: string;              // of the button that chooses
  hint: string;               // where one may drop
  accept?: string;
  take: ((file: File) => void) | { all: (files: readonly File[]) => void };
  of_page?: boolean;          // any file that is dropped on its page belongs here
  children?: ComponentChildren;
}

/** A place for one file or, where all are taken, for several; the shell, which would take them for tests, does not get them. */
export function FileDrop({ label, hint, accept, take, of_page = false, children }: Props) {
  const input = useRef<HTMLInputElement>(null);
  const [over, set_over] = useState(false);
  const [left, set_left] = useState(0);   // of several that were dropped where one is taken
  const takes_one = typeof take === 'function';
  const given = (files: readonly File[]) => {
    const [first] = files;
    if (first === undefined) return;
    if (takes_one) take(first);
    else take.all(files);
    set_left(takes_one ? files.length - 1 : 0);
  };
  const given_now = useRef(given);
  given_now.current = given;
  useEffect(() => {
    if (!of_page) return undefined;
    drop_taker.value = (files) => given_now.current(files);
    return () => { drop_taker.value = null; };
  }, [of_page]);
  const carries = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
  return (
    <div class={`file-drop ${over ? 'over' : ''}`}
      onDragOver={(event) => { if (carries(event)) { event.preventDefault(); set_over(true); } }}
      onDragLeave={(event) => { if (!(event.currentTarget as Element).contains(event.relatedTarget as Node | null)) set_over(false); }}
      onDrop={(event) => {
        set_over(false);
        const files = [...(event.dataTransfer?.files ?? [])];
        if (files.length === 0) return;
        event.preventDefault();
        given(files);
      }}>
      <button type="button" onClick={() => input.current?.click()}>{label}</button>
      <span class="quiet small">{hint}</span>
      {children}
      {left > 0 && <p class="notice caution" role="status">{t('one_at_a_time', { n: left })}</p>}
      <input ref={input} type="file" hidden multiple={!takes_one} accept={accept} aria-label={label} onChange={(event) => {
        given([...(event.currentTarget.files ?? [])]);
        event.currentTarget.value = '';   // the same file again is a new choice
      }} />
    </div>
  );
}
