// SPDX-License-Identifier: Apache-2.0
// Every page and its path; links among pages are plain paths.
import { lazy_page } from '../lazy_page';
import type { Page } from '../router';

const plan_page = lazy_page(() => import('./plan/plan'), 'PlanPage');

export const routes: readonly (readonly [string, Page])[] = [
  ['/', lazy_page(() => import('./tests/tests'), 'TestsPage')],
  ['/machines', lazy_page(() => import('./machines/machines'), 'MachinesPage')],
  ['/machines/:id', lazy_page(() => import('./machines/machine'), 'MachinePage')],
  ['/axes/:id', lazy_page(() => import('./machines/axis'), 'AxisPage')],
  ['/instruments', lazy_page(() => import('./instruments/instruments'), 'InstrumentsPage')],
  ['/instruments/:id', lazy_page(() => import('./instruments/instrument'), 'InstrumentPage')],
  ['/settings', lazy_page(() => import('./settings/settings'), 'SettingsPage')],
  ['/audit', lazy_page(() => import('./audit'), 'AuditPage')],
  ['/tests/:id/report', lazy_page(() => import('./report/report'), 'ReportPage')],
  ['/calibrations', lazy_page(() => import('./calibrations/calibrations'), 'CalibrationsPage')],
  ['/calibrations/:id', lazy_page(() => import('./calibrations/calibration'), 'CalibrationPage')],
  ['/compensations', lazy_page(() => import('./compensations/compensations'), 'CompensationsPage')],
  ['/compensations/:id', lazy_page(() => import('./compensations/compensation'), 'CompensationPage')],
  ['/tables', lazy_page(() => import('./compensations/tables'), 'TablesPage')],
  ['/tests/:id/table', lazy_page(() => import('./compensations/table'), 'TablePage')],
  ['/tests/:id/rules', lazy_page(() => import('./rules/rules'), 'RulesPage')],
  ['/tests/:id/periodic', lazy_page(() => import('./periodic/periodic'), 'PeriodicPage')],
  ['/tracking', lazy_page(() => import('./tracking/tracking'), 'TrackingPage')],
  ['/volume', lazy_page(() => import('./volume/volume'), 'VolumePage')],
  ['/motions', lazy_page(() => import('./motions/motions'), 'MotionsPage')],
  ['/dynamic', lazy_page(() => import('./dynamic/dynamic'), 'DynamicPage')],
  ['/plans', lazy_page(() => import('./plan/plans'), 'PlansPage')],
  ['/plans/new', plan_page],
  ['/plans/:id', plan_page],
  ['/tests/:id', lazy_page(() => import('./test/test'), 'OneTestPage')],
  ['/compare', lazy_page(() => import('./compare/compare'), 'ComparePage')],
  ['/captures', lazy_page(() => import('./capture/captures'), 'CapturesPage')],
  ['/captures/new', lazy_page(() => import('./capture/capture_new'), 'NewCapturePage')],
  ['/captures/:id', lazy_page(() => import('./capture/capture'), 'CapturePage')],
];
