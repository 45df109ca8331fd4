// SPDX-License-Identifier: Apache-2.0

/** Where the control that had the focus is gone, the title of the page has it: keyboard and screen reader go on from there. */
export function keep_focus(): void {
  window.setTimeout(() => {
    if (document.activeElement === null || document.activeElement === document.body) document.querySelector<HTMLElement>('h1')?.focus();
  }, 50);
}
