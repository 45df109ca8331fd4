// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from 'preact';
import { useId } from 'preact/hooks';

interface Props {
  label: ComponentChildren;
  hint?: ComponentChildren;
  fault?: string | null;
  children: (ids: { id: string; 'aria-describedby': string | undefined; 'aria-invalid': 'true' | undefined }) => ComponentChildren;
}

/** A label above its control, with what helps and what is wrong below, tied together for screen readers. */
export function Field({ label, hint, fault, children }: Props) {
  const id = useId();
  const below = `${id}-below`;
  return (
    <div class="field">
      <label for={id}>{label}</label>
      {children({ id, 'aria-describedby': hint || fault ? below : undefined, 'aria-invalid': fault ? 'true' : undefined })}
      {fault ? <span id={below} class="fault">{fault}</span> : hint ? <span id={below} class="hint">{hint}</span> : null}
    </div>
  );
}
