// SPDX-License-Identifier: Apache-2.0
// The actions and subjects of the audit trail in words; what is not known here is shown as the archive writes it.
import { texts } from '../../i18n/texts';

const nouns = {
  test: ['test', 'Prüfung'], machine: ['machine', 'Maschine'], axis: ['axis', 'Achse'], instrument: ['instrument', 'Messmittel'],
  plan: ['plan', 'Prüfplan'], document: ['document', 'Dokument'], store: ['store', 'Archiv'], content: ['content', 'Inhalt'],
  report: ['report', 'Bericht'], attachment: ['attachment', 'Anlage'], calibration: ['calibration', 'Kalibrierung'],
  compensation: ['table', 'Tabelle', 'compensation'],
} as const;
const verbs = {
  received: ['received', 'eingegangen', 'action'], revised: ['revised', 'überarbeitet', 'action'], added: ['added', 'angelegt', 'action'],
  changed: ['changed', 'geändert', 'action'], withdrawn: ['withdrawn', 'zurückgezogen', 'action'],
  reinstated: ['reinstated', 'wieder aufgenommen', 'action'], issued: ['issued', 'ausgegeben', 'action'],
  attached: ['attached', 'angehängt', 'action'], kept: ['kept', 'gespeichert', 'action'], restored: ['restored', 'wiederhergestellt', 'action'],
  created: ['created', 'angelegt', 'action'], migrated: ['migrated', 'umgestellt', 'action'],
} as const;
/** What an entry tells beside its subject, by the names that the archive gives it. */
const details = {
  version: ['version', 'Version', 'detail'], sha256: ['SHA-256', 'SHA-256'], content: ['content', 'Inhalt'], file: ['file', 'Datei', 'detail'],
  format: ['format', 'Format', 'detail'], name_in_file: ['name within the file', 'Name in der Datei'], size: ['bytes', 'Bytes', 'detail'],
  name: ['name', 'Name', 'detail'], test: ['test', 'Prüfung'], test_version: ['version of the test', 'Version der Prüfung'],
  tests: ['tests', 'Prüfungen', 'detail'], entries: ['entries', 'Einträge', 'detail'],
} as const;
const detail_text = texts(details);
const noun_text = texts(nouns);
const verb_text = texts(verbs);

const noun_said = (noun: string): string => (Object.keys(nouns).includes(noun) ? noun_text(noun as keyof typeof nouns) : noun);
const verb_said = (verb: string): string => (Object.keys(verbs).includes(verb) ? verb_text(verb as keyof typeof verbs) : verb);

export const detail_name = (key: string): string => (Object.keys(details).includes(key) ? detail_text(key as keyof typeof details) : key);

/** "test.received" as "test received". */
export function action_text(action: string): string {
  const [noun = '', verb = ''] = action.split('.');
  return `${noun_said(noun)} ${verb_said(verb)}`.trim();
}

/** "test 12" in the user's language. */
export function subject_text(subject: string): string {
  const [noun = '', ...rest] = subject.split(' ');
  return [noun_said(noun), ...rest].join(' ');
}

/** Where the page of a subject is; null where there is none. */
export function subject_path(subject: string): string | null {
  const found = /^(test|machine|axis|instrument|plan|calibration|compensation) (\d+)$/.exec(subject);
  if (!found) return null;
  const folders: Record<string, string> = {
    test: 'tests', machine: 'machines', axis: 'axes', instrument: 'instruments', plan: 'plans', calibration: 'calibrations', compensation: 'compensations',
  };
  return `/${folders[found[1] as string]}/${found[2]}`;
}
