// SPDX-License-Identifier: Apache-2.0
import { texts } from '../../i18n/texts';

export const t = texts({
  report: 'Report',
  to_test: 'To the test',
  version: 'Version',
  not_latest: 'the latest is {n}',
  print: 'Open to print',
  appearance: 'Appearance',
  language: 'Language',
  decimal: 'Decimal sign',
  point: 'point: 9.6',
  comma: 'comma: 9,6',
  unit: 'Unit of the parameters',
  download: 'Download',
  as_json: 'Results for programs',
  raw: 'The file as it came',
  preview: 'Preview of the report',
  issued: 'Issued reports',
  issue_what: 'Issuing keeps the report of this version as it is, for good.',
  issue: 'Issue',
  issuing: 'Issuing …',
  format: 'Format',
  none_issued: 'None has been issued.',
  now_issued: 'Issued: {name}',
  read_only: 'The store can only be read.',
});

export const units = texts({
  um: 'µm',
  mm: 'mm',
  nm: 'nm',
  arcsec: 'arc seconds ″',
  deg: 'degrees °',
});
