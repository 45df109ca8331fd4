// SPDX-License-Identifier: Apache-2.0
// What a capture tells while readings come in, and of a recording.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase capture_rows[] = {
    {"a continuous recording of {0#} samples gave {1#} of the {2#} lengths of the plan",
     "eine fortlaufende Aufzeichnung von {0} Abtastwerten ergab {1} der {2} Längen des Plans"},
    {"arrived {0#} at {1#}, expected {2}; not used", "Ankunft {0} bei {1}; erwartet: {2}; nicht verwendet"},
    {"as programmed: once", "wie programmiert: einmal"},
    {"as programmed: {0#} times", "wie programmiert: {0}-mal"},
    {"at rest again, at {0#}; {1} keeps its first reading",
     "erneut Stillstand, bei {0}; {1} behält den ersten Messwert"},
    {"at rest at target {0#} ({1#}), expected {2}; not used",
     "Stillstand an Zielposition {0} ({1}); erwartet: {2}; nicht verwendet"},
    {"at rest at {0#} (target {1#}), but the way there was not recorded; not used",
     "Stillstand bei {0} (Zielposition {1}), aber der Weg dorthin wurde nicht aufgezeichnet; nicht verwendet"},
    {"at rest at {0#}, farther than {1#} from every target",
     "Stillstand bei {0}, weiter als {1} von jeder Zielposition"},
    {"at rest for {0#} s at target {1#}, expected at least {2#}",
     "{0}\u00a0s Stillstand an Zielposition {1}; erwartet: mindestens {2}"},
    {"connected after {0#} attempts", "nach {0} Versuchen verbunden"},
    {"connected again after {0#} s and {1#} attempt; samples are missing",
     "nach {0}\u00a0s und {1} Versuch wieder verbunden; Abtastwerte fehlen"},
    {"connected again after {0#} s and {1#} attempts; samples are missing",
     "nach {0}\u00a0s und {1} Versuchen wieder verbunden; Abtastwerte fehlen"},
    {"connection lost ({0=}), trying again for {1#} s", "Verbindung verloren ({0}), neue Versuche {1}\u00a0s lang"},
    {"cut off by missing samples or the end of the recording",
     "abgeschnitten durch fehlende Abtastwerte oder das Ende der Aufzeichnung"},
    {"drifts by {0#} while at rest", "driftet im Stillstand um {0}"},
    {"found a device, a pipe or a folder, expected a file",
     "ein Gerät, eine Leitung oder ein Ordner; erwartet: eine Datei"},
    {"found a length per count for a stream of positions, expected none",
     "Länge je Zählschritt für einen Strom von Positionen; erwartet: keine"},
    {"found a length per count for the stream of an HPI-3D, expected none: it tells distances",
     "eine Länge je Zählschritt für den Datenstrom eines HPI-3D; erwartet: keine, denn er nennt Abstände"},
    {"found a number that is not finite in sample {0#}, expected a position",
     "eine nicht endliche Zahl in Abtastwert {0}; erwartet: eine Position"},
    {"found a part, a datum or a zero for a plan of lines, expected none: lengths have a dead path that is not known",
     "ein Teil, ein Bezug oder ein Nullpunkt zu einem Plan von Linien; erwartet: keines davon, denn Längen haben eine "
     "unbekannte Totstrecke"},
    {"found a rate of {0#} samples a second, expected 0.001 to 10000000",
     "eine Rate von {0} Abtastwerten je Sekunde; erwartet: 0,001 bis 10000000"},
    {"found a recording of {0#} samples, expected at most {1#}",
     "eine Aufzeichnung von {0} Abtastwerten; erwartet: höchstens {1}"},
    {"found a window of ±{0#} around the targets, expected one above 0 and below {1#}, half way to the next target and "
     "to the overrun",
     "Fenster von ±{0} um die Zielpositionen; erwartet: eines über 0 und unter {1}, dem halben Weg zur nächsten "
     "Zielposition und zum Überlauf"},
    {"found an .rtx recording of the file type {0=}, whose numbers are angles in mrad, expected one of a linear axis",
     "eine .rtx-Aufzeichnung vom Dateityp {0}, deren Zahlen Winkel in mrad sind; erwartet: eine einer Linearachse"},
    {"found an .rtx recording of the file type {0=}, whose numbers are in mm, expected one of a rotary axis",
     "eine .rtx-Aufzeichnung vom Dateityp {0}, deren Zahlen in mm sind; erwartet: eine einer Drehachse"},
    {"found an .rtx recording that ends in its header, expected samples",
     "eine .rtx-Aufzeichnung, die in ihrem Kopf endet; erwartet: Abtastwerte"},
    {"found another program at this recording, expected none: it has one listener",
     "ein anderes Programm ist an dieser Aufzeichnung; erwartet: keines, denn nur eines kann hören"},
    {"found axis {0#} of an array, expected 1: it has one",
     "Achse {0} eines Arrays; erwartet: 1, denn es hat nur eine"},
    {"found axis {0#} of the stream, expected 1: it holds one distance",
     "Achse {0} des Datenstroms; erwartet: 1, denn er enthält einen Abstand"},
    {"found bytes that are no frame behind frame {0#}, expected AA B0, {1#} bytes with a check that is right",
     "Bytes hinter dem Datenpaket {0}, die keines sind; erwartet: AA B0, {1} Bytes mit richtiger Prüfsumme"},
    {"found capture {0=} in the archive already, as test {1=}, expected one that is to be gone on with",
     "Messung {0} liegt schon als Prüfung {1} im Archiv; erwartet: eine, die noch fortzusetzen ist"},
    {"found capture {0=} running elsewhere, expected one that was interrupted",
     "Messung {0} läuft anderswo; erwartet: eine unterbrochene"},
    {"found deviations from {0#} to {1#} from the targets, expected a range of {2#} at most: the recording belongs to "
     "another plan, or the window around the targets is too narrow for this axis (--target-window)",
     "Abweichungen von {0} bis {1} von den Zielpositionen; erwartet: eine Spannweite von höchstens {2}: Die "
     "Aufzeichnung gehört zu einem anderen Plan, oder das Fenster um die Zielpositionen ist für diese Achse zu eng "
     "(--target-window)"},
    {"found lengths that fall where the reflector recedes from the station, expected them to grow: the instrument "
     "counts the other way (--reversed), or this is the recording of another plan",
     "Längen, die abnehmen, wo der Reflektor sich von der Station entfernt; erwartet: dass sie zunehmen: Das Messgerät "
     "zählt andersherum (--reversed), oder dies ist die Aufzeichnung eines anderen Plans"},
    {"found lengths that grow where the reflector recedes from the station, expected them to fall: the instrument "
     "counts the other way (--reversed), or this is the recording of another plan",
     "Längen, die zunehmen, wo der Reflektor sich von der Station entfernt; erwartet: dass sie abnehmen: Das Messgerät "
     "zählt andersherum (--reversed), oder dies ist die Aufzeichnung eines anderen Plans"},
    {"found less than {0#} MiB left on the disk of the recording: it ends here",
     "weniger als {0}\u00a0MiB frei auf dem Datenträger der Aufzeichnung: Sie endet hier"},
    {"found more behind the {0#} sample that the header says, expected EOF::",
     "mehr hinter dem {0} Abtastwert, den der Kopf nennt; erwartet: EOF::"},
    {"found more behind the {0#} samples that the header says, expected EOF::",
     "mehr hinter den {0} Abtastwerten, die der Kopf nennt; erwartet: EOF::"},
    {"found more beside resume, expected it alone", "mehr als resume; erwartet: nur dieses"},
    {"found no distance without the instrument's flag of too high a speed, expected it cleared at the instrument "
     "before the recording",
     "kein Abstand ohne das Kennzeichen des Messgeräts für zu hohe Geschwindigkeit; erwartet: dass es vor der "
     "Aufzeichnung am Messgerät gelöscht wird"},
    {"found no distance without the instrument's flag of too weak a signal, expected it cleared at the instrument "
     "before the recording",
     "kein Abstand ohne das Kennzeichen des Messgeräts für zu schwaches Signal; erwartet: dass es vor der Aufzeichnung "
     "am Messgerät gelöscht wird"},
    {"found no frame with a distance, expected the stream of an HPI-3D",
     "kein Datenpaket mit einem Abstand; erwartet: der Datenstrom eines HPI-3D"},
    {"found no interrupted capture {0=}", "keine unterbrochene Messung {0}"},
    {"found no length for any of the {0#} approaches of the plan in {1#} standstill",
     "keine Länge für eine der {0} Anfahrten des Plans in {1} Stillstand"},
    {"found no length for any of the {0#} approaches of the plan in {1#} standstills",
     "keine Länge für eine der {0} Anfahrten des Plans in {1} Stillständen"},
    {"found no reading at target {0#} of the plan, expected one from every approach: left out of the test",
     "kein Messwert an Zielposition {0} des Plans; erwartet: einer aus jeder Anfahrt: in der Prüfung weggelassen"},
    {"found no sample and no times beside it, expected a recording to go on with",
     "kein Abtastwert und keine Zeiten daneben; erwartet: eine Aufzeichnung, die fortzusetzen ist"},
    {"found no standstill in the recording, expected the reflector to rest at every stop for sixteen samples and more "
     "(--rest-window, --rest-threshold)",
     "kein Stillstand in der Aufzeichnung; erwartet: dass der Reflektor an jedem Halt sechzehn Abtastwerte und länger "
     "ruht (--rest-window, --rest-threshold)"},
    {"found no standstill that is long enough and not at a turning point, expected one at each of the {0#} approaches "
     "of the plan, targets {1#} to {2#}: shorter and less quiet ones are taken with --shortest-rest and "
     "--rest-threshold",
     "kein Stillstand, der lang genug und nicht an einem Umkehrpunkt ist; erwartet: einer an jeder der {0} Anfahrten "
     "des Plans, Zielpositionen {1} bis {2}: Kürzere und weniger ruhige nehmen --shortest-rest und --rest-threshold"},
    {"found no standstill that is long enough and not at a turning point, expected one at each of the {0#} approaches "
     "of the plan, targets {1#} to {2#}: shorter and less quiet ones are taken with --shortest-rest and "
     "--rest-threshold; {3}",
     "kein Stillstand, der lang genug und nicht an einem Umkehrpunkt ist; erwartet: einer an jeder der {0} Anfahrten "
     "des Plans, Zielpositionen {1} bis {2}: Kürzere und weniger ruhige nehmen --shortest-rest und --rest-threshold; "
     "{3}"},
    {"found no {0#} standstills in {1#} that fit the first approaches of the plan, expected them to set the zero",
     "keine {0} Stillstände unter {1}, die zu den ersten Anfahrten des Plans passen; erwartet: solche, um Null zu "
     "setzen"},
    {"found no {0=} beside the recording: when its {1#} bytes arrived is not known",
     "kein {0} neben der Aufzeichnung: Wann ihre {1} Bytes ankamen, ist nicht bekannt"},
    {"found part {0#} asked for, expected 1 to {1#}: the plan and those that belong to it",
     "Teil {0} verlangt; erwartet: 1 bis {1}: der Plan und die zu ihm gehörenden"},
    {"found readings at {0#} of {1#} targets in {2#} standstills, expected at least two",
     "Messwerte an {0} von {1} Zielpositionen in {2} Stillständen; erwartet: mindestens zwei"},
    {"found the column {0=}, expected positions", "Spalte {0}; erwartet: Positionen"},
    {"found the columns {0=} beside the time, expected --stream-axis, which says the position's: 1 is the first of "
     "these",
     "Spalten {0} neben der Zeit; erwartet: --stream-axis, das die der Position nennt; 1 ist die erste von diesen"},
    {"found the port {0=} in {1=}, expected 1 to {2#}", "Port {0} in {1}; erwartet: 1 bis {2}"},
    {"found the recording {0=}, expected a file ending in .csv, .txt or .npy",
     "Aufzeichnung {0}; erwartet: eine Datei mit der Endung .csv, .txt oder .npy"},
    {"found the source {0=}, expected serial:///dev/ttyACM0?baud=2000000",
     "Quelle {0}; erwartet: serial:///dev/ttyACM0?baud=2000000"},
    {"found the source {0=}, expected tcp://host:port", "Quelle {0}; erwartet: tcp://host:port"},
    {"found the stream of an HPI-3D, which tells distances, for a rotary axis, expected a linear axis",
     "der Datenstrom eines HPI-3D, der Abstände nennt, für eine Drehachse; erwartet: eine Linearachse"},
    {"found velocities and no distance, expected an instrument that is set to distances",
     "Geschwindigkeiten und kein Abstand; erwartet: ein Messgerät, das auf Abstände gestellt ist"},
    {"found {0#} MiB left on the disk of the recording; at {1#} MiB the capture ends",
     "{0}\u00a0MiB frei auf dem Datenträger der Aufzeichnung; bei {1}\u00a0MiB endet die Messung"},
    {"found {0#} byte behind the last frame, expected whole frames of {1#} bytes",
     "{0} Byte hinter dem letzten Datenpaket; erwartet: ganze Datenpakete von {1} Bytes"},
    {"found {0#} byte of an unfinished time at the end of {1=}, left it out",
     "{0} Byte eines unvollständigen Zeitstempels am Ende von {1}; weggelassen"},
    {"found {0#} bytes behind the last frame, expected whole frames of {1#} bytes",
     "{0} Bytes hinter dem letzten Datenpaket; erwartet: ganze Datenpakete von {1} Bytes"},
    {"found {0#} bytes of an unfinished time at the end of {1=}, left them out",
     "{0} Bytes eines unvollständigen Zeitstempels am Ende von {1}; weggelassen"},
    {"found {0#} bytes without a frame whose check is right, expected one in {1#} (is the baud rate that of the "
     "instrument, 3000000?)",
     "{0} Bytes ohne ein Datenpaket mit richtiger Prüfsumme; erwartet: eines in {1} (ist die Baudrate die des "
     "Messgeräts, 3000000?)"},
    {"found {0#} bytes without a line break, expected one sample a line: the capture ends here; {1#} reading is kept",
     "{0} Bytes ohne Zeilenende; erwartet: ein Abtastwert je Zeile: Die Messung endet hier; {1} Messwert ist "
     "erhalten"},
    {"found {0#} bytes without a line break, expected one sample a line: the capture ends here; {1#} readings are kept",
     "{0} Bytes ohne Zeilenende; erwartet: ein Abtastwert je Zeile: Die Messung endet hier; {1} Messwerte sind "
     "erhalten"},
    {"found {0#} of {1#} standstills at the approaches of the plan, expected most of them ({2#} approaches, targets "
     "{3#} to {4#}): the recording belongs to another plan, or the zero or sign of the instrument differ (--zero, "
     "--datum, --reverse)",
     "{0} von {1} Stillständen an den Anfahrten des Plans; erwartet: die meisten ({2} Anfahrten, Zielpositionen {3} "
     "bis {4}): Die Aufzeichnung gehört zu einem anderen Plan, oder Nullpunkt oder Vorzeichen des Messgeräts sind "
     "andere (--zero, --datum, --reverse)"},
    {"found {0#} of {1#} standstills at the approaches of the plan, expected most of them ({2#} approaches, targets "
     "{3#} to {4#}): the recording belongs to another plan, or the zero or sign of the instrument differ (--zero, "
     "--datum, --reverse); {5}",
     "{0} von {1} Stillständen an den Anfahrten des Plans; erwartet: die meisten ({2} Anfahrten, Zielpositionen {3} "
     "bis {4}): Die Aufzeichnung gehört zu einem anderen Plan, oder Nullpunkt oder Vorzeichen des Messgeräts sind "
     "andere (--zero, --datum, --reverse); {5}"},
    {"found {0#} of {1#} standstills at the {2#} stops of the plan, and {3#} changes of length that are none of it, "
     "expected most standstills at stops: the recording belongs to another plan, or its lengths are in another unit",
     "{0} von {1} Stillständen an den {2} Halten des Plans und {3} Längenänderungen, die nicht dazu gehören; erwartet: "
     "die meisten Stillstände an Halten: Die Aufzeichnung gehört zu einem anderen Plan, oder ihre Längen stehen in "
     "einer "
     "anderen Einheit"},
    {"found {0#} of {1#} times in {2=} beyond the {3#} bytes of the recording, left them out",
     "{0} von {1} Zeitstempeln in {2} jenseits der {3} Bytes der Aufzeichnung; weggelassen"},
    {"found {0#} of {1#} times in {2=} damaged, the first is number {3#}, left them out",
     "{0} von {1} Zeitstempeln in {2} beschädigt, der erste ist Nummer {3}; weggelassen"},
    {"found {0#} sample, expected {1#} as the header says: the file is cut off",
     "{0} Abtastwert; erwartet: {1}, wie der Kopf sagt: Die Datei ist abgeschnitten"},
    {"found {0=} without its beginning AXIOMETRYTIMES2, read {1#} records of it that are sound",
     "{0} ohne seinen Anfang AXIOMETRYTIMES2; {1} unversehrte Einträge daraus gelesen"},
    {"found {0=}, expected it with the simulator only", "{0}; erwartet: nur beim Simulator"},
    {"from {0#} s to {1#} s the instrument showed {2#} without a change of the last digit, and then jumped: it may "
     "have "
     "lost its signal; not used",
     "von {0}\u00a0s bis {1}\u00a0s zeigte das Messgerät {2}, ohne dass sich die letzte Stelle änderte, und sprang "
     "dann: Es "
     "hat vielleicht sein Signal verloren; nicht verwendet"},
    {"half of all readings lie beyond {0#}: the zero of the instrument may be another than the plan's",
     "die Hälfte aller Messwerte liegt jenseits von {0}: Der Nullpunkt des Messgeräts ist vielleicht ein anderer als "
     "der des Plans"},
    {"incomplete: {0}", "unvollständig: {0}"},
    {"left out the end of the recording: {0}", "das Ende der Aufzeichnung wurde weggelassen: {0}"},
    {"left out the last byte of the recording, which is no whole sample",
     "das letzte Byte der Aufzeichnung, das kein ganzer Abtastwert ist, wurde weggelassen"},
    {"left out the last {0#} bytes of the recording, which are no whole sample",
     "die letzten {0} Bytes der Aufzeichnung, die kein ganzer Abtastwert sind, wurden weggelassen"},
    {"left out the recording up to the connection that begins behind byte {0#}: {1}",
     "die Aufzeichnung bis zur Verbindung, die hinter Byte {0} beginnt, wurde weggelassen: {1}"},
    {"left out the rest of the recording: {0}", "der Rest der Aufzeichnung wurde weggelassen: {0}"},
    {"left out {0#} line whose counter is out of order, the first is line {1#}",
     "{0} Zeile mit einem Zähler außer der Reihe weggelassen, die erste ist Zeile {1}"},
    {"left out {0#} line whose time is out of order, the first is line {1#}",
     "{0} Zeile mit einer Zeit außer der Reihe weggelassen, die erste ist Zeile {1}"},
    {"left out {0#} lines whose counter is out of order, the first is line {1#}",
     "{0} Zeilen mit einem Zähler außer der Reihe weggelassen, die erste ist Zeile {1}"},
    {"left out {0#} lines whose time is out of order, the first is line {1#}",
     "{0} Zeilen mit einer Zeit außer der Reihe weggelassen, die erste ist Zeile {1}"},
    {"left out {0#} sample with the instrument's flag of too high a speed: behind it distances are wrong until the "
     "instrument is set to zero and the flag cleared",
     "{0} Abtastwert mit dem Kennzeichen des Messgeräts für zu hohe Geschwindigkeit weggelassen: Danach sind Abstände "
     "falsch, bis es auf null gesetzt und das Kennzeichen gelöscht ist"},
    {"left out {0#} sample with the instrument's flag of too weak a signal: behind it distances may be wrong until the "
     "instrument is set to zero and the flag cleared",
     "{0} Abtastwert mit dem Kennzeichen des Messgeräts für zu schwaches Signal weggelassen: Danach können Abstände "
     "falsch sein, bis es auf null gesetzt und das Kennzeichen gelöscht ist"},
    {"left out {0#} samples with the instrument's flag of too high a speed: behind it distances are wrong until the "
     "instrument is set to zero and the flag cleared",
     "{0} Abtastwerte mit dem Kennzeichen des Messgeräts für zu hohe Geschwindigkeit weggelassen: Danach sind Abstände "
     "falsch, bis es auf null gesetzt und das Kennzeichen gelöscht ist"},
    {"left out {0#} samples with the instrument's flag of too weak a signal: behind it distances may be wrong until "
     "the instrument is set to zero and the flag cleared",
     "{0} Abtastwerte mit dem Kennzeichen des Messgeräts für zu schwaches Signal weggelassen: Danach können Abstände "
     "falsch sein, bis es auf null gesetzt und das Kennzeichen gelöscht ist"},
    {"left out {0#} value of the weather that no sensor shows",
     "{0} Wert der Umgebung weggelassen, den kein Fühler zeigt"},
    {"left out {0#} values of the weather that no sensor shows",
     "{0} Werte der Umgebung weggelassen, die kein Fühler zeigt"},
    {"line {0=}: before {1} (at {2#} s) samples are missing or the length jumped: the lengths from there on have "
     "another dead path",
     "Linie {0}: vor {1} (bei {2}\u00a0s) fehlen Abtastwerte oder die Länge sprang: Die Längen von dort an haben eine "
     "andere Totstrecke"},
    {"line {0=}: before {1} (at {2#} s) the lengths jump as on no way of the plan: the beam was broken, and the "
     "lengths from there on have another dead path",
     "Linie {0}: vor {1} (bei {2}\u00a0s) springen die Längen wie auf keinem Weg des Plans: Der Strahl war "
     "unterbrochen, "
     "und die Längen von dort an haben eine andere Totstrecke"},
    {"line {0=}: no length for {1} and {2#} other: {3}", "Linie {0}: keine Länge für {1} und {2} weitere: {3}"},
    {"line {0=}: no length for {1} and {2#} others: {3}", "Linie {0}: keine Länge für {1} und {2} weitere: {3}"},
    {"line {0=}: no length for {1}: {2}", "Linie {0}: keine Länge für {1}: {2}"},
    {"missed: {0}", "ausgelassen: {0}"},
    {"no standstill", "kein Stillstand"},
    {"no standstill for {0}", "kein Stillstand für {0}"},
    {"no standstill for {0} and others", "kein Stillstand für {0} und weitere"},
    {"not seen: {0}", "nicht gesehen: {0}"},
    {"part {0#}: before {1} (at {2#} s) samples are missing or the length jumped: the lengths from there on have "
     "another dead path",
     "Teil {0}: vor {1} (bei {2}\u00a0s) fehlen Abtastwerte oder die Länge sprang: Die Längen von dort an haben eine "
     "andere Totstrecke"},
    {"part {0#}: before {1} (at {2#} s) the lengths jump as on no way of the plan: the beam was broken, and the "
     "lengths from there on have another dead path",
     "Teil {0}: vor {1} (bei {2}\u00a0s) springen die Längen wie auf keinem Weg des Plans: Der Strahl war "
     "unterbrochen, und die Längen von dort an haben eine andere Totstrecke"},
    {"part {0#}: no length for {1} and {2#} other: {3}", "Teil {0}: keine Länge für {1} und {2} weiteren: {3}"},
    {"part {0#}: no length for {1} and {2#} others: {3}", "Teil {0}: keine Länge für {1} und {2} weitere: {3}"},
    {"part {0#}: no length for {1}: {2}", "Teil {0}: keine Länge für {1}: {2}"},
    {"part {0#}: point {1#}: {2}", "Teil {0}: Punkt {1}: {2}"},
    {"passed over {0#} byte of a frame that had begun before",
     "{0} Byte eines schon vorher begonnenen Datenpakets übergangen"},
    {"passed over {0#} bytes of a frame that had begun before",
     "{0} Bytes eines schon vorher begonnenen Datenpakets übergangen"},
    {"passed over {0#} velocities between the distances", "{0} Geschwindigkeiten zwischen den Abständen übergangen"},
    {"passed over {0#} velocity between the distances", "{0} Geschwindigkeit zwischen den Abständen übergangen"},
    {"point {0#}", "Punkt {0}"},
    {"repeated: {0}", "wiederholt: {0}"},
    {"restarted: {0}", "neu begonnen: {0}"},
    {"samples at rest scatter by {0#}, which leaves {1#} in a reading of a scatter between runs of {2#}: R and A hold "
     "the noise of the recording",
     "Abtastwerte im Stillstand streuen um {0}, was {1} in einem Messwert lässt, bei einer Streuung zwischen den "
     "Durchläufen von {2}: R und A enthalten das Rauschen der Aufzeichnung"},
    {"signal lost: {0}", "Signal verloren: {0}"},
    {"target {0#} run {1#}: {2}", "Zielposition {0}, Durchlauf {1}: {2}"},
    {"the axis rested {0#} s at the targets, half of the rests longer and half shorter, where the plan has {1#} s: the "
     "dwell is that of the recording",
     "die Achse ruhte {0} s an den Zielpositionen (die Hälfte länger, die Hälfte kürzer), wo der Plan {1} s hat: Als "
     "Verweilzeit gilt die der Aufzeichnung"},
    {"the clock of the samples was set ahead {0#} time, first in line {1#}; it was taken as a gap",
     "die Uhr der Abtastwerte wurde {0}-mal vorgestellt, zuerst in Zeile {1}; das gilt als Lücke"},
    {"the clock of the samples was set ahead {0#} times, first in line {1#}; it was taken as a gap",
     "die Uhr der Abtastwerte wurde {0}-mal vorgestellt, zuerst in Zeile {1}; das gilt als Lücke"},
    {"the clock of the samples was set back {0#} time, first in line {1#}; it was taken on",
     "die Uhr der Abtastwerte wurde {0}-mal zurückgestellt, zuerst in Zeile {1}; sie wurde weitergeführt"},
    {"the clock of the samples was set back {0#} times, first in line {1#}; it was taken on",
     "die Uhr der Abtastwerte wurde {0}-mal zurückgestellt, zuerst in Zeile {1}; sie wurde weitergeführt"},
    {"the connection did not come back in {0#} attempt: the recording ends here",
     "die Verbindung kam in {0} Versuch nicht wieder: Die Aufzeichnung endet hier"},
    {"the connection did not come back in {0#} attempts: the recording ends here",
     "die Verbindung kam in {0} Versuchen nicht wieder: Die Aufzeichnung endet hier"},
    {"the counter of the samples was set back {0#} time, first in line {1#}; it was taken on",
     "der Zähler der Abtastwerte wurde {0}-mal zurückgestellt, zuerst in Zeile {1}; er wurde weitergeführt"},
    {"the counter of the samples was set back {0#} times, first in line {1#}; it was taken on",
     "der Zähler der Abtastwerte wurde {0}-mal zurückgestellt, zuerst in Zeile {1}; er wurde weitergeführt"},
    {"the file is of {0=}; whether the day or the month stands first it does not say",
     "die Datei ist von {0}; ob Tag oder Monat zuerst steht, sagt sie nicht"},
    {"the file names the axis {0=}", "die Datei nennt die Achse {0}"},
    {"the file names the location {0=}", "die Datei nennt den Ort {0}"},
    {"the file names the machine {0=}", "die Datei nennt die Maschine {0}"},
    {"the file names the serial number {0=}", "die Datei nennt die Seriennummer {0}"},
    {"the file states a trigger interval of {0#} and a rate of {1#} Hz, which are no interval of time and its rate: "
     "were the samples triggered by position, their times are wrong",
     "die Datei nennt einen Abstand der Auslösungen von {0} und eine Rate von {1}\u00a0Hz, die nicht zueinander "
     "passen: Wurden die Abtastwerte nach dem Weg ausgelöst, sind ihre Zeiten falsch"},
    {"the file states no actual sample rate: the times are those of the sample rate that was asked for",
     "die Datei nennt keine tatsächliche Abtastrate: Die Zeiten sind die der verlangten Abtastrate"},
    {"the first standstill at target {0#} showed {1#}: zero lies at {2#}",
     "der erste Stillstand an Zielposition {0} zeigte {1}: Null liegt bei {2}"},
    {"the instrument was silent for more than a second {0#} time, {1#} s at most: samples may be missing there",
     "das Messgerät schwieg {0} Mal länger als eine Sekunde, höchstens {1}\u00a0s: Dort können Abtastwerte fehlen"},
    {"the instrument was silent for more than a second {0#} times, {1#} s at most: samples may be missing there",
     "das Messgerät schwieg {0} Mal länger als eine Sekunde, höchstens {1}\u00a0s: Dort können Abtastwerte fehlen"},
    {"the length stood still to the last digit there and then jumped: the instrument may have lost its signal",
     "die Länge änderte sich dort nicht einmal in der letzten Stelle und sprang dann: Das Messgerät hat vielleicht "
     "sein "
     "Signal verloren"},
    {"the numbers of the file were taken as angles in mrad", "die Zahlen der Datei gelten als Winkel in mrad"},
    {"the rate that was given is not used, since the recording tells its times",
     "die angegebene Abtastrate wird nicht verwendet, denn die Aufzeichnung nennt ihre Zeiten"},
    {"the recording ended before", "die Aufzeichnung endete vorher"},
    {"the recording ended before {0}", "die Aufzeichnung endete vor {0}"},
    {"the recording ended before {0} and the {1#} behind it", "die Aufzeichnung endete vor {0} und den {1} danach"},
    {"the recording gave {0#} of the {1#} readings of the plan",
     "die Aufzeichnung ergab {0} der {1} Messwerte des Plans"},
    {"the recording has become as long as one may be: it ends here",
     "die Aufzeichnung ist so lang geworden, wie eine sein darf: Sie endet hier"},
    {"the recording tells no times: 25 samples a second are assumed, as the instrument sends them (--rate says "
     "otherwise)",
     "die Aufzeichnung nennt keine Zeiten: 25 Abtastwerte je Sekunde sind angenommen, wie das Messgerät sie sendet "
     "(anders mit --rate)"},
    {"the reflector rested where no stop of the plan was due, first at {0#} s; not used ({1#} in all)",
     "der Reflektor stand still, wo kein Halt des Plans an der Reihe war, zuerst bei {0}\u00a0s; nicht verwendet "
     "(insgesamt {1})"},
    {"the rest was too short", "der Stillstand war zu kurz"},
    {"the stream shows {0#} lost of {1#} samples", "der Datenstrom zeigt {0} verlorene von {1} Abtastwerten"},
    {"too short: {0}", "zu kurz: {0}"},
    {"unexpected: {0}", "unerwartet: {0}"},
    {"what was there may as well belong to another stop that was not heard",
     "was dort war, kann ebenso zu einem anderen Halt gehören, der nicht gehört wurde"},
    {"when {0#} of the {1#} bytes of the recording arrived is not known",
     "wann {0} der {1} Bytes der Aufzeichnung ankamen, ist nicht bekannt"},
    {"wrong direction: {0}", "falsche Richtung: {0}"},
    {"zero: {0}", "Nullpunkt: {0}"},
    {"{0#} byte between the frames made no frame whose check is right; counted as {1#} lost sample",
     "{0} Byte zwischen den Datenpaketen ergab keines mit richtiger Prüfsumme; als {1} verlorener Abtastwert gezählt"},
    {"{0#} bytes between the frames made no frame whose check is right; counted as {1#} damaged frame of the weather",
     "{0} Bytes zwischen den Datenpaketen ergaben keines mit richtiger Prüfsumme; als {1} beschädigtes Datenpaket "
     "des Wetters gezählt"},
    {"{0#} bytes between the frames made no frame whose check is right; counted as {1#} damaged frames of the "
     "weather",
     "{0} Bytes zwischen den Datenpaketen ergaben keines mit richtiger Prüfsumme; als {1} beschädigte Datenpakete "
     "des Wetters gezählt"},
    {"{0#} bytes between the frames made no frame whose check is right; counted as {1#} lost sample",
     "{0} Bytes zwischen den Datenpaketen ergaben keines mit richtiger Prüfsumme; als {1} verlorener Abtastwert "
     "gezählt"},
    {"{0#} bytes between the frames made no frame whose check is right; counted as {1#} lost sample and {2#} "
     "damaged frame of the weather",
     "{0} Bytes zwischen den Datenpaketen ergaben keines mit richtiger Prüfsumme; als {1} verlorener Abtastwert "
     "und {2} beschädigtes Datenpaket des Wetters gezählt"},
    {"{0#} bytes between the frames made no frame whose check is right; counted as {1#} lost sample and {2#} "
     "damaged frames of the weather",
     "{0} Bytes zwischen den Datenpaketen ergaben keines mit richtiger Prüfsumme; als {1} verlorener Abtastwert "
     "und {2} beschädigte Datenpakete des Wetters gezählt"},
    {"{0#} bytes between the frames made no frame whose check is right; counted as {1#} lost samples",
     "{0} Bytes zwischen den Datenpaketen ergaben keines mit richtiger Prüfsumme; als {1} verlorene Abtastwerte "
     "gezählt"},
    {"{0#} bytes between the frames made no frame whose check is right; counted as {1#} lost samples and {2#} "
     "damaged frame of the weather",
     "{0} Bytes zwischen den Datenpaketen ergaben keines mit richtiger Prüfsumme; als {1} verlorene Abtastwerte "
     "und {2} beschädigtes Datenpaket des Wetters gezählt"},
    {"{0#} bytes between the frames made no frame whose check is right; counted as {1#} lost samples and {2#} "
     "damaged frames of the weather",
     "{0} Bytes zwischen den Datenpaketen ergaben keines mit richtiger Prüfsumme; als {1} verlorene Abtastwerte "
     "und {2} beschädigte Datenpakete des Wetters gezählt"},
    {"{0#} earlier messages are not shown", "{0} frühere Meldungen werden nicht gezeigt"},
    {"{0#} further remarks of that kind on readings", "{0} weitere Bemerkungen dieser Art zu Messwerten"},
    {"{0#} of {1#} samples left out as outliers", "{0} von {1} Abtastwerten als Ausreißer weggelassen"},
    {"{0#} sample came while the instrument did not show its laser as ready; they are used",
     "{0} Abtastwert kam, während das Messgerät seinen Laser nicht als bereit zeigte; er wird verwendet"},
    {"{0#} samples came while the instrument did not show its laser as ready; they are used",
     "{0} Abtastwerte kamen, während das Messgerät seinen Laser nicht als bereit zeigte; sie werden verwendet"},
    {"{0=}, trying again for {1#} s", "{0}; neue Versuche {1}\u00a0s lang"},
    {"{0} came again after {1#} readings, which were dropped",
     "{0} kam nach {1} Messwerten noch einmal; diese wurden verworfen"},
};

}  // namespace

const std::span<const Phrase> german_capture{capture_rows};

}  // namespace axiometry::language
