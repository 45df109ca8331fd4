// SPDX-License-Identifier: Apache-2.0
// What forms need of the member "model" of a result: the server has looked at the rest.
import type { VolumetricModel } from '../../api/types';

interface ModelParts {
  machine?: { tools_mm?: Record<string, unknown> };
  observed_mm?: Record<string, [number, number]>;
}

/** Names of the tools, and where the middle of the travel is that was observed. */
export function machine_of(model: VolumetricModel): { tools: string[]; middle: number[] } {
  const { machine, observed_mm } = model as ModelParts;
  return {
    tools: Object.keys(machine?.tools_mm ?? {}),
    middle: ['X', 'Y', 'Z'].map((axis) => { const [low, high] = observed_mm?.[axis] ?? [0, 0]; return (low + high) / 2; }),
  };
}
