// SPDX-License-Identifier: Apache-2.0
// The actions and subjects of the audit trail in words; what is not known here is shown as the archive writes it.
import { language } from '../../settings';

const nouns: Record<string, readonly [string, string]> = {
  test: ['test', 'Prüfung'], machine: ['machine', 'Maschine'], axis: ['axis', 'Achse'], instrument: ['instrument', 'Messmittel'],
  plan: ['plan', 'Prüfplan'], document: ['document', 'Dokument'], store: ['store', 'Archiv'], content: ['content', 'Inhalt'],
  report: ['report', 'Bericht'], attachment: ['attachment', 'Anlage'],
};
const verbs: Record<string, readonly [string, string]> = {
  received: ['received', 'eingegangen'], revised: ['revised', 'überarbeitet'], added: ['added', 'angelegt'], changed: ['changed', 'geändert'],
  withdrawn: ['withdrawn', 'zurückgezogen'], reinstated: ['reinstated', 'wieder aufgenommen'], issued: ['issued', 'ausgegeben'],
  attached: ['attached', 'angehängt'], kept: ['kept', 'gespeichert'], restored: ['restored', 'wiederhergestellt'], created: ['created', 'angelegt'],
  migrated: ['migrated', 'umgestellt'],
};

const said = (row: readonly [string, string] | undefined, plain: string): string => row?.[language.value === 'de' ? 1 : 0] ?? plain;

/** "test.received" as "test received". */
export function action_text(action: string): string {
  const [noun = '', verb = ''] = action.split('.');
  return `${said(nouns[noun], noun)} ${said(verbs[verb], verb)}`.trim();
}

/** "test 12" in the user's language. */
export function subject_text(subject: string): string {
  const [noun = '', ...rest] = subject.split(' ');
  return [said(nouns[noun], noun), ...rest].join(' ');
}

/** Where the page of a subject is; null where there is none. */
export function subject_path(subject: string): string | null {
  const found = /^(test|machine|axis|instrument|plan) (\d+)$/.exec(subject);
  if (!found) return null;
  const folders: Record<string, string> = { test: 'tests', machine: 'machines', axis: 'axes', instrument: 'instruments', plan: 'plans' };
  return `/${folders[found[1] as string]}/${found[2]}`;
}
