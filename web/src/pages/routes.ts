// SPDX-License-Identifier: Apache-2.0
// Every page and its path; links among pages are plain paths.
import type { Page } from '../router';
import { PlanPage } from './plan';
import { PlansPage } from './plans';
import { OneTestPage } from './test';
import { TestsPage } from './tests';

export const routes: readonly (readonly [string, Page])[] = [
  ['/', TestsPage],
  ['/plans', PlansPage],
  ['/plans/new', PlanPage],
  ['/plans/:id', PlanPage],
  ['/tests/:id', OneTestPage],
];
