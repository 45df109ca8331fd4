// SPDX-License-Identifier: Apache-2.0
// Every page and its path; links among pages are plain paths.
import type { Page } from '../router';
import { AuditPage } from './audit';
import { AxisPage } from './axis';
import { CalibrationPage } from './calibration';
import { CalibrationsPage } from './calibrations';
import { CapturePage } from './capture';
import { NewCapturePage } from './capture_new';
import { CapturesPage } from './captures';
import { CompensationPage } from './compensation';
import { CompensationsPage } from './compensations';
import { ComparePage } from './compare';
import { InstrumentPage } from './instrument';
import { InstrumentsPage } from './instruments';
import { MachinePage } from './machine';
import { MachinesPage } from './machines';
import { MotionsPage } from './motions';
import { PlanPage } from './plan';
import { PlansPage } from './plans';
import { ReportPage } from './report';
import { RulesPage } from './rules';
import { SettingsPage } from './settings';
import { TablePage } from './table';
import { TablesPage } from './tables';
import { OneTestPage } from './test';
import { TestsPage } from './tests';
import { TrackingPage } from './tracking';
import { VolumePage } from './volume';

export const routes: readonly (readonly [string, Page])[] = [
  ['/', TestsPage],
  ['/machines', MachinesPage],
  ['/machines/:id', MachinePage],
  ['/axes/:id', AxisPage],
  ['/instruments', InstrumentsPage],
  ['/instruments/:id', InstrumentPage],
  ['/settings', SettingsPage],
  ['/audit', AuditPage],
  ['/tests/:id/report', ReportPage],
  ['/calibrations', CalibrationsPage],
  ['/calibrations/:id', CalibrationPage],
  ['/compensations', CompensationsPage],
  ['/compensations/:id', CompensationPage],
  ['/tables', TablesPage],
  ['/tests/:id/table', TablePage],
  ['/tests/:id/rules', RulesPage],
  ['/tracking', TrackingPage],
  ['/volume', VolumePage],
  ['/motions', MotionsPage],
  ['/plans', PlansPage],
  ['/plans/new', PlanPage],
  ['/plans/:id', PlanPage],
  ['/tests/:id', OneTestPage],
  ['/compare', ComparePage],
  ['/captures', CapturesPage],
  ['/captures/new', NewCapturePage],
  ['/captures/:id', CapturePage],
];
