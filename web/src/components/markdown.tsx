// SPDX-License-Identifier: Apache-2.0
// The manuals of formats and dialects: paragraphs, lists, tables, code. Built as elements, so that text stays text.
import type { ComponentChildren } from 'preact';
import './markdown.css';

function inline(text: string): ComponentChildren[] {
  return text.split(/(`[^`]+`|\*\*[^*]+\*\*)/).map((piece, i) => {
    if (piece.startsWith('`') && piece.length > 2) return <code key={i}>{piece.slice(1, -1)}</code>;
    if (piece.startsWith('**') && piece.length > 4) return <strong key={i}>{piece.slice(2, -2)}</strong>;
    return piece;
  });
}

const cells = (line: string): string[] => line.replace(/^\s*\||\|\s*$/g, '').split(/(?<!\\)\|/).map((cell) => cell.trim().replaceAll('\\|', '|'));

function Rows({ lines }: { lines: string[] }) {
  const [head = '', , ...body] = lines;
  return (
    <div class="table-frame">
      <table>
        <thead><tr>{cells(head).map((cell, i) => <th key={i} scope="col">{inline(cell)}</th>)}</tr></thead>
        <tbody>{body.map((line, i) => <tr key={i}>{cells(line).map((cell, k) => <td key={k}>{inline(cell)}</td>)}</tr>)}</tbody>
      </table>
    </div>
  );
}

type Kind = 'code' | 'table' | 'list' | 'heading' | 'text';
interface Block { kind: Kind; lines: string[] }

function kind_of(line: string): Kind {
  if (line.startsWith('|')) return 'table';
  if (/^\s*[-*] /.test(line)) return 'list';
  return /^#+ /.test(line) ? 'heading' : 'text';
}

function blocks(source: string): Block[] {
  const all: Block[] = [];
  let open: Block | null = null;
  for (const line of source.split('\n')) {
    if (open?.kind === 'code') {
      if (line.startsWith('```')) open = null;
      else open.lines.push(line);
      continue;
    }
    if (line.startsWith('```')) { open = { kind: 'code', lines: [] }; all.push(open); continue; }
    if (line.trim() === '') { open = null; continue; }
    const kind = kind_of(line);
    // An indented line goes on with the item before it.
    if (open?.kind === 'list' && kind === 'text') { open.lines.push(`${open.lines.pop()} ${line.trim()}`); continue; }
    if (open === null || open.kind !== kind || kind === 'heading') { open = { kind, lines: [] }; all.push(open); }
    open.lines.push(kind === 'list' ? line.replace(/^\s*[-*] /, '') : line);
  }
  return all;
}

export function Markdown({ source }: { source: string }) {
  return (
    <div class="manual">
      {blocks(source).map(({ kind, lines }, i) => {
        if (kind === 'code') return <pre key={i} tabIndex={0}><code>{lines.join('\n')}</code></pre>;
        if (kind === 'table') return <Rows key={i} lines={lines} />;
        if (kind === 'list') return <ul key={i}>{lines.map((line, k) => <li key={k}>{inline(line)}</li>)}</ul>;
        if (kind === 'heading') return <h4 key={i}>{inline((lines[0] ?? '').replace(/^#+ /, ''))}</h4>;
        return <p key={i}>{inline(lines.join(' '))}</p>;
      })}
    </div>
  );
}
