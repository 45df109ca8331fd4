// SPDX-License-Identifier: Apache-2.0
// Import profiles: what one is refused for, and what a test read after one tells.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase profile_rows[] = {
    {"all ↑", "alle ↑"},
    {"all ↓", "alle ↓"},
    {"columns were read after the import profile {0=}, SHA-256 {1=}",
     "Spalten nach dem Importprofil {0} gelesen, SHA-256 {1}"},
    {"columns were read as stated with the file: targets in {0#}, readings in {1#}, direction of approach {2}, "
     "readings as they stand",
     "Spalten gelesen wie mit der Datei angegeben: Zielpositionen in {0}, Messwerte in {1}, Anfahrrichtung {2}, "
     "Messwerte wie sie stehen"},
    {"columns were read as stated with the file: targets in {0#}, readings in {1#}, direction of approach {2}, "
     "readings of the other sign",
     "Spalten gelesen wie mit der Datei angegeben: Zielpositionen in {0}, Messwerte in {1}, Anfahrrichtung {2}, "
     "Messwerte mit umgekehrtem Vorzeichen"},
    {"found a column of the role label, expected it in a transposed table only",
     "Spalte mit Beschriftungen; erwartet: nur in einer Tabelle mit einer Zeile je Durchlauf"},
    {"found a reading without a direction in its column's name or row's label, expected one",
     "Messwert, dessen Spalte oder Zeile keine Richtung nennt; erwartet: eine Richtung"},
    {"found a reading without a number of its run, expected one",
     "Messwert ohne Nummer des Durchlaufs; erwartet: eine Nummer"},
    {"found a reading without a run, expected one to tell its direction by",
     "Messwert ohne Durchlauf; erwartet: ein Durchlauf, aus dem die Richtung folgt"},
    {"found a transposed table whose readings are not its last column, expected one that stands for all",
     "Tabelle mit einer Zeile je Durchlauf, deren Messwerte nicht in der letzten Spalte stehen; erwartet: eine Spalte, "
     "die für alle steht"},
    {"found a transposed table without its targets in the header, expected them there",
     "Tabelle mit einer Zeile je Durchlauf ohne Zielpositionen in der Kopfzeile; erwartet: dort"},
    {"found an import profile beside {0#} files, expected one file",
     "ein Importprofil neben {0} Dateien; erwartet: eine Datei"},
    {"found an import profile of {0#} bytes, expected at most {1#}",
     "Importprofil von {0} Bytes; erwartet: höchstens {1}"},
    {"found columns of deviations and of positions, expected one of the two; the others are to be ignored",
     "Spalten mit Abweichungen und Spalten mit Positionen; erwartet: nur eine der beiden Arten, die andere unbeachtet"},
    {"found direction by column in the profile, expected a column of the role direction",
     "Richtung nach einer Spalte, aber keine Spalte mit der Richtung; erwartet: eine solche Spalte"},
    {"found direction by motion in a transposed table, expected another rule: its rows hold whole runs",
     "Richtung nach der Reihenfolge der Zeilen, aber jede Zeile ist ein ganzer Durchlauf; erwartet: eine andere Regel"},
    {"found fewer than 2 targets across, expected more",
     "weniger als 2 Zielpositionen in der Kopfzeile; erwartet: mehr"},
    {"found no \"format\": {0=}, expected an import profile", "kein \"format\": {0}; erwartet: ein Importprofil"},
    {"found no column of deviations or positions, expected one",
     "keine Spalte mit Abweichungen oder gemessenen Positionen; erwartet: eine"},
    {"found no column of the role target, expected one", "keine Spalte mit Zielpositionen; erwartet: eine"},
    {"found no columns in the profile, expected the roles of the columns",
     "keine Angabe zu den Spalten; erwartet: was in jeder steht"},
    {"found no direction in the profile, expected where the direction of approach comes from",
     "keine Angabe zur Anfahrrichtung; erwartet: woraus sie folgt"},
    {"found no line of targets, expected it above the rows",
     "keine Zeile mit Zielpositionen; erwartet: über den Messwerten"},
    {"found no line with the columns {0=}, expected one as the profile says",
     "keine Zeile mit den Spalten {0}; erwartet: eine wie im Importprofil"},
    {"found no reading_unit in the profile, expected the unit of the readings",
     "keine Einheit der Messwerte; erwartet: eine"},
    {"found no target_unit in the profile, expected the unit of the targets",
     "keine Einheit der Zielpositionen; erwartet: eine"},
    {"found run {0#} among {1#} readings, expected consecutive run numbers",
     "Durchlauf {0} bei {1} Messwerten; erwartet: fortlaufende Nummern der Durchläufe"},
    {"found runs by column in the profile, expected a column of the role run",
     "Durchläufe nach einer Spalte, aber keine Spalte mit dem Durchlauf; erwartet: eine solche Spalte"},
    {"found targets in another order than sweeps along the axis, expected a rule for the direction other than motion",
     "Zielpositionen nicht in der Reihenfolge von Fahrten entlang der Achse; erwartet: eine andere Regel für die "
     "Richtung als die Reihenfolge der Zeilen"},
    {"found {0#} columns of the role {1=}, expected one", "{0} Spalten der Bedeutung {1}; erwartet: eine"},
    {"found {0=}, expected a direction: up, down, ↑, ↓, +, -, forward, backward, reverse, positive or negative, or "
     "up_words and down_words of the profile",
     "{0} gefunden; erwartet: eine Richtung: up, down, ↑, ↓, +, -, forward, backward, reverse, positive oder negative, "
     "oder die angegebenen Wörter für ↑ und ↓"},
    {"found {0=}, expected seconds or a time such as 12:30:05",
     "{0} gefunden; erwartet: Sekunden oder eine Uhrzeit wie 12:30:05"},
    {"from a column", "aus einer Spalte"},
    {"from the motion", "aus der Bewegung"},
    {"from the names", "aus den Namen"},
    {"in turn at each target", "an jeder Zielposition im Wechsel"},
    {"in turn from run to run", "von Durchlauf zu Durchlauf im Wechsel"},
};

}  // namespace

const std::span<const Phrase> german_profile{profile_rows};

}  // namespace axiometry::language
