// SPDX-License-Identifier: Apache-2.0
// Parts of a report on a page: the same words, tables and figures, from the same source.
import type { ReportBlock, ReportCell, ReportDocument, ReportFigure, ReportNotice, ReportTable, TextRun } from '../api/types';
import { Aligned, most_decimals } from './aligned';
import './report_parts.css';

type RichText = readonly TextRun[];
export type ReportSection = ReportDocument['sections'][number];

const plain = (text: RichText): string => text.map((run) => run.text).join('');

function Run({ run }: { run: TextRun }) {
  const styled = run.italic ? <span class="symbol">{run.text}</span> : run.bold ? <strong>{run.text}</strong> : <>{run.text}</>;
  return run.script === 'sub' ? <sub>{styled}</sub> : run.script === 'super' ? <sup>{styled}</sup> : styled;
}

const Rich = ({ text }: { text: RichText }) => <>{text.map((run, i) => <Run key={i} run={run} />)}</>;

const tone_class = (tone: string): string => (tone === 'normal' ? '' : tone === 'quiet' ? 'quiet' : `${tone}-words`);

function Notice({ notice: { tone, heading, lines } }: { notice: ReportNotice }) {
  return (
    <div class={`notice ${tone === 'normal' || tone === 'quiet' ? '' : tone}`}>
      <p><strong><Rich text={heading} /></strong></p>
      {lines.map((line, i) => <p key={i} class="small"><Rich text={line} /></p>)}
    </div>
  );
}

const column_class = (column: ReportTable['columns'][number] | undefined): string =>
  (column?.align === 'decimal' ? 'number' : column?.takes_space ? 'words' : '');

function Table({ table, name }: { table: ReportTable; name: string }) {
  const { caption, groups, columns, rows, notes } = table;
  const decimals = columns.map(({ align }, c) => (align === 'decimal' ? most_decimals(rows.map((row) => plain(row[c]?.text ?? []))) : null));
  const Cell = ({ cell, c }: { cell: ReportCell; c: number }) => {
    const room = decimals[c];
    return room === null || room === undefined ? <Rich text={cell.text} /> : <Aligned text={plain(cell.text)} decimals={room} />;
  };
  const title = plain(caption) || name;
  return (
    <>
      {caption.length > 0 && <h3><Rich text={caption} /></h3>}
      <div class="table-frame" tabIndex={0} role="region" aria-label={title}>
        <table class="report-table">
          <thead>
            {groups.length > 0 && <tr>{groups.map((group, g) => <th key={g} scope="colgroup" colSpan={group.columns}><Rich text={group.head} /></th>)}</tr>}
            <tr>{columns.map((column, c) => <th key={c} scope="col" class={column_class(column)}><Rich text={column.head} /></th>)}</tr>
          </thead>
          <tbody>
            {rows.map((row, r) => (
              <tr key={r}>
                {row.map((cell, c) => (columns[c]?.names_row
                  ? <th key={c} scope="row" class={`${column_class(columns[c])} ${tone_class(cell.tone)}`}><Cell cell={cell} c={c} /></th>
                  : <td key={c} class={`${column_class(columns[c])} ${tone_class(cell.tone)}`}><Cell cell={cell} c={c} /></td>))}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      {notes.map((note, i) => <p key={i} class="small quiet"><Rich text={note} /></p>)}
    </>
  );
}

/** A drawing as the address of a picture. */
export const picture = (svg: string): string => `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`;

/** On paper the same figure in the colours of paper, where it is shown in others. */
function Figure({ figure, on_paper }: { figure: ReportFigure; on_paper: ReportFigure | null }) {
  return (
    <figure class="report-figure">
      <img class={on_paper ? 'no-print' : ''} src={picture(figure.svg)} alt={figure.description || figure.title} />
      {on_paper && <img class="only-print" src={picture(on_paper.svg)} alt={figure.description || figure.title} />}
      <figcaption class="small quiet">{figure.title}</figcaption>
    </figure>
  );
}

function Block({ block, on_paper, name }: { block: ReportBlock; on_paper: ReportBlock | null; name: string }) {
  switch (block.kind) {
    case 'table': return <Table table={block} name={name} />;
    case 'figure': return <Figure figure={block} on_paper={on_paper?.kind === 'figure' ? on_paper : null} />;
    case 'notice': return <Notice notice={block.notice} />;
    case 'paragraph': return <p class={tone_class(block.tone)}><Rich text={block.text} /></p>;
    case 'facts':
      return (
        <>
          {block.title !== '' && <h3>{block.title}</h3>}
          <dl class="report-facts">
            {block.facts.map(({ name: fact, value }, i) => (
              <div key={i}><dt><Rich text={fact} /></dt><dd class={tone_class(value.tone)}><Rich text={value.text} /></dd></div>
            ))}
          </dl>
        </>
      );
  }
}

/** What must not be overlooked. */
export const ReportStatus = ({ document }: { document: ReportDocument }) => <>{document.status.map((notice, i) => <Notice key={i} notice={notice} />)}</>;

/** A section as a panel; with `on_paper` its figures as they are printed. */
export function ReportPanel({ section, on_paper = null }: { section: ReportSection; on_paper?: ReportSection | null }) {
  return (
    <section class="panel report-panel">
      <header><h2>{section.title}</h2></header>
      <div class={section.id === 'figures' ? 'report-figures' : ''}>
        {section.blocks.map((block, i) => <Block key={i} block={block} on_paper={on_paper?.blocks[i] ?? null} name={section.title} />)}
      </div>
    </section>
  );
}
