// SPDX-License-Identifier: Apache-2.0
// Every page and its path; links among pages are plain paths.
import type { Page } from '../router';
import { AuditPage } from './audit';
import { AxisPage } from './axis';
import { InstrumentPage } from './instrument';
import { InstrumentsPage } from './instruments';
import { MachinePage } from './machine';
import { MachinesPage } from './machines';
import { SettingsPage } from './settings';
import { TestsPage } from './tests';

export const routes: readonly (readonly [string, Page])[] = [
  ['/', TestsPage],
  ['/machines', MachinesPage],
  ['/machines/:id', MachinePage],
  ['/axes/:id', AxisPage],
  ['/instruments', InstrumentsPage],
  ['/instruments/:id', InstrumentPage],
  ['/settings', SettingsPage],
  ['/audit', AuditPage],
];
