// SPDX-License-Identifier: Apache-2.0

/** "U_DEVICE", "s_i", "U_M,MACHINE TOOL", "P_s,max": a letter, and after the underscore what stands below it. */
const indexed = /(?<![\w.])([A-Za-zα-ω]\u0304?)_([A-Za-z0-9]+(?:,(?:max|mean|[A-Z]+(?: [A-Z]{2,})*))?)/u;

/** A sentence of the program with its symbols set as they are printed. */
export function Formula({ text }: { text: string }) {
  const parts = text.split(new RegExp(indexed, 'gu'));
  return (
    <>
      {parts.map((part, i) => (i % 3 === 0 ? part : i % 3 === 1 ? <span key={i} class="symbol">{part}</span> : <sub key={i}>{part}</sub>))}
    </>
  );
}
