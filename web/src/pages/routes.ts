// SPDX-License-Identifier: Apache-2.0
// Every page and its path; links among pages are plain paths.
import { lazy_page } from '../lazy_page';
import type { Page } from '../router';

const plan_page = lazy_page(() => import('./plan'), 'PlanPage');

export const routes: readonly (readonly [string, Page])[] = [
  ['/', lazy_page(() => import('./tests'), 'TestsPage')],
  ['/machines', lazy_page(() => import('./machines'), 'MachinesPage')],
  ['/machines/:id', lazy_page(() => import('./machine'), 'MachinePage')],
  ['/axes/:id', lazy_page(() => import('./axis'), 'AxisPage')],
  ['/instruments', lazy_page(() => import('./instruments'), 'InstrumentsPage')],
  ['/instruments/:id', lazy_page(() => import('./instrument'), 'InstrumentPage')],
  ['/settings', lazy_page(() => import('./settings'), 'SettingsPage')],
  ['/audit', lazy_page(() => import('./audit'), 'AuditPage')],
  ['/tests/:id/report', lazy_page(() => import('./report'), 'ReportPage')],
  ['/calibrations', lazy_page(() => import('./calibrations'), 'CalibrationsPage')],
  ['/calibrations/:id', lazy_page(() => import('./calibration'), 'CalibrationPage')],
  ['/compensations', lazy_page(() => import('./compensations'), 'CompensationsPage')],
  ['/compensations/:id', lazy_page(() => import('./compensation'), 'CompensationPage')],
  ['/tables', lazy_page(() => import('./tables'), 'TablesPage')],
  ['/tests/:id/table', lazy_page(() => import('./table'), 'TablePage')],
  ['/tests/:id/rules', lazy_page(() => import('./rules'), 'RulesPage')],
  ['/tracking', lazy_page(() => import('./tracking'), 'TrackingPage')],
  ['/volume', lazy_page(() => import('./volume'), 'VolumePage')],
  ['/motions', lazy_page(() => import('./motions'), 'MotionsPage')],
  ['/dynamic', lazy_page(() => import('./dynamic'), 'DynamicPage')],
  ['/plans', lazy_page(() => import('./plans'), 'PlansPage')],
  ['/plans/new', plan_page],
  ['/plans/:id', plan_page],
  ['/tests/:id', lazy_page(() => import('./test'), 'OneTestPage')],
  ['/compare', lazy_page(() => import('./compare'), 'ComparePage')],
  ['/captures', lazy_page(() => import('./captures'), 'CapturesPage')],
  ['/captures/new', lazy_page(() => import('./capture_new'), 'NewCapturePage')],
  ['/captures/:id', lazy_page(() => import('./capture'), 'CapturePage')],
];
