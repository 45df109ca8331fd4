// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState } from 'preact/hooks';
import { ApiError, as_error, made_of_files } from '../../api/client';
import type { CompensatedControl } from '../../api/types';
import { table_form } from './asked';
import { largest_table } from './existing';
import { takes } from './uses';

export interface Readers { found: readonly CompensatedControl[]; done: boolean; error: ApiError | null }

/**
 * The controls that can read a file, tried one after the other. Several may be able to, and mean opposite signs: which it
 * is of, only a person knows. null asks nothing.
 */
export function use_readers(file: File | null, controls: readonly CompensatedControl[], kind: 'linear' | 'rotary'): Readers {
  const [readers, set_readers] = useState<Readers>({ found: [], done: true, error: null });
  useEffect(() => {
    set_readers({ found: [], done: file === null, error: null });
    if (file === null || file.size > largest_table) return;
    const abort = new AbortController();
    const try_all = async () => {
      const found: CompensatedControl[] = [];
      for (const control of controls.filter((one) => takes(one, kind))) {
        try {
          await made_of_files(`/api/controls/${control.id}/table`, table_form({ kind }, file), abort.signal);
          found.push(control);
          set_readers({ found: [...found], done: false, error: null });
        } catch (error) {
          if (abort.signal.aborted) return;
          if (!(error instanceof ApiError) || error.kind !== 'bad_input') {
            set_readers({ found, done: true, error: as_error(error) });
            return;
          }
        }
      }
      set_readers({ found, done: true, error: null });
    };
    void try_all();
    return () => abort.abort();
  }, [file, controls, kind]);
  return readers;
}
