// SPDX-License-Identifier: Apache-2.0
// Tables by which controls correct an axis: report, findings, refusals.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase compensation_rows[] = {
    {"A number in the file", "Eine Zahl der Datei"},
    {"A prediction, not a measurement: only a re-test proves it.",
     "Eine Vorhersage, keine Messung: Erst eine Nachprüfung beweist sie."},
    {"A re-test will scatter anew: {0=} below {1#} in 95 % of re-tests, if the axis stays as it is",
     "Eine Nachprüfung streut von Neuem: {0} unter {1} in 95 % der Nachprüfungen, wenn die Achse bleibt, wie sie ist"},
    {"Added to the command", "Zum Sollwert addiert"},
    {"Added to the commanded position: a positive value moves the axis in the positive direction. The control "
     "interpolates linearly and holds the last value beyond the ends.",
     "Zur befohlenen Position addiert: Ein positiver Wert bewegt die Achse in positiver Richtung. Die Steuerung "
     "interpoliert linear und hält jenseits der Enden den letzten Wert."},
    {"Added to the commanded position: a positive value moves the axis in the positive direction. The control "
     "interpolates linearly; beyond the ends it does not hold the last value.",
     "Zur befohlenen Position addiert: Ein positiver Wert bewegt die Achse in positiver Richtung. Die Steuerung "
     "interpoliert linear; jenseits der Enden hält sie den letzten Wert nicht."},
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
    {"Loading", "Laden"},
    {"Mean deviations before and with the table", "Mittlere Abweichungen vorher und mit der Tabelle"},
    {"Mean deviations of every target and direction as they were measured, and as they would be with the table in the "
     "control.",
     "Mittlere Abweichungen jedes Ziels und jeder Richtung, wie sie gemessen wurden, und wie sie mit der Tabelle in "
     "der Steuerung wären."},
    {"Notes", "Bemerkungen"},
    {"Predicted / {0=}", "Vorhergesagt / {0}"},
    {"Predicted: the same readings with the table in the control, as it interpolates and rounds. The table was made "
     "from these readings; what scatter did to their means it corrects too, and a re-test will show that part again.",
     "Vorhergesagt: dieselben Messwerte mit der Tabelle in der Steuerung, wie sie interpoliert und rundet. Die "
     "Tabelle stammt aus diesen Messwerten; was die Streuung an ihren Mittelwerten tat, korrigiert sie mit, und eine "
     "Nachprüfung zeigt diesen Teil wieder."},
    {"Re-test / {0=}", "Nachprüfung / {0}"},
    {"Re-test, 95 % below / {0=}", "Nachprüfung, 95 % unter / {0}"},
    {"Re-test, 95 % below: of simulated re-tests of as many runs, with the scatter of this test, in the table and in "
     "the re-test; if the axis and the set-up stay as they are.",
     "Nachprüfung, 95 % unter: von simulierten Nachprüfungen mit ebenso vielen Durchläufen und der Streuung dieser "
     "Prüfung, in der Tabelle und in der Nachprüfung; wenn Achse und Aufbau bleiben, wie sie sind."},
    {"Scatter alone / {0=}", "Nur Streuung / {0}"},
    {"Scatter alone: the readings without the mean of every target and direction. No table removes this.",
     "Nur Streuung: die Messwerte ohne den Mittelwert jedes Ziels und jeder Richtung. Das beseitigt keine Tabelle."},
    {"Smoothed (λ = {0#}): so the table foretells targets best that were left out of it.",
     "Geglättet (λ = {0}): So sagt die Tabelle Ziele am besten voraus, die ausgelassen wurden."},
    {"Verified of this format", "An diesem Format geprüft"},
    {"What the control adds", "Was die Steuerung addiert"},
    {"What the control adds to the commanded position, in both directions of approach.",
     "Was die Steuerung zur befohlenen Position addiert, in beiden Anfahrrichtungen."},
    {"before ↑", "vorher ↑"},
    {"before ↓", "vorher ↓"},
    {"beside the table {0=} must be what it was while the axis was measured and {1#} added: the prediction counts on "
     "it, and no control reads it from the file",
     "neben der Tabelle muss {0} sein, was es bei der Messung der Achse war, plus {1}: Die Vorhersage rechnet damit, "
     "und keine Steuerung liest es aus der Datei"},
    {"beyond {0#} to {1#} the control does not hold the last value: over the next {2#} it goes on to that of the other "
     "end",
     "jenseits von {0} bis {1} hält die Steuerung den letzten Wert nicht: Auf den nächsten {2} geht sie zu dem des "
     "anderen Endes über"},
    {"compensation", "Kompensation"},
    {"existing_unit: {0}", "existing_unit: {0}"},
    {"found a backlash beside one curve asked for of {0}, expected a curve for each direction, which it has, or "
     "both-ways",
     "ein Umkehrspiel neben einer einzigen Kurve für {0} verlangt; erwartet: eine Kurve je Richtung, die sie hat, oder "
     "both-ways"},
    {"found a backlash beside one curve asked for of {0}, expected one curve alone: no number for it is known",
     "ein Umkehrspiel neben einer einzigen Kurve für {0} verlangt; erwartet: nur eine Kurve, denn eine Zahl dafür ist "
     "nicht bekannt"},
    {"found a compensation of the archive without its table", "eine Kompensation des Archivs ohne ihre Tabelle"},
    {"found a compensation without a control, expected one", "Kompensation ohne Steuerung; erwartet: eine"},
    {"found a compensation without its table, expected one", "Kompensation ohne ihre Tabelle; erwartet: eine"},
    {"found a periodic part of an amplitude of {0#} in the readings, and targets on even steps of {1#}, above half the "
     "period of {2#}: they do not tell it from one with a period of {3#}, and if it has the shorter one the table is "
     "wrong between them; a test for periodic errors tells which",
     "ein periodischer Anteil mit einer Amplitude von {0} in den Messwerten, und Zielpositionen in gleichen Schritten "
     "von {1}, mehr als die halbe Periode von {2}: Sie unterscheiden ihn nicht von einem mit einer Periode von {3}, "
     "und wenn er die kürzere hat, ist die Tabelle zwischen ihnen falsch; welche es ist, sagt eine Prüfung auf "
     "periodische Abweichungen"},
    {"found a periodic part to leave out and no period, expected one: axis.expected_period of the test, or --period",
     "ein periodischer Anteil, der wegbleiben soll, und keine Periode; erwartet: eine: axis.expected_period der "
     "Prüfung, oder --period"},
    {"found a periodic part with a period of {0#}, of an amplitude of {1#} and {2#}, in the readings, and positions of "
     "the table or targets up to {3#} apart, above half the period: the table holds what the targets happened to meet "
     "of it, and is wrong between them; --periodic leave leaves it out",
     "ein periodischer Anteil mit einer Periode von {0} und einer Amplitude von {1} und {2} in den Messwerten, und "
     "Positionen der Tabelle oder Zielpositionen bis {3} auseinander, mehr als die halbe Periode: Die Tabelle enthält "
     "davon, was die Zielpositionen gerade trafen, und ist dazwischen falsch; --periodic leave lässt ihn weg"},
    {"found a periodic part with a period of {0#}, of an amplitude of {1#}, in the readings, and positions of the "
     "table or targets up to {2#} apart, above half the period: the table holds what the targets happened to meet of "
     "it, and is wrong between them; --periodic leave leaves it out",
     "ein periodischer Anteil mit einer Periode von {0} und einer Amplitude von {1} in den Messwerten, und Positionen "
     "der Tabelle oder Zielpositionen bis {2} auseinander, mehr als die halbe Periode: Die Tabelle enthält davon, was "
     "die Zielpositionen gerade trafen, und ist dazwischen falsch; --periodic leave lässt ihn weg"},
    {"found a re-test without its version, expected both or none",
     "Nachprüfung ohne ihre Version; erwartet: beides oder keines"},
    {"found a result of the archive that cannot be read: {0}", "ein Ergebnis des Archivs, das nicht lesbar ist: {0}"},
    {"found a revision that changes nothing, expected a re-test or notes",
     "eine Änderung, die nichts ändert; erwartet: eine Nachprüfung oder Bemerkungen"},
    {"found a step of {0#} and {1#} points from {2#} to {3#}, which would be steps of {4#}",
     "Schritt {0} und {1} Stützpunkte von {2} bis {3}, was Schritte von {4} wären"},
    {"found a step of {0#}, expected one above 0", "Schritt {0}; erwartet: einer über 0"},
    {"found a table from {0#} to {1#} and targets from {2#} to {3#}: beyond its ends this control does not hold the "
     "last value but goes on to that of the other end; expected a table over all targets (where it has positions that "
     "it does not tell: '; range LOW to HIGH' in its head)",
     "Tabelle von {0} bis {1} und Zielpositionen von {2} bis {3}: Jenseits ihrer Enden hält diese Steuerung den "
     "letzten Wert nicht, sondern geht zu dem des anderen Endes über; erwartet: eine Tabelle über alle Zielpositionen "
     "(wo sie Positionen hat, die sie nicht nennt: '; range LOW to HIGH' in ihrem Kopf)"},
    {"found a table from {0#} to {1#} where the targets go from {2#} to {3#}, which it would fit in inches: expected "
     "it in mm, as the table to make, or --existing-unit that says what it is in",
     "eine Tabelle von {0} bis {1}, wo die Zielpositionen von {2} bis {3} gehen, zu denen sie in Zoll passen würde; "
     "erwartet: sie in mm wie die neue Tabelle, oder --existing-unit, das sagt, worin sie ist"},
    {"found a table from {0#} to {1#} where the targets go from {2#} to {3#}, which it would fit in mm: expected it in "
     "inches, as the table to make, or --existing-unit that says what it is in",
     "eine Tabelle von {0} bis {1}, wo die Zielpositionen von {2} bis {3} gehen, zu denen sie in mm passen würde; "
     "erwartet: sie in Zoll wie die neue Tabelle, oder --existing-unit, das sagt, worin sie ist"},
    {"found a table from {0#} to {1#}, expected it within {2#} to {3#}, where targets were measured: nothing is "
     "extrapolated",
     "eine Tabelle von {0} bis {1}; erwartet: innerhalb von {2} bis {3}, wo Zielpositionen gemessen wurden: Nichts "
     "wird extrapoliert"},
    {"found a table from {0#} to {1#}, expected it within {2#} to {3#}, where targets {4#} were measured: nothing is "
     "extrapolated",
     "eine Tabelle von {0} bis {1}; erwartet: innerhalb von {2} bis {3}, wo Zielpositionen {4} gemessen wurden: "
     "Nichts wird extrapoliert"},
    {"found a table that moves {0=} by the position of {1=} for {2}, expected one of the axis itself: the format takes "
     "no "
     "other",
     "eine Tabelle, die {0} nach der Position von {1} bewegt, für {2}; erwartet: eine der Achse selbst, das Format "
     "nimmt "
     "keine andere"},
    {"found a unit of length for the table of a rotary axis, expected none: it is in °",
     "eine Längeneinheit für die Tabelle einer Drehachse; erwartet: keine, denn sie ist in °"},
    {"found a unit of the existing table and no such table, expected both",
     "eine Einheit der vorhandenen Tabelle und keine solche Tabelle; erwartet: beides"},
    {"found an end at {0#}, expected one above the start at {1#}", "Ende bei {0}; erwartet: über dem Anfang bei {1}"},
    {"found an outlier at {0#} run {1#}: it lies {2#} from what the other readings let expect and moves the mean "
     "there, and so the table, by {3#}; look at it before the table is used",
     "ein Ausreißer bei {0}, Durchlauf {1}: Er liegt {2} neben dem, was die anderen Messwerte erwarten lassen, und "
     "verschiebt dort den Mittelwert, und damit die Tabelle, um {3}; vor dem Verwenden der Tabelle ansehen"},
    {"found another test, control or other files for compensation {0#}, expected those that it was kept with",
     "andere Prüfung, andere Steuerung oder andere Dateien für Kompensation {0}; erwartet: die, mit denen sie "
     "behalten wurde"},
    {"found compensation {0#} in the lists already, expected it not to be",
     "Kompensation {0} steht schon in den Listen"},
    {"found compensation {0#} withdrawn already, expected it not to be", "Kompensation {0} ist schon zurückgezogen"},
    {"found compensation {0#} withdrawn, expected one that is not: reinstate it first",
     "Kompensation {0} ist zurückgezogen; erwartet: eine, die es nicht ist; erst wieder aufnehmen"},
    {"found deviations that grow by {0#} of the travel, expected less than {1#}: {2}",
     "Abweichungen, die um {0} des Verfahrwegs wachsen; erwartet: weniger als {1}: {2}"},
    {"found deviations {0#} that differ by {1#} a whole turn apart, where the axis stands at the same place: drift, "
     "or a slip of the instrument; a table of a turning axis would jump there",
     "Abweichungen {0}, die sich im Abstand einer ganzen Umdrehung um {1} unterscheiden, wo die Achse an derselben "
     "Stelle steht: Drift, oder das Messgerät ist verrutscht; die Tabelle einer umlaufenden Achse spränge dort"},
    {"found no compensation {0=}", "keine Kompensation {0}"},
    {"found no compensation {0=} in version {1#}, expected one", "keine Version {1} der Kompensation {0}"},
    {"found no compensation {0=}, expected one", "keine Kompensation {0}"},
    {"found no file {0=} of compensation {1#}", "keine Datei {0} der Kompensation {1}"},
    {"found no file, expected a table", "keine Datei; erwartet: eine Tabelle"},
    {"found no form, expected one with options", "kein Formular; erwartet: eines mit options"},
    {"found no periodic part with a period of {0#} in the readings that noise would not make in one test of a hundred: "
     "nothing was left out",
     "kein periodischer Anteil mit einer Periode von {0} in den Messwerten, den nicht Rauschen in einer von hundert "
     "Prüfungen machte: Nichts wurde weggelassen"},
    {"found no position for the table, expected at least one",
     "keine Position für die Tabelle; erwartet: mindestens eine"},
    {"found no reading {0#}: what the table does to approaches from there nobody measured, and the reversal error "
     "stays as it is",
     "kein Messwert {0}: Was die Tabelle bei Anfahrten aus dieser Richtung tut, hat niemand gemessen, und die "
     "Umkehrspanne bleibt, wie sie ist"},
    {"found no target that was approached from both sides, expected one for a backlash",
     "keine Zielposition, die von beiden Seiten angefahren wurde; erwartet: eine für ein Umkehrspiel"},
    {"found no test {0#} in version {1#}, expected one", "keine Version {1} der Prüfung {0}"},
    {"found no two positions at steps of {0#} between the targets at {1#} and {2#}",
     "keine zwei Positionen in Schritten von {0} zwischen den Zielpositionen bei {1} und {2}"},
    {"found options of a measured test (periodic, period, existing_unit), expected none: the 21 errors have no such "
     "part",
     "Optionen einer gemessenen Prüfung (periodic, period, existing_unit); erwartet: keine, denn die 21 Abweichungen "
     "haben keinen solchen Anteil"},
    {"found options of the archive that cannot be read", "Optionen des Archivs, die nicht lesbar sind"},
    {"found positions from {0#} to {1#}, every {2#}, and targets round a turn: beyond its ends this control does not "
     "hold the last value but goes on to that of the other end; expected steps that divide a turn, or positions over "
     "all targets",
     "Positionen von {0} bis {1}, alle {2}, und Zielpositionen rund um eine Umdrehung: Jenseits ihrer Enden hält diese "
     "Steuerung den letzten Wert nicht, sondern geht zu dem des anderen Endes über; erwartet: Schritte, die eine "
     "Umdrehung teilen, oder Positionen über alle Zielpositionen"},
    {"found positions of the table that do not ascend", "Positionen der Tabelle, die nicht aufsteigen"},
    {"found readings of the negative direction alone, expected both for a table of each direction",
     "Messwerte nur der negativen Richtung; erwartet: beide für eine Tabelle je Richtung"},
    {"found readings of the negative direction alone, expected both for a table with a backlash",
     "Messwerte nur der negativen Richtung; erwartet: beide für eine Tabelle mit Umkehrspiel"},
    {"found readings of the positive direction alone, expected both for a table of each direction",
     "Messwerte nur der positiven Richtung; erwartet: beide für eine Tabelle je Richtung"},
    {"found readings of the positive direction alone, expected both for a table with a backlash",
     "Messwerte nur der positiven Richtung; erwartet: beide für eine Tabelle mit Umkehrspiel"},
    {"found readings that drift by {0#} from the first run to the last: the table corrects the axis as it was on the "
     "average of the test",
     "Messwerte, die vom ersten bis zum letzten Durchlauf um {0} driften: Die Tabelle korrigiert die Achse, wie sie "
     "im Mittel der Prüfung war"},
    {"found smoothing asked for with interpolation, which has none; expected it with least-squares",
     "Glättung zusammen mit Interpolation, die keine hat; erwartet: mit least-squares"},
    {"found steps of {0#} that do not lead from {1#} to {2#}, expected a whole number of them",
     "Schritte von {0}, die nicht von {1} bis {2} führen; erwartet: eine ganze Zahl davon"},
    {"found targets over all of a turn but its last {0#}: there the table holds its last value, and jumps where the "
     "turn begins anew; measure 360° too",
     "Zielpositionen über eine ganze Umdrehung bis auf ihre letzten {0}: Dort hält die Tabelle ihren letzten Wert und "
     "springt, wo die Umdrehung neu beginnt; auch 360° messen"},
    {"found test {0#} as its own re-test, expected one with the table active",
     "Prüfung {0} als ihre eigene Nachprüfung; erwartet: eine mit wirkender Tabelle"},
    {"found test {0#} of another axis, expected one of the axis that the table corrects",
     "Prüfung {0} einer anderen Achse; erwartet: eine der Achse, die die Tabelle korrigiert"},
    {"found test {0#} withdrawn, expected one that is not: reinstate it first",
     "Prüfung {0} ist zurückgezogen; erwartet: eine, die es nicht ist: sie zuerst wieder aufnehmen"},
    {"found that a re-test would show E of {0#} (median) where the axis has {1#}: the deviations are what scatter "
     "makes of them, and a table of scatter makes the axis worse; no table is written",
     "eine Nachprüfung würde E von {0} (Median) zeigen, wo die Achse {1} hat: Die Abweichungen sind, was die Streuung "
     "aus ihnen macht, und eine Tabelle der Streuung macht die Achse schlechter; keine Tabelle wird geschrieben"},
    {"found that axiometry {0=} would make another table than compensation {1#}, made by {2=}; expected the same: "
     "make a new one of test {3#}",
     "axiometry {0} würde eine andere Tabelle als Kompensation {1} erzeugen, die {2} erzeugt hat; erwartet: dieselbe: "
     "eine neue aus Prüfung {3} erzeugen"},
    {"found that the axis would not become better by this table: E from {0#} to {1#}, mean deviations (r.m.s.) "
     "from {2#} to {3#}; no table is written",
     "die Achse würde durch diese Tabelle nicht besser: E von {0} auf {1}, mittlere Abweichungen (quadratisches "
     "Mittel) von {2} auf {3}; keine Tabelle wird geschrieben"},
    {"found that the axis would not become better by this table: displacements on the line differ by {0#} with it, "
     "by "
     "{1#} without; no table is written",
     "die Achse würde durch diese Tabelle nicht besser: Verlagerungen auf der Linie unterscheiden sich mit ihr um {0}, "
     "ohne "
     "sie um {1}; keine Tabelle wird geschrieben"},
    {"found the axes {0=} and {1=} for a table that moves {2=} by the position of {3=}, expected one axis",
     "die Achsen {0} und {1} für eine Tabelle, die {2} nach der Position von {3} bewegt; erwartet: eine Achse"},
    {"found the axes {0=} and {1=} for a table that moves {2=} by the position of {3=}, expected two axes",
     "die Achsen {0} und {1} für eine Tabelle, die {2} nach der Position von {3} bewegt; erwartet: zwei Achsen"},
    {"found the existing table from {0#} to {1#}, beyond the targets from {2#} to {3#}: what it should become there "
     "nobody measured; expected --hold-ends, which changes it there as at the last target, or --start, --end, --step "
     "or --points, which give the new one other positions",
     "die vorhandene Tabelle von {0} bis {1}, jenseits der Zielpositionen von {2} bis {3}: Was dort aus ihr werden "
     "soll, hat niemand gemessen; erwartet: --hold-ends, womit sie sich dort ändert wie am letzten Ziel, oder --start, "
     "--end, --step oder --points, womit die neue andere Positionen hat"},
    {"found the largest number {0#}, expected a number from {1#} to {2#}",
     "größte Zahl {0}; erwartet: eine Zahl von {1} bis {2}"},
    {"found the magnification {0#}, expected a number from {1#} to {2#}",
     "magnification {0}; erwartet: eine Zahl von {1} bis {2}"},
    {"found the number {0#}, expected a number from {1#} to {2#}", "Nummer {0}; erwartet: eine Zahl von {1} bis {2}"},
    {"found the part {0=} in the form, expected options, notes and one file {1=}",
     "Teil {0} im Formular; erwartet: options, notes und eine Datei {1}"},
    {"found the part {0=} twice in the form, expected it once", "Teil {0} zweimal im Formular; erwartet: einmal"},
    {"found the period {0#}, expected a number from {1#} to {2#}", "Periode {0}; erwartet: eine Zahl von {1} bis {2}"},
    {"found the resolution {0#}, expected a number from {1#} to {2#}",
     "resolution {0}; erwartet: eine Zahl von {1} bis {2}"},
    {"found the step {0#}, expected a number from {1#} to {2#}", "Schritt {0}; erwartet: eine Zahl von {1} bis {2}"},
    {"found the steps per unit {0#}, expected a number from {1#} to {2#}",
     "Schritte je Einheit {0}; erwartet: eine Zahl von {1} bis {2}"},
    {"found {0#} of the {1#} positions of the table without a target between their neighbours: there it follows from "
     "the targets beside them, and what the axis does between these nobody measured",
     "{0} der {1} Positionen der Tabelle ohne eine Zielposition zwischen ihren Nachbarn: Dort folgt sie aus den "
     "Zielpositionen daneben, und was die Achse zwischen diesen tut, hat niemand gemessen"},
    {"found {0#} point, expected at least two", "{0} Stützpunkt; erwartet: mindestens zwei"},
    {"found {0#} points, expected at least two", "{0} Stützpunkte; erwartet: mindestens zwei"},
    {"found {0#} positions, expected at most {1#}", "{0} Positionen; erwartet: höchstens {1}"},
    {"found {0#} target, expected at least two", "{0} Zielposition; erwartet: mindestens zwei"},
    {"found {0#} targets, expected at least two", "{0} Zielpositionen; erwartet: mindestens zwei"},
    {"found {0} for a test of one axis, which it does not correct; expected it of the 21 errors, volumetric compensate",
     "{0} für die Prüfung einer Achse, die es nicht korrigiert; erwartet: aus den 21 Abweichungen, volumetric "
     "compensate"},
    {"hold_ends: {0}", "hold_ends: {0}"},
    {"inch: {0}", "inch: {0}"},
    {"largest: {0}", "largest: {0}"},
    {"magnification: {0}", "magnification: {0}"},
    {"method: {0}", "Verfahren: {0}"},
    {"neither the test nor --axis names the axis: the table is made for X",
     "weder die Prüfung noch --axis nennt die Achse: Die Tabelle ist für X gemacht"},
    {"new table ↑", "neue Tabelle ↑"},
    {"new table ↓", "neue Tabelle ↓"},
    {"nobody tells the steps per unit of the control (--steps-per-unit): the scale is in the file as a comment alone, "
     "and what is predicted is of the backlash",
     "niemand nennt die Schritte je Einheit der Steuerung (--steps-per-unit): Der Maßstab steht in der Datei nur als "
     "Kommentar, und die Vorhersage gilt dem Umkehrspiel allein"},
    {"number: {0}", "Nummer: {0}"},
    {"one count of the control is taken for 1 µm (--resolution), in the table that was active too: where it is another "
     "amount, all that the table does is wrong in that proportion",
     "ein Zählschritt der Steuerung gilt als 1 µm (--resolution), auch in der Tabelle, die aktiv war: Ist er ein "
     "anderer, so ist alles, was die Tabelle tut, in diesem Verhältnis falsch"},
    {"periodic: {0}", "periodic: {0}"},
    {"points: {0}", "Stützpunkte: {0}"},
    {"re-test ↑", "Nachprüfung ↑"},
    {"re-test ↓", "Nachprüfung ↓"},
    {"smooth: {0}", "smooth: {0}"},
    {"table so far ↑", "bisherige Tabelle ↑"},
    {"table so far ↓", "bisherige Tabelle ↓"},
    {"test {0#}, of which the table was made, is withdrawn: the table should not be used",
     "Prüfung {0}, aus der die Tabelle entstand, ist zurückgezogen: Die Tabelle sollte nicht verwendet werden"},
    {"the displacements on the line differ by {0#}, and each is known to ±{1#} (k = 2): the table is mostly what the "
     "readings do not tell",
     "die Verlagerungen auf der Linie unterscheiden sich um {0}, und jede ist auf ±{1} (k = 2) bekannt: Die Tabelle "
     "ist vor allem, was die Messwerte nicht sagen"},
    {"the instrument counts against the axis: turn its sign, or the axis in the test",
     "das Messgerät zählt gegen die Achse: sein Vorzeichen umkehren, oder die Achse in der Prüfung"},
    {"the instrument did not see the axis move", "das Messgerät hat die Bewegung der Achse nicht gesehen"},
    {"the line through the middle becomes better, and the volume not: 95 % of the tool point's errors lie below {0#} "
     "with "
     "this table alone, {1#} without",
     "die Linie durch die Mitte wird besser, das Volumen nicht: 95 % der Fehler des Werkzeugpunkts liegen mit dieser "
     "Tabelle "
     "allein unter {0}, ohne sie unter {1}"},
    {"the periodic part with a period of {0#}, of an amplitude of {1#} and {2#}, is not in the table: it stays, and is "
     "in what is predicted",
     "der periodische Anteil mit einer Periode von {0} und einer Amplitude von {1} und {2} ist nicht in der Tabelle: "
     "Er bleibt, und die Vorhersage enthält ihn"},
    {"the periodic part with a period of {0#}, of an amplitude of {1#}, is not in the table: it stays, and is in what "
     "is predicted",
     "der periodische Anteil mit einer Periode von {0} und einer Amplitude von {1} ist nicht in der Tabelle: Er "
     "bleibt, und die Vorhersage enthält ihn"},
    {"the re-test, test {0#}, is withdrawn: what was found with it does not count, and the table is not proved",
     "die Nachprüfung, Prüfung {0}, ist zurückgezogen: Was mit ihr gefunden wurde, zählt nicht, und die Tabelle ist "
     "nicht bewiesen"},
    {"the sign is turned against what was inferred of {0}: only a re-test tells whether this is the one of the control",
     "das Vorzeichen ist gegen das gedreht, was für {0} erschlossen wurde: Erst eine Nachprüfung sagt, ob es das der "
     "Steuerung ist"},
    {"the table goes from {0#} to {1#}, the targets from {2#} to {3#}: beyond its ends the control begins the turn "
     "anew, and what is foretold there counts on the last value",
     "die Tabelle reicht von {0} bis {1}, die Ziele von {2} bis {3}: Jenseits ihrer Enden beginnt die Steuerung die "
     "Umdrehung von neuem, und was dort vorhergesagt ist, rechnet mit dem letzten Wert"},
    {"the table goes from {0#} to {1#}, the targets from {2#} to {3#}: beyond its ends the control holds the last "
     "value",
     "die Tabelle reicht von {0} bis {1}, die Ziele von {2} bis {3}: Jenseits ihrer Enden hält die Steuerung den "
     "letzten Wert"},
    {"the table goes from {0#} to {1#}, the targets from {2#} to {3#}: over the targets beyond its ends the file holds "
     "the last value",
     "die Tabelle reicht von {0} bis {1}, die Ziele von {2} bis {3}: Über den Zielen jenseits ihrer Enden hält die "
     "Datei den letzten Wert"},
    {"the table goes from {0#} to {1#}, the targets from {2#} to {3#}: over the targets beyond its ends the file holds "
     "the last value, or goes on to that of the other end where the turn closes",
     "die Tabelle reicht von {0} bis {1}, die Ziele von {2} bis {3}: Über den Zielen jenseits ihrer Enden hält die "
     "Datei den letzten Wert oder geht, wo sich die Umdrehung schließt, zu dem des anderen Endes über"},
    {"the table goes from {0#} to {1#}, where {2#} to {3#} were measured: beyond them it holds the value of the last "
     "target, which nobody measured",
     "die Tabelle reicht von {0} bis {1}, gemessen wurde von {2} bis {3}: Jenseits davon hält sie den Wert der "
     "letzten Zielposition, was niemand gemessen hat"},
    {"the table has one curve for both directions: the reversal error stays as it is",
     "die Tabelle hat eine Kurve für beide Richtungen: Die Umkehrspanne bleibt, wie sie ist"},
    {"the table that was active goes from {0#} to {1#}, the new one from {2#} to {3#}: beyond its ends what the old "
     "one corrected is given up",
     "die Tabelle, die wirkte, geht von {0} bis {1}, die neue von {2} bis {3}: Jenseits ihrer Enden ist aufgegeben, "
     "was die alte korrigierte"},
    {"the table was made of version {0#} of test {1#}, and its latest version {2#} differs in metadata, options or "
     "axis: make the table of that one",
     "die Tabelle entstand aus Version {0} der Prüfung {1}, deren neueste Version {2} sich in Metadaten, Optionen oder "
     "Achse unterscheidet: die Tabelle aus dieser erzeugen"},
    {"the targets are in inches and the readings in mm", "die Zielpositionen sind in Zoll und die Messwerte in mm"},
    {"the targets are in mm and the readings in inches", "die Zielpositionen sind in mm und die Messwerte in Zoll"},
    {"the targets do not tell a periodic part with a period of {0#}: nothing was left out",
     "die Zielpositionen lassen einen periodischen Anteil mit einer Periode von {0} nicht erkennen: Nichts wurde "
     "weggelassen"},
    {"these are no deviations of an axis", "das sind keine Abweichungen einer Achse"},
    {"turned_sign: {0}", "turned_sign: {0}"},
    {"{0#} of {1#} positions: all are in the file for the control.",
     "{0} von {1} Positionen: Alle stehen in der Datei für die Steuerung."},
    {"{0=} from {1#} to {2#}, as predicted from the same readings",
     "{0} von {1} auf {2}, vorhergesagt aus denselben Messwerten"},
    {"{0=} of the re-test: {1#}", "{0} der Nachprüfung: {1}"},
};

}  // namespace

const std::span<const Phrase> german_compensation = compensation_rows;

}  // namespace axiometry::language
