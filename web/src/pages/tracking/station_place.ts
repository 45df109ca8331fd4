// SPDX-License-Identifier: Apache-2.0

interface Setup { station?: { position_mm: readonly number[] } | null }

/** Where the instrument stands; null of an interferometer that is aligned with each line in turn, which has no station. */
export const station_place = (setup: Setup): readonly number[] | null => setup.station?.position_mm ?? null;
