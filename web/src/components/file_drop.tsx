// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from 'preact';
import { useRef, useState } from 'preact/hooks';
import './file_drop.css';

interface Props {
  label: string;              // of the button that chooses
  hint: string;               // where one may drop
  accept?: string;
  take: (file: File) => void;
  children?: ComponentChildren;
}

/** A place for one file, dropped or chosen; the shell, which would take it for a test, does not get it. */
export function FileDrop({ label, hint, accept, take, children }: Props) {
  const input = useRef<HTMLInputElement>(null);
  const [over, set_over] = useState(false);
  const carries = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
  return (
    <div class={`file-drop ${over ? 'over' : ''}`}
      onDragOver={(event) => { if (carries(event)) { event.preventDefault(); set_over(true); } }}
      onDragLeave={(event) => { if (!(event.currentTarget as Element).contains(event.relatedTarget as Node | null)) set_over(false); }}
      onDrop={(event) => {
        set_over(false);
        const file = event.dataTransfer?.files[0];
        if (!file) return;
        event.preventDefault();
        take(file);
      }}>
      <button type="button" onClick={() => input.current?.click()}>{label}</button>
      <span class="quiet small">{hint}</span>
      {children}
      <input ref={input} type="file" hidden accept={accept} aria-label={label} onChange={(event) => {
        const file = event.currentTarget.files?.[0];
        if (file) take(file);
        event.currentTarget.value = '';   // the same file again is a new choice
      }} />
    </div>
  );
}
