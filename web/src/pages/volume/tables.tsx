// SPDX-License-Identifier: Apache-2.0
// Tables by which controls compensate, with what they say of themselves.
import { useEffect, useMemo, useState } from 'preact/hooks';
import { offer } from '../../api/client';
import { as_text, use_posted } from '../../api/posted';
import type { Vocabulary } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { Markdown } from '../../components/markdown';
import { given_model, machine_of, type Modelled } from './model_parts';
import { t } from './result_texts';

export function TablePanel({ result }: { result: Modelled }) {
  const { model } = result;
  const vocabulary = use_get<Vocabulary>('/api/vocabulary');
  const all = vocabulary.data?.compensations ?? [];
  const { tools } = useMemo(() => machine_of(model), [model]);
  const [table, set_table] = useState('');
  const [tool, set_tool] = useState('');
  const [nodes, set_nodes] = useState('21');
  useEffect(() => { if (table === '' && all[0]) set_table(all[0].id); }, [all]);
  const chosen = all.find(({ id }) => id === table);
  const chosen_tool = tools.includes(tool) ? tool : (tools[0] ?? '');
  const n = /^\d+$/.test(nodes.trim()) ? Number(nodes) : 0;
  const fault = n >= 2 && n <= 401 ? null : t('wanted_whole', { text: nodes.trim() });
  const body = useMemo(() => (chosen && fault === null ? { ...given_model(result), table: chosen.id, nodes: n, ...(chosen.of_one_tool ? { tool: chosen_tool } : {}) } : null),
    [result, chosen, n, fault, chosen_tool]);
  const made = use_posted('/api/volumetric/table', body, as_text);
  const text = made.is_current ? made.data : null;
  const head = (text ?? '').split('\n').filter((line) => /^([#(;]|\/\/)/.test(line)).join('\n');
  return (
    <section class="panel" aria-labelledby="volume-tables">
      <header>
        <h2 id="volume-tables">{t('tables')}</h2>
        <div class="row no-print">
          <button type="button" disabled={text === null} onClick={() => offer(new Blob([text ?? ''], { type: 'text/csv' }), `${table}${chosen?.of_one_tool ? `-${chosen_tool}` : ''}.csv`)}>{t('save')}</button>
        </div>
      </header>
      <p class="quiet">{t('tables_how')}</p>
      <div class="field-controls no-print">
        <Field label={t('which_table')}>
          {(ids) => <select {...ids} value={table} onChange={(event) => set_table(event.currentTarget.value)}>{all.map(({ id, title }) => <option key={id} value={id}>{title}</option>)}</select>}
        </Field>
        {chosen?.of_one_tool && tools.length > 1 && (
          <Field label={t('tool')}>
            {(ids) => <select {...ids} value={chosen_tool} onChange={(event) => set_tool(event.currentTarget.value)}>{tools.map((name) => <option key={name} value={name}>{name}</option>)}</select>}
          </Field>
        )}
        <Field label={t('nodes')} fault={fault}>
          {(ids) => <input {...ids} class="number short" inputMode="numeric" autocomplete="off" value={nodes} onInput={(event) => set_nodes(event.currentTarget.value)} />}
        </Field>
      </div>
      {made.error && <FailureNotice error={made.error} retry={made.again} />}
      {head !== '' && (
        <>
          <h3>{t('file_head')}</h3>
          <pre class="table-head" lang="en" tabIndex={0} role="region" aria-label={t('file_head')}>{head}</pre>
        </>
      )}
      {chosen && (
        <details class="no-print">
          <summary>{t('more_about')}</summary>
          <div class="manual" lang="en"><Markdown source={chosen.manual} /></div>
        </details>
      )}
    </section>
  );
}
