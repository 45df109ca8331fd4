// SPDX-License-Identifier: Apache-2.0
import { texts } from './i18n/texts';

export const t = texts({
  tests: ['Tests', 'Prüfungen'],
  machines: ['Machines', 'Maschinen'],
  instruments: ['Instruments', 'Messmittel'],
  plans: ['Plans', 'Prüfpläne'],
  capture: ['Capture', 'Erfassung'],
  tracking: ['Tracking', 'Tracking'],
  calibrations: ['Calibrations', 'Kalibrierungen'],
  tables: ['Tables', 'Tabellen'],
  volume: ['Volume', 'Arbeitsraum'],
  settings: ['Settings', 'Einstellungen'],
  sections: ['Sections', 'Bereiche'],
  skip: ['To the content', 'Zum Inhalt'],
  no_page: ['No such page', 'Keine solche Seite'],
  no_page_more: ['There is nothing at {path}. Perhaps the address was cut off.', 'Unter {path} gibt es nichts. Vielleicht wurde die Adresse abgeschnitten.'],
  to_tests: ['To the list of tests', 'Zur Liste der Prüfungen'],
  broken: ['This page has failed', 'Diese Seite ist ausgefallen'],
  broken_more: ['What is kept in the store is not affected. The message was: {message}', 'Was im Archiv liegt, ist nicht betroffen. Die Meldung war: {message}'],
  again: ['Load again', 'Neu laden'],
  replaced: [
    'Another program answers than the one that this page came from.',
    'Es antwortet ein anderes Programm als das, von dem diese Seite stammt.',
  ],
  lost: [
    'No connection to the program. It is tried again every two seconds; what was typed stays here.',
    'Keine Verbindung zum Programm. Es wird alle zwei Sekunden erneut versucht; Eingaben bleiben erhalten.',
  ],
  read_only: [
    'This store can be read, not written{why}. Files can be looked at and evaluated; nothing is kept.',
    'Dieses Archiv kann nur gelesen werden{why}. Dateien lassen sich ansehen und auswerten; gespeichert wird nichts.',
  ],
  store: ['Store', 'Archiv'],
  read_only_short: ['read-only', 'nur lesbar'],
  counted: ['{tests} {tests|test|tests}, {size}', '{tests} {tests|Prüfung|Prüfungen}, {size}'],
  sign_in: ['Sign in', 'Anmelden'],
  sign_in_why: [
    'This workbench listens beyond this computer and asks for its token. It was set or printed when the program was started.',
    'Diese Werkbank ist über das Netz erreichbar und verlangt ihr Zugangswort. Es wurde beim Start des Programms gesetzt oder ausgegeben.',
  ],
  token: ['Token', 'Zugangswort'],
  token_wrong: ['This token is not accepted.', 'Dieses Zugangswort wird nicht angenommen.'],
  drop: ['Drop the files to look at them', 'Dateien zum Ansehen hier ablegen'],
});
