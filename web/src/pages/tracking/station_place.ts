// SPDX-License-Identifier: Apache-2.0

interface Setup { station?: { position_mm: readonly number[] } | null }

/** Where the instrument stands. Files of an aligned interferometer have no station; the server refuses them. */
export function station_place(setup: Setup): readonly number[] {
  if (!setup.station) throw new Error('a set-up without a station');
  return setup.station.position_mm;
}
