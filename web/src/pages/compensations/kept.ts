// SPDX-License-Identifier: Apache-2.0
// The control that was last chosen for a machine, in this browser.
const key = (machine: number): string => `axiometry.control.${machine}`;

export function kept_control(machine: number | null): string | null {
  try {
    return machine === null ? null : localStorage.getItem(key(machine));
  } catch {
    return null;  // a browser may forbid it
  }
}

export function keep_control(machine: number | null, id: string): void {
  try {
    if (machine !== null) localStorage.setItem(key(machine), id);
  } catch {
    // a browser may forbid it
  }
}
