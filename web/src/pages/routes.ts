// SPDX-License-Identifier: Apache-2.0
// Every page and its path; links among pages are plain paths.
import type { Page } from '../router';
import { OneTestPage } from './test';
import { TestsPage } from './tests';

export const routes: readonly (readonly [string, Page])[] = [
  ['/', TestsPage],
  ['/tests/:id', OneTestPage],
];
