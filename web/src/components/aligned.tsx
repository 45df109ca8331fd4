// SPDX-License-Identifier: Apache-2.0
import { decimals_of } from '../numbers';

/** A number that ends in the room of the decimals it does not have, so that decimal marks of a column stand under each other. */
export function Aligned({ text, decimals }: { text: string; decimals: number }) {
  const lacking = decimals - decimals_of(text);
  if (lacking <= 0) return <>{text}</>;
  return <>{text}<span class="room" aria-hidden="true">{decimals_of(text) === 0 ? '.' : ''}{'0'.repeat(lacking)}</span></>;
}

/** Of the number that has most. */
export const most_decimals = (texts: readonly (string | null | undefined)[]): number =>
  Math.max(0, ...texts.map((text) => decimals_of(text ?? '')));
