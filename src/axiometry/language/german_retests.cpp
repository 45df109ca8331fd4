// SPDX-License-Identifier: Apache-2.0
// What speaks against a test that a table is made of, and what a re-test tells of the table.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase rows[] = {
    {"found a re-test of another kind of axis", "eine Nachprüfung einer anderen Art von Achse"},
    {"found a test along a line that {0#} axes drive together (axis.line_direction), expected one of the axis that the "
     "table corrects",
     "Prüfung längs einer Linie, die {0} Achsen gemeinsam fahren (axis.line_direction); erwartet: eine der Achse, "
     "welche die Tabelle korrigiert"},
    {"found axis.line_direction that is no direction of one linear axis, expected three numbers, or none",
     "axis.line_direction ist keine Richtung einer Linearachse; erwartet: drei Zahlen oder keine"},
    {"found that the table would double the error of the axis: {0}",
     "die Tabelle würde den Fehler der Achse verdoppeln: {0}"},
    {"found the test itself as its re-test, expected one with the table active",
     "die Prüfung selbst als ihre Nachprüfung; erwartet: eine mit aktiver Tabelle"},
    {"sampling points of a compensation (axis.compensation_points)",
     "Stützpunkte einer Kompensation (axis.compensation_points)"},
    {"the error has doubled, the re-test shows {0#} ± {1#} (k = 2) of the table: a sign mistake; take it out",
     "der Fehler hat sich verdoppelt, die Nachprüfung zeigt {0} ± {1} (k = 2) der Tabelle: ein Vorzeichenfehler; sie "
     "herausnehmen"},
    {"the error has doubled, the re-test shows {0#} ± {1#} (k = 2) of the table: a sign mistake; take it out, and make "
     "it with the sign that this control has: --turned-sign, or without it",
     "der Fehler hat sich verdoppelt, die Nachprüfung zeigt {0} ± {1} (k = 2) der Tabelle: ein Vorzeichenfehler; sie "
     "herausnehmen und mit dem Vorzeichen machen, das diese Steuerung hat: --turned-sign, oder ohne"},
    {"the re-test has fewer than three targets in common with the test: it cannot be held against the prediction",
     "die Nachprüfung hat weniger als drei Ziele mit der Prüfung gemein: Sie kann nicht an der Vorhersage gemessen "
     "werden"},
    {"the re-test is of {0=}, the test of {1=}: no table that was made of the test can have been active",
     "die Nachprüfung ist vom {0}, die Prüfung vom {1}: Keine Tabelle, die aus der Prüfung gemacht ist, kann aktiv "
     "gewesen sein"},
    {"the re-test names the axis {0=}, the test {1=}: it proves nothing of this table",
     "die Nachprüfung nennt die Achse {0}, die Prüfung {1}: Sie beweist nichts über diese Tabelle"},
    {"the re-test names the machine {0=}, the test {1=}: it proves nothing of this table",
     "die Nachprüfung nennt die Maschine {0}, die Prüfung {1}: Sie beweist nichts über diese Tabelle"},
    {"the re-test names the serial number {0=}, the test {1=}: it proves nothing of this table",
     "die Nachprüfung nennt die Seriennummer {0}, die Prüfung {1}: Sie beweist nichts über diese Tabelle"},
    {"the re-test shows what is not of the axis: {0}", "die Nachprüfung zeigt, was nicht von der Achse kommt: {0}"},
    {"the re-test shows {0#} ± {1#} (k = 2) of the table: neither what it should do, nor a sign mistake, nor a table "
     "that is not active; did the axis change, or the set-up?",
     "die Nachprüfung zeigt {0} ± {1} (k = 2) der Tabelle: weder was sie soll noch ein Vorzeichenfehler noch eine "
     "Tabelle, die nicht wirkt; hat sich die Achse geändert oder der Aufbau?"},
    {"the re-test shows {0#} ± {1#} (k = 2) of the table: too uncertain to tell whether it is active",
     "die Nachprüfung zeigt {0} ± {1} (k = 2) der Tabelle: zu unsicher, um zu sagen, ob sie wirkt"},
    {"the re-test shows {0=} of {1#} {2=}, where 95 % of re-tests would show less than {3#} {4=}: the axis, the "
     "set-up or the table is not what it was taken for",
     "die Nachprüfung zeigt {0} von {1} {2}, wo 95 % der Nachprüfungen weniger als {3} {4} zeigen würden: Die Achse, "
     "der Aufbau oder die Tabelle ist nicht, wofür sie gehalten wurde"},
    {"the re-test was linked in version {0#} of test {1#}, and its latest version {2#} differs in metadata, options or "
     "axis: what was found with it does not count until it is linked again",
     "die Nachprüfung ist in Version {0} der Prüfung {1} verknüpft, deren neueste Version {2} sich in Metadaten, "
     "Optionen oder Achse unterscheidet: Was mit ihr gefunden wurde, zählt nicht, bis sie neu verknüpft ist"},
    {"the reversal is corrected twice, the re-test shows {0#} of it: is a backlash of the control active beside the "
     "table?",
     "die Umkehrspanne wird zweimal korrigiert, die Nachprüfung zeigt {0} davon: Wirkt ein Umkehrspiel der Steuerung "
     "neben der Tabelle?"},
    {"the reversal is not corrected, the re-test shows {0#} of it",
     "die Umkehrspanne wird nicht korrigiert, die Nachprüfung zeigt {0} davon"},
    {"the table corrects what is not of the axis: {0}", "die Tabelle korrigiert, was nicht von der Achse kommt: {0}"},
    {"the table does what it should: the re-test shows {0#} ± {1#} (k = 2) of it",
     "die Tabelle tut, was sie soll: Die Nachprüfung zeigt {0} ± {1} (k = 2) von ihr"},
    {"the table is applied twice, the re-test shows {0#} ± {1#} (k = 2) of it: is an older one still active beside "
     "it, or was the new one added to one that holds it already?",
     "die Tabelle wirkt zweimal, die Nachprüfung zeigt {0} ± {1} (k = 2) von ihr: Wirkt eine ältere noch daneben, "
     "oder wurde die neue zu einer addiert, die sie schon enthält?"},
    {"the table is not active, the re-test shows {0#} ± {1#} (k = 2) of it: is it loaded, switched on, and the axis "
     "referenced?",
     "die Tabelle wirkt nicht, die Nachprüfung zeigt {0} ± {1} (k = 2) von ihr: Ist sie geladen, eingeschaltet und "
     "die Achse referenziert?"},
    {"the table's two directions are exchanged: the re-test shows {0#} of its reversal",
     "die beiden Richtungen der Tabelle sind vertauscht: Die Nachprüfung zeigt {0} ihrer Umkehrspanne"},
    {"the test states {0=} as axis.compensation, and nobody gives a table that was active (--existing): where there "
     "was one, this table in its place gives up what it corrected",
     "die Prüfung gibt {0} als axis.compensation an, und niemand nennt eine Tabelle, die aktiv war (--existing): gab "
     "es eine, so gibt diese Tabelle an ihrer Stelle auf, was jene korrigierte"},
    {"the test states {0}, and nobody gives a table that was active (--existing): where there was one, this table in "
     "its place gives up what it corrected",
     "die Prüfung gibt {0} an, und niemand nennt eine Tabelle, die aktiv war (--existing): gab es eine, so gibt diese "
     "Tabelle an ihrer Stelle auf, was jene korrigierte"},
};

}  // namespace

const std::span<const Phrase> german_retests = rows;

}  // namespace axiometry::language
