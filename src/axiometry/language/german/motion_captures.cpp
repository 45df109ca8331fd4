// SPDX-License-Identifier: Apache-2.0
// Live captures of straightness and rotations: what is told of readings and stops, and refused.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase motion_captures_rows[] = {
    {"A bow, a slope and another value on the way back, each run within the noise",
     "Ein Bogen, eine Steigung und ein anderer Wert auf dem Rückweg, jeder Durchlauf innerhalb des Rauschens"},
    {"Each run lies apart from the one before, by what the instrument moved meanwhile",
     "Jeder Durchlauf liegt neben dem vorigen, um das, was das Messmittel sich inzwischen bewegt hat"},
    {"The readings drift", "Die Messwerte driften"},
    {"a reading more than the plan has approaches: not used",
     "ein Messwert mehr, als der Plan Anfahrten hat: nicht verwendet"},
    {"a trigger while the one before was being read: not used",
     "ein Trigger, während der vorige noch gelesen wurde: nicht verwendet"},
    {"found a column of the stops, expected one with --stops trigger or position alone",
     "eine Spalte der Halte; erwartet: eine nur mit --stops trigger oder position"},
    {"found a file of keys with a live source, expected one with a finished recording",
     "eine Datei von Eingaben zu einer laufenden Quelle; erwartet: eine zu einer fertigen Aufzeichnung"},
    {"found a finished recording and no keys, expected --keys with those that were said at its stops",
     "eine fertige Aufzeichnung und keine Eingaben; erwartet: --keys mit denen, die an ihren Halten gemacht wurden"},
    {"found a part beside stops, expected a plan of one axis alone",
     "ein Teil neben stops; erwartet: ein Plan einer einzigen Achse"},
    {"found a plan made for {0=}, expected --error, which says what is read",
     "ein Plan für {0}; erwartet: --error, das sagt, was gelesen wird"},
    {"found a plan made for {0=}, expected one of positions; axiometry capture --stops leads through one of other "
     "errors",
     "ein Plan für {0}; erwartet: einer von Positionen; durch einen von anderen Abweichungen führt axiometry capture "
     "--stops"},
    {"found a plan of one target, expected two at least: the simulator spans the error between them",
     "ein Plan mit einer einzigen Zielposition; erwartet: mindestens zwei, zwischen denen der Simulator die "
     "Abweichung aufspannt"},
    {"found a stream of the layout {0=}, expected time-position: the stops are told by a column of the same line",
     "ein Datenstrom der Anordnung {0}; erwartet: time-position, denn die Halte nennt eine Spalte derselben Zeile"},
    {"found a stream of the layout {0=}, whose numbers are positions, expected one of readings: time-position or "
     "camonitor-stream",
     "ein Datenstrom der Anordnung {0}, dessen Zahlen Positionen sind; erwartet: einer von Messwerten, time-position "
     "oder camonitor-stream"},
    {"found a target window, a datum or a reversed direction, expected them with --stops position alone",
     "ein Fenster um die Zielpositionen, ein Bezug oder eine umgekehrte Richtung; erwartet: nur mit --stops position"},
    {"found a window of the readings, expected one with --stops keys or trigger alone",
     "ein Zeitfenster der Messwerte; erwartet: eines nur mit --stops keys oder trigger"},
    {"found a zero to be set at the first target, expected the datum of the position: readings beside it are taken as "
     "they come",
     "ein Nullpunkt, der an der ersten Zielposition gesetzt werden soll; erwartet: der Bezug der Position, denn "
     "Messwerte daneben werden genommen, wie sie kommen"},
    {"found capture {0=} not running, expected one that runs", "Messung {0} läuft nicht; erwartet: eine, die läuft"},
    {"found capture {0=} of a test, expected one of lengths or readings",
     "Messung {0} einer Prüfung; erwartet: eine von Längen oder Messwerten"},
    {"found capture {0=} of the error {1=}, expected one of lengths",
     "Messung {0} der Abweichung {1}; erwartet: eine von Längen"},
    {"found capture {0=}, at whose stops nothing can be said, expected one of a straightness or a rotation with the "
     "stops keys, trigger or readings",
     "Messung {0}, an deren Halten nichts angegeben werden kann; erwartet: eine einer Geradheit oder Drehung mit den "
     "Halten keys, trigger oder readings"},
    {"found how still readings must be, expected it where more than one is taken at a stop",
     "eine Angabe, wie ruhig Messwerte sein müssen; erwartet: nur, wo an einem Halt mehr als einer genommen wird"},
    {"found keys of another recording, expected none before this one begins",
     "Eingaben zu einer anderen Aufzeichnung; erwartet: keine, bevor diese beginnt"},
    {"found means that range over {0#} {1=}, expected {2#} at most",
     "Mittelwerte mit einer Spanne von {0} {1}; erwartet: höchstens {2}"},
    {"found no column of the position, expected --stop-column with its number beside the time",
     "keine Spalte der Position; erwartet: --stop-column mit ihrer Nummer neben der Zeit"},
    {"found no column of the trigger, expected --stop-column with its number beside the time",
     "keine Spalte des Triggers; erwartet: --stop-column mit ihrer Nummer neben der Zeit"},
    {"found no reading for any of the {0#} approaches", "kein Messwert für eine der {0} Anfahrten"},
    {"found readings in {0=} by the stream's header, expected {1=} as stated",
     "Messwerte in {0} laut Kopf des Datenstroms; erwartet: {1} wie angegeben"},
    {"found readings without a unit, expected --unit um, mm, urad, arcsec, mrad or deg, as the instrument sends them",
     "Messwerte ohne Einheit; erwartet: --unit um, mm, urad, arcsec, mrad oder deg, wie das Messmittel sie sendet"},
    {"found size, expected it with the stops of a straightness or a rotation only",
     "size; erwartet: nur mit den Halten einer Geradheit oder Drehung"},
    {"found the column {0=} in a unit that is not known, expected one of {1=}",
     "die Spalte {0} in einer unbekannten Einheit; erwartet: eine von {1}"},
    {"found the error {0=}, whose readings are positions and show the stops themselves; expected a straightness or a "
     "rotation, or no --stops",
     "die Abweichung {0}, deren Messwerte Positionen sind und die Halte selbst zeigen; erwartet: eine Geradheit oder "
     "eine Drehung, oder kein --stops"},
    {"found the key {0=}, expected take, skip or undo", "Eingabe {0}; erwartet: take, skip oder undo"},
    {"found the simulator as source of positions or lengths, expected it with --stops",
     "der Simulator als Quelle von Positionen oder Längen; erwartet: er nur mit --stops"},
    {"found the source {0=}, expected simulator://?seed=7", "Quelle {0}; erwartet: simulator://?seed=7"},
    {"found the unit {0=}, expected one of {1=}", "Einheit {0}; erwartet: eine von {1}"},
    {"found the unknown member {0=}, expected key", "unbekannter Eintrag {0}; erwartet: key"},
    {"found what is said of stops without stops, expected keys, trigger, readings or position",
     "Angaben zu Halten ohne stops; erwartet: keys, trigger, readings oder position"},
    {"found {0#} columns beside the time, expected --stream-axis, which says that of the readings: 1 is the first of "
     "these",
     "{0} Spalten neben der Zeit; erwartet: --stream-axis, das die der Messwerte nennt: 1 ist die erste davon"},
    {"found {0#} s after {1#} s, expected the order in which it was said",
     "{0}\u00a0s nach {1}\u00a0s; erwartet: die Reihenfolge, in der es eingegeben wurde"},
    {"found {0#} sample, expected at least {1#} to tell whether they stand still",
     "{0} Abtastwert; erwartet: mindestens {1}, um zu erkennen, ob sie stillstehen"},
    {"found {0#} samples, expected at least {1#} to tell whether they stand still",
     "{0} Abtastwerte; erwartet: mindestens {1}, um zu erkennen, ob sie stillstehen"},
    {"found {0=} in the source, expected preset, size, seed or speed",
     "{0} in der Quelle; erwartet: preset, size, seed oder speed"},
    {"found {0=} with the simulator, expected {1=} or none", "{0} beim Simulator; erwartet: {1} oder nichts"},
    {"found {0=}, expected a finite number as reading", "{0}; erwartet: eine endliche Zahl als Messwert"},
    {"found {0=}, expected a number above 0 up to 1e6", "{0}; erwartet: eine Zahl über 0 bis 1e6"},
    {"found {0=}, expected a number above 0 up to {1#}", "{0}; erwartet: eine Zahl über 0 bis {1}"},
    {"found {0=}, expected a number from 1 to 1000", "{0}; erwartet: eine Zahl von 1 bis 1000"},
    {"found {0=}, expected a time in s and take, skip or undo, such as 12.5,take",
     "{0}; erwartet: eine Zeit in s und take, skip oder undo, etwa 12.5,take"},
    {"found {0=}, expected keys, trigger, readings or position",
     "{0}; erwartet: keys, trigger, readings oder position"},
    {"found {0=}, expected two columns, time and reading, perhaps below a header such as time_s,straightness_um",
     "{0}; erwartet: zwei Spalten, Zeit und Messwert, vielleicht unter einem Kopf wie time_s,straightness_um"},
    {"no reading has come yet: not used", "noch kein Messwert ist gekommen: nicht verwendet"},
    {"samples are missing, or the recording ended, while it was read",
     "Abtastwerte fehlen, oder die Aufzeichnung endete, während gelesen wurde"},
    {"so late that {0} may have been passed without a reading (the plan's program needs {1#} s): it and all behind it "
     "wait to be told; \"take\" when it is this one, \"skip\" when this one is missing",
     "so spät, dass {0} ohne Messwert durchfahren sein kann (das Programm des Plans braucht {1}\u00a0s): er und alle "
     "danach warten auf eine Eingabe; \"take\", wenn er dazu gehört, \"skip\", wenn dieser fehlt"},
    {"sooner than the axis can be at {0}, to which the plan's program needs {1#} s: not used",
     "früher, als die Achse an {0} sein kann, wohin das Programm des Plans {1}\u00a0s braucht: nicht verwendet"},
    {"the plan's program needs {0#} s to {1}, which is much longer than since the reading before: not used; again "
     "takes it all the same",
     "das Programm des Plans braucht {0}\u00a0s bis {1}, viel länger als seit dem Messwert davor: nicht verwendet; "
     "noch "
     "einmal nimmt ihn trotzdem"},
    {"the reading of {0} that had begun", "der begonnene Messwert von {0}"},
    {"what was said while the capture ended is not used",
     "was beim Ende der Messung eingegeben wurde, wird nicht verwendet"},
    {"what was said while the connection was away is not used",
     "was eingegeben wurde, während die Verbindung weg war, wird nicht verwendet"},
    {"{0#} more in the same way: not used", "{0} weitere ebenso: nicht verwendet"},
    {"{0#} reading whose target was not told: not used",
     "{0} Messwert, dessen Zielposition nicht angegeben wurde: nicht verwendet"},
    {"{0#} readings whose target was not told: not used",
     "{0} Messwerte, deren Zielposition nicht angegeben wurde: nicht verwendet"},
    {"{0=}: {1}; not used", "{0}: {1}; nicht verwendet"},
    {"{0=}: {1}; not used, the target is still due", "{0}: {1}; nicht verwendet, die Zielposition steht noch aus"},
    {"{0} has no reading", "{0} hat keinen Messwert"},
    {"{0} is due again", "{0} steht wieder aus"},
};

}  // namespace

const std::span<const Phrase> german_motion_captures = motion_captures_rows;

}  // namespace axiometry::language
