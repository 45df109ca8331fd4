// SPDX-License-Identifier: Apache-2.0
import { useMemo } from 'preact/hooks';
import './listing.css';

/** How many lines a text has; what ends the last one begins none. */
export const line_count = (text: string): number => text.replace(/\r?\n$/, '').split('\n').length;

/** A program or a table as the control gets it, its lines counted. */
export function Listing({ text, label, stale = false }: { text: string; label: string; stale?: boolean }) {
  const numbers = useMemo(() => Array.from({ length: line_count(text) }, (_, i) => i + 1).join('\n'), [text]);
  return (
    <div class={`listing${stale ? ' stale' : ''}`} role="region" aria-label={label} tabIndex={0}>
      <pre aria-hidden="true">{numbers}</pre>
      <pre>{text}</pre>
    </div>
  );
}
