// SPDX-License-Identifier: Apache-2.0
// The actions and subjects of the audit trail in words; what is not known here is shown as the archive writes it.
import { texts } from '../../i18n/texts';

const nouns = {
  test: 'test', machine: 'machine', axis: 'axis', instrument: 'instrument',
  plan: ['plan', 'asset'], document: 'document', store: 'store', content: 'content',
  report: 'report', attachment: 'attachment', calibration: 'calibration',
  compensation: ['table', 'compensation'],
} as const;
const verbs = {
  received: ['received', 'action'], revised: ['revised', 'action'], added: ['added', 'action'],
  changed: ['changed', 'action'], withdrawn: ['withdrawn', 'action'],
  reinstated: ['reinstated', 'action'], issued: ['issued', 'action'],
  attached: ['attached', 'action'], kept: ['kept', 'action'], restored: ['restored', 'action'],
  created: ['created', 'action'], migrated: ['migrated', 'action'],
} as const;
/** What an entry tells beside its subject, by the names that the archive gives it. */
const details = {
  version: ['version', 'detail'], sha256: 'SHA-256', content: 'content', file: ['file', 'detail'],
  format: ['format', 'detail'], name_in_file: 'name within the file', size: ['bytes', 'detail'],
  name: ['name', 'detail'], test: 'test', test_version: 'version of the test',
  tests: ['tests', 'detail'], entries: ['entries', 'detail'],
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
