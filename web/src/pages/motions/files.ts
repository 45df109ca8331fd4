// SPDX-License-Identifier: Apache-2.0
// Files of readings, and plans that such readings were taken after.

export interface MotionFile { file: File; is_plan: boolean }

/** A plan is an object of JSON; tables never begin like that. */
export async function looked_at(file: File): Promise<MotionFile> {
  const head = await file.slice(0, 256).text();
  return { file, is_plan: head.trimStart().startsWith('{') };
}

/** Those of one sort, in the order in which they came. */
export const files_of = (files: readonly MotionFile[], is_plan: boolean): File[] => files.filter((one) => one.is_plan === is_plan).map(({ file }) => file);

/** Files under what they are for: readings, readings-2, plan, plan-2. */
export function roles(files: readonly MotionFile[]): Record<string, File> {
  const named = (role: string, list: readonly File[]) => list.map((file, k) => [k === 0 ? role : `${role}-${k + 1}`, file] as const);
  return Object.fromEntries([...named('readings', files_of(files, false)), ...named('plan', files_of(files, true))]);
}
