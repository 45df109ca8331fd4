// SPDX-License-Identifier: Apache-2.0
// Every page and its path; links among pages are plain paths.
import type { Page } from '../router';
import { CapturePage } from './capture';
import { NewCapturePage } from './capture_new';
import { CapturesPage } from './captures';
import { PlanPage } from './plan';
import { PlansPage } from './plans';
import { OneTestPage } from './test';
import { ReportPage } from './report';
import { TestsPage } from './tests';

export const routes: readonly (readonly [string, Page])[] = [
  ['/', TestsPage],
  ['/tests/:id/report', ReportPage],
  ['/plans', PlansPage],
  ['/plans/new', PlanPage],
  ['/plans/:id', PlanPage],
  ['/tests/:id', OneTestPage],
  ['/captures', CapturesPage],
  ['/captures/new', NewCapturePage],
  ['/captures/:id', CapturePage],
];
