// SPDX-License-Identifier: Apache-2.0
import { texts } from '../../i18n/texts';

export const t = texts({
  report: ['Report', 'Bericht'],
  to_test: ['To the test', 'Zur Prüfung'],
  version: ['Version', 'Version'],
  not_latest: ['the latest is {n}', 'die neueste ist {n}'],
  print: ['Open to print', 'Zum Drucken öffnen'],
  appearance: ['Appearance', 'Darstellung'],
  language: ['Language', 'Sprache'],
  decimal: ['Decimal sign', 'Dezimalzeichen'],
  point: ['point: 9.6', 'Punkt: 9.6'],
  comma: ['comma: 9,6', 'Komma: 9,6'],
  unit: ['Unit of the parameters', 'Einheit der Kennwerte'],
  download: ['Download', 'Herunterladen'],
  as_json: ['Results for programs', 'Ergebnisse für Programme'],
  raw: ['The file as it came', 'Die Datei, wie sie kam'],
  preview: ['Preview of the report', 'Vorschau des Berichts'],
  issued: ['Issued reports', 'Ausgestellte Berichte'],
  issue_what: ['Issuing keeps the report of this version as it is, for good.', 'Ausstellen bewahrt den Bericht dieser Version unverändert und dauerhaft auf.'],
  issue: ['Issue', 'Ausstellen'],
  issuing: ['Issuing …', 'Wird ausgestellt …'],
  format: ['Format', 'Format'],
  none_issued: ['None has been issued.', 'Noch keiner ausgestellt.'],
  now_issued: ['Issued: {name}', 'Ausgestellt: {name}'],
  read_only: ['The store can only be read.', 'Das Archiv ist nur lesbar.'],
});

export const units = texts({
  um: ['µm', 'µm'],
  mm: ['mm', 'mm'],
  nm: ['nm', 'nm'],
  arcsec: ['arc seconds ″', 'Winkelsekunden ″'],
  deg: ['degrees °', 'Grad °'],
});
