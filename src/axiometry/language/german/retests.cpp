// SPDX-License-Identifier: Apache-2.0
// What speaks against a test that a table is made of, and what a re-test tells of the table.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase retests_rows[] = {
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
    {"no more is left than the table lets expect; the re-test shows {0#} ± {1#} (k = 2) of it",
     "es bleibt nicht mehr, als die Tabelle erwarten lässt; die Nachprüfung zeigt {0} ± {1} (k = 2) von ihr"},
    {"sampling points of a compensation (axis.compensation_points)",
     "Stützpunkte einer Kompensation (axis.compensation_points)"},
    {"the error has doubled, the re-test shows {0#} ± {1#} (k = 2) of the table: a sign mistake, or directions "
     "exchanged or positions mirrored, which would show alike; take it out",
     "der Fehler hat sich verdoppelt, die Nachprüfung zeigt {0} ± {1} (k = 2) der Tabelle: ein Vorzeichenfehler, oder "
     "vertauschte Richtungen oder gespiegelte Positionen, die sich ebenso zeigen; sie herausnehmen"},
    {"the error has doubled, the re-test shows {0#} ± {1#} (k = 2) of the table: a sign mistake, or directions "
     "exchanged or positions mirrored, which would show alike; take it out, and make it with the sign that this "
     "control has: --turned-sign, or without it",
     "der Fehler hat sich verdoppelt, die Nachprüfung zeigt {0} ± {1} (k = 2) der Tabelle: ein Vorzeichenfehler, oder "
     "vertauschte Richtungen oder gespiegelte Positionen, die sich ebenso zeigen; sie herausnehmen und mit dem "
     "Vorzeichen erzeugen, das diese Steuerung hat: --turned-sign oder ohne"},
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
    {"the re-test shows the table but for its reversal, of which it shows {0#}: is a backlash of the control active "
     "beside it, or did the reversal change?",
     "die Nachprüfung zeigt die Tabelle bis auf deren Umkehrspanne, von der sie {0} zeigt: Wirkt daneben ein "
     "Umkehrspiel der Steuerung, oder hat sich die Umkehrspanne geändert?"},
    {"the re-test shows what is not of the axis: {0}", "die Nachprüfung zeigt, was nicht von der Achse kommt: {0}"},
    {"the re-test shows {0#} ± {1#} (k = 2) of the table, and more is left than it lets expect: did axis or set-up "
     "change?",
     "die Nachprüfung zeigt {0} ± {1} (k = 2) der Tabelle, und es bleibt mehr, als diese erwarten lässt: Haben sich "
     "Achse oder Aufbau geändert?"},
    {"the re-test shows {0#} ± {1#} (k = 2) of the table, and nothing of its reversal: no target has approaches from "
     "both sides in both tests",
     "die Nachprüfung zeigt {0} ± {1} (k = 2) der Tabelle und nichts von deren Umkehrspanne: Kein Ziel hat in beiden "
     "Prüfungen Anfahrten von beiden Seiten"},
    {"the re-test shows {0#} ± {1#} (k = 2) of the table, everywhere in proportion: is its scale another one in the "
     "control (unit, count, magnification), or did axis or set-up change?",
     "die Nachprüfung zeigt {0} ± {1} (k = 2) der Tabelle, überall im selben Verhältnis: Hat die Tabelle in der "
     "Steuerung einen anderen Maßstab (Einheit, Zähleinheit, Vergrößerung), oder haben sich Achse oder Aufbau "
     "geändert?"},
    {"the re-test shows {0#} ± {1#} (k = 2) of the table: too uncertain to tell whether it is active",
     "die Nachprüfung zeigt {0} ± {1} (k = 2) der Tabelle: zu unsicher, um zu sagen, ob sie wirkt"},
    {"the re-test shows {0#} ± {1#} (k = 2) of the table; of its reversal {2#} ± {3#} (k = 2), too uncertain to tell "
     "whether it is corrected",
     "die Nachprüfung zeigt {0} ± {1} (k = 2) der Tabelle; von deren Umkehrspanne {2} ± {3} (k = 2), zu unsicher, um "
     "zu sagen, ob sie korrigiert wird"},
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
    {"the table explains {0#} % of the change from test to re-test, which shows {1#} ± {2#} (k = 2) of it: look "
     "whether its directions are exchanged, its positions mirrored, one direction alone is active, another table is, "
     "or axis or set-up changed",
     "die Tabelle erklärt {0} % der Änderung von der Prüfung zur Nachprüfung, die sie zu {1} ± {2} (k = 2) zeigt: zu "
     "prüfen ist, ob ihre Richtungen vertauscht oder ihre Positionen gespiegelt sind, nur eine Richtung oder eine "
     "andere Tabelle aktiv ist, oder ob sich Achse oder Aufbau geändert haben"},
    {"the table is active {0#} alone: the re-test shows {1#} ± {2#} (k = 2) of it {3#} and {4#} ± {5#} (k = 2) of it "
     "{6#}",
     "die Tabelle ist nur {0} aktiv: Die Nachprüfung zeigt {1} ± {2} (k = 2) von ihr {3} und {4} ± {5} (k = 2) von ihr "
     "{6}"},
    {"the table is applied twice, the re-test shows {0#} ± {1#} (k = 2) of it: is an older one still active beside "
     "it, or was the new one added to one that holds it already?",
     "die Tabelle wirkt zweimal, die Nachprüfung zeigt {0} ± {1} (k = 2) von ihr: Wirkt eine ältere noch daneben, "
     "oder wurde die neue zu einer addiert, die sie schon enthält?"},
    {"the table is kept, and of such a test none is made any more: {0}",
     "die Tabelle ist aufbewahrt, und aus einer solchen Prüfung wird keine mehr erstellt: {0}"},
    {"the table is not active, the re-test shows {0#} ± {1#} (k = 2) of it: is it loaded, switched on, and the axis "
     "referenced?",
     "die Tabelle wirkt nicht, die Nachprüfung zeigt {0} ± {1} (k = 2) von ihr: Ist sie geladen, eingeschaltet und "
     "die Achse referenziert?"},
    {"the table's positions are mirrored, the first value at the last position: so the change from test to re-test is "
     "explained, the table itself shows {0#} ± {1#} (k = 2) in it",
     "die Positionen der Tabelle sind gespiegelt, der erste Wert steht an der letzten Position: So erklärt sich die "
     "Änderung von der Prüfung zur Nachprüfung, die Tabelle selbst zeigt sich darin zu {0} ± {1} (k = 2)"},
    {"the table's two directions are exchanged: so the change from test to re-test is explained, the table itself "
     "shows {0#} ± {1#} (k = 2) in it",
     "die beiden Richtungen der Tabelle sind vertauscht: So erklärt sich die Änderung von der Prüfung zur Nachprüfung, "
     "die Tabelle selbst zeigt sich darin zu {0} ± {1} (k = 2)"},
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

const std::span<const Phrase> german_retests = retests_rows;

}  // namespace axiometry::language
