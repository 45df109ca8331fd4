// SPDX-License-Identifier: Apache-2.0
// Every page and its path; links among pages are plain paths.
import type { Page } from '../router';
import { ComparePage } from './compare';
import { OneTestPage } from './test';
import { PlanPage } from './plan';
import { PlansPage } from './plans';
import { TestsPage } from './tests';

export const routes: readonly (readonly [string, Page])[] = [
  ['/', TestsPage],
  ['/tests/:id', OneTestPage],
  ['/compare', ComparePage],
  ['/plans', PlansPage],
  ['/plans/new', PlanPage],
  ['/plans/:id', PlanPage],
];
