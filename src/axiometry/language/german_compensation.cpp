// SPDX-License-Identifier: Apache-2.0
// Tables by which controls correct an axis: report, findings, refusals.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase rows[] = {
    {"A number in the file", "Eine Zahl der Datei"},
    {"A number is added to the command (forward, then reverse): a positive one moves the axis in the positive "
     "direction.",
     "Eine Zahl wird zum Sollwert addiert (vorwärts, dann rückwärts): Eine positive bewegt die Achse in positiver "
     "Richtung."},
    {"A number is where the axis really was (forward, then reverse) when the nominal position was commanded, without "
     "the "
     "table: one above the nominal moves the axis in the negative direction.",
     "Eine Zahl ist die Stelle, an der die Achse ohne Tabelle wirklich stand (vorwärts, dann rückwärts), als die "
     "Sollposition befohlen war: Eine über der Sollposition bewegt die Achse in negativer Richtung."},
    {"A prediction, not a measurement: only a re-test proves it.",
     "Eine Vorhersage, keine Messung: Erst eine Nachprüfung beweist sie."},
    {"A re-test will scatter anew: {0=} below {1#} in 95 % of re-tests, if the axis stays as it is",
     "Eine Nachprüfung streut von Neuem: {0} unter {1} in 95 % der Nachprüfungen, wenn die Achse bleibt, wie sie ist"},
    {"Added to the command", "Zum Sollwert addiert"},
    {"Added to the commanded position: a positive value moves the axis in the positive direction. The control "
     "interpolates linearly and holds the last value beyond the ends.",
     "Zur befohlenen Position addiert: Ein positiver Wert bewegt die Achse in positiver Richtung. Die Steuerung "
     "interpoliert linear und hält jenseits der Enden den letzten Wert."},
    {"Added ↑ / {0=}", "Addiert ↑ / {0}"},
    {"Added ↓ / {0=}", "Addiert ↓ / {0}"},
    {"Before / {0=}", "Vorher / {0}"},
    {"Before and predicted", "Vorher und vorhergesagt"},
    {"Compensation", "Kompensation"},
    {"Compensation of an NC axis", "Kompensation einer NC-Achse"},
    {"Compensation of axis {0=}", "Kompensation der Achse {0}"},
    {"Compensation, predicted", "Kompensation, vorhergesagt"},
    {"Control", "Steuerung"},
    {"Inferred, not seen", "Erschlossen, nicht gesehen"},
    {"Layout, sign, limits and rule: the sources of LinuxCNC (usrmotintf.cc, command.c, control.c), and its motion "
     "controller run in a test.",
     "Aufbau, Vorzeichen, Grenzen und Regel: die Quellen von LinuxCNC (usrmotintf.cc, command.c, control.c) und "
     "seine Bewegungssteuerung, in einer Prüfung gefahren."},
    {"Layout, sign, limits and rule: the sources of LinuxCNC (usrmotintf.cc, command.c, control.c), and its motion "
     "controller run in a test. The sign that its documentation tells for this type is not what the program does.",
     "Aufbau, Vorzeichen, Grenzen und Regel: die Quellen von LinuxCNC (usrmotintf.cc, command.c, control.c) und "
     "seine Bewegungssteuerung, in einer Prüfung gefahren. Das Vorzeichen, das seine Dokumentation für diesen Typ "
     "nennt, ist nicht das des Programms."},
    {"Loading", "Laden"},
    {"Mean deviations before and with the table", "Mittlere Abweichungen vorher und mit der Tabelle"},
    {"Mean deviations of every target and direction as they were measured, and as they would be with the table in the "
     "control.",
     "Mittlere Abweichungen jedes Ziels und jeder Richtung, wie sie gemessen wurden, und wie sie mit der Tabelle in "
     "der "
     "Steuerung wären."},
    {"Name it COMP_FILE in the joint's section of the INI file, with COMP_FILE_TYPE, and start LinuxCNC anew. The "
     "joint's BACKLASH does nothing then. A reversal is driven with half of the joint's limits of velocity and "
     "acceleration: leave it room in STEPGEN_MAXVEL and STEPGEN_MAXACCEL or the like. After homing nothing is "
     "added until the joint has passed a position of the table (seen on 2.9): drive it once over the whole of it.",
     "Die Datei im Abschnitt des Gelenks der INI-Datei als COMP_FILE nennen, mit COMP_FILE_TYPE, und LinuxCNC neu "
     "starten. BACKLASH des Gelenks tut dann nichts. Eine Umkehr wird mit der Hälfte der Grenzen des Gelenks für "
     "Geschwindigkeit und Beschleunigung gefahren: dafür Raum in STEPGEN_MAXVEL und STEPGEN_MAXACCEL oder "
     "dergleichen lassen. Nach dem Referenzieren wird nichts addiert, bis das Gelenk eine Position der Tabelle "
     "überfahren hat (an 2.9 gesehen): einmal über die ganze Tabelle fahren."},
    {"Predicted / {0=}", "Vorhergesagt / {0}"},
    {"Predicted: the same readings with the table in the control, as it interpolates and rounds. The table was made "
     "from "
     "these readings; what scatter did to their means it corrects too, and a re-test will show that part again.",
     "Vorhergesagt: dieselben Messwerte mit der Tabelle in der Steuerung, wie sie interpoliert und rundet. Die Tabelle "
     "stammt aus diesen Messwerten; was die Streuung an ihren Mittelwerten tat, korrigiert sie mit, und eine "
     "Nachprüfung "
     "zeigt diesen Teil wieder."},
    {"Re-test / {0=}", "Nachprüfung / {0}"},
    {"Re-test, 95 % below / {0=}", "Nachprüfung, 95 % unter / {0}"},
    {"Re-test, 95 % below: of simulated re-tests of as many runs, with the scatter of this test, in the table and in "
     "the "
     "re-test; if the axis and the set-up stay as they are.",
     "Nachprüfung, 95 % unter: von simulierten Nachprüfungen mit ebenso vielen Läufen und der Streuung dieser Prüfung, "
     "in "
     "der Tabelle und in der Nachprüfung; wenn Achse und Aufbau bleiben, wie sie sind."},
    {"Scatter alone / {0=}", "Nur Streuung / {0}"},
    {"Scatter alone: the readings without the mean of every target and direction. No table removes this.",
     "Nur Streuung: die Messwerte ohne den Mittelwert jedes Ziels und jeder Richtung. Das beseitigt keine Tabelle."},
    {"Smoothed (λ = {0#}): so the table foretells targets best that were left out of it.",
     "Geglättet (λ = {0}): So sagt die Tabelle Ziele am besten voraus, die ausgelassen wurden."},
    {"The first {0#} of {1#} positions.", "Die ersten {0} von {1} Positionen."},
    {"Verified of this format", "An diesem Format geprüft"},
    {"What the control adds", "Was die Steuerung addiert"},
    {"What the control adds to the commanded position, in both directions of approach.",
     "Was die Steuerung zur befohlenen Position addiert, in beiden Anfahrrichtungen."},
    {"before ↑", "vorher ↑"},
    {"before ↓", "vorher ↓"},
    {"neither the test nor --axis names the axis: the table is made for X",
     "weder die Prüfung noch --axis nennt die Achse: Die Tabelle ist für X gemacht"},
    {"new table ↑", "neue Tabelle ↑"},
    {"new table ↓", "neue Tabelle ↓"},
    {"re-test ↑", "Nachprüfung ↑"},
    {"re-test ↓", "Nachprüfung ↓"},
    {"table so far ↑", "bisherige Tabelle ↑"},
    {"table so far ↓", "bisherige Tabelle ↓"},
    {"the error has doubled, the re-test shows {0#} ± {1#} (k = 2) of the table: a sign mistake; take it out",
     "der Fehler hat sich verdoppelt, die Nachprüfung zeigt {0} ± {1} (k = 2) der Tabelle: ein Vorzeichenfehler; sie "
     "herausnehmen"},
    {"the re-test has fewer than three targets in common with the test: it cannot be held against the prediction",
     "die Nachprüfung hat weniger als drei Ziele mit der Prüfung gemein: Sie kann nicht an der Vorhersage gemessen "
     "werden"},
    {"the re-test shows {0#} ± {1#} (k = 2) of the table: neither what it should do, nor a sign mistake, nor a table "
     "that is not active; did the axis change, or the set-up?",
     "die Nachprüfung zeigt {0} ± {1} (k = 2) der Tabelle: weder was sie soll noch ein Vorzeichenfehler noch eine "
     "Tabelle, die nicht wirkt; hat sich die Achse geändert oder der Aufbau?"},
    {"the re-test shows {0#} ± {1#} (k = 2) of the table: too uncertain to tell whether it is active",
     "die Nachprüfung zeigt {0} ± {1} (k = 2) der Tabelle: zu unsicher, um zu sagen, ob sie wirkt"},
    {"the re-test shows {0=} of {1#} {2=}, where 95 % of re-tests would show less than {3#} {4=}: the axis, the set-up "
     "or "
     "the table is not what it was taken for",
     "die Nachprüfung zeigt {0} von {1} {2}, wo 95 % der Nachprüfungen weniger als {3} {4} zeigen würden: Die Achse, "
     "der "
     "Aufbau oder die Tabelle ist nicht, wofür sie gehalten wurde"},
    {"the reversal is corrected twice, the re-test shows {0#} of it: is a backlash of the control active beside the "
     "table?",
     "die Umkehrspanne wird zweimal korrigiert, die Nachprüfung zeigt {0} davon: Wirkt ein Umkehrspiel der Steuerung "
     "neben der Tabelle?"},
    {"the reversal is not corrected, the re-test shows {0#} of it",
     "die Umkehrspanne wird nicht korrigiert, die Nachprüfung zeigt {0} davon"},
    {"the table does what it should: the re-test shows {0#} ± {1#} (k = 2) of it",
     "die Tabelle tut, was sie soll: Die Nachprüfung zeigt {0} ± {1} (k = 2) von ihr"},
    {"the table goes from {0=} to {1=}, the targets from {2=} to {3=}: beyond its ends the control holds the last "
     "value",
     "die Tabelle reicht von {0} bis {1}, die Ziele von {2} bis {3}: Jenseits ihrer Enden hält die Steuerung den "
     "letzten "
     "Wert"},
    {"the table has one curve for both directions: the reversal error stays as it is",
     "die Tabelle hat eine Kurve für beide Richtungen: Die Umkehrspanne bleibt, wie sie ist"},
    {"the table is applied twice, the re-test shows {0#} ± {1#} (k = 2) of it: is an older one still active beside it, "
     "or was the new one added to one that holds it already?",
     "die Tabelle wirkt zweimal, die Nachprüfung zeigt {0} ± {1} (k = 2) von ihr: Wirkt eine ältere noch daneben, oder "
     "wurde die neue zu einer addiert, die sie schon enthält?"},
    {"the table is not active, the re-test shows {0#} ± {1#} (k = 2) of it: is it loaded, switched on, and the axis "
     "referenced?",
     "die Tabelle wirkt nicht, die Nachprüfung zeigt {0} ± {1} (k = 2) von ihr: Ist sie geladen, eingeschaltet und die "
     "Achse referenziert?"},
    {"the table's two directions are exchanged: the re-test shows {0#} of its reversal",
     "die beiden Richtungen der Tabelle sind vertauscht: Die Nachprüfung zeigt {0} ihrer Umkehrspanne"},
    {"{0=} from {1#} to {2#}, as predicted from the same readings",
     "{0} von {1} auf {2}, vorhergesagt aus denselben Messwerten"},
    {"{0=} of the re-test: {1#}", "{0} der Nachprüfung: {1}"},
};

}  // namespace

const std::span<const Phrase> german_compensation = rows;

}  // namespace axiometry::language
