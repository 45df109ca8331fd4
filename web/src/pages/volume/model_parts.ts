// SPDX-License-Identifier: Apache-2.0
// What forms need of the member "model" of a result: the server has looked at the rest.
import type { VolumetricAssembly, VolumetricModel, VolumetricResult } from '../../api/types';

/** A model with what speaks against it: of lengths, or of errors that were measured one by one, whose remarks belong to it. */
export type Modelled = Pick<VolumetricResult, 'model' | 'findings'> & Partial<Pick<VolumetricAssembly, 'remarks'>>;

export const is_assembly = (result: VolumetricResult | VolumetricAssembly): result is VolumetricAssembly => 'curves' in result;

/** As bodies of requests have it. */
export const given_model = ({ model, findings, remarks }: Modelled) => ({ model, findings, ...(remarks ? { remarks } : {}) });

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
