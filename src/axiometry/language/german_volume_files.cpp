// SPDX-License-Identifier: Apache-2.0
// Files of calibrations of a volume, of straightness and angles, and of simulations: what is refused.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase rows[] = {
    {"found a position a second time and neither run nor direction, expected a column of them",
     "Position zum zweiten Mal und weder run noch direction; erwartet: eine Spalte davon"},
    {"found a table that moves {0#} by the position of {1#} for {2=}, expected one of the axis itself: the format "
     "takes no other",
     "Tabelle, die {0} nach der Position von {1} bewegt, für {2}; erwartet: eine der Achse selbst, denn das Format "
     "nimmt keine andere an"},
    {"found no column {0=}, expected position_mm, run, direction and straightness_um or angle_urad",
     "keine Spalte {0}; erwartet: position_mm, run, direction und straightness_um oder angle_urad"},
    {"found no header, expected one as {0=}", "keine Kopfzeile; erwartet: eine wie {0}"},
    {"found no header, expected one with position_mm, run, direction and straightness_um or angle_urad",
     "keine Kopfzeile; erwartet: eine mit position_mm, run, direction und straightness_um oder angle_urad"},
    {"found no member \"model\", expected the result of 'axiometry volumetric identify --out'",
     "kein Eintrag \"model\"; erwartet: das Ergebnis von „axiometry volumetric identify --out“"},
    {"found no readings below the header, expected one on each line",
     "keine Messwerte unter der Kopfzeile; erwartet: einer in jeder Zeile"},
    {"found no station in the machine's file, expected stations_mm, or stations to be proposed",
     "keine Station in der Datei der Maschine; erwartet: stations_mm, oder vorzuschlagende Stationen"},
    {"found no value of {0=}, expected a table of positions and values",
     "kein Wert von {0}; erwartet: eine Tabelle von Positionen und Werten"},
    {"found the column {0=} without a unit, expected one of angle: urad, mrad, arcsec or deg",
     "Spalte {0} ohne Einheit; erwartet: eine des Winkels: urad, mrad, arcsec oder deg"},
    {"found the column {0=} without a unit, expected one of length: um, mm, nm, m or in",
     "Spalte {0} ohne Einheit; erwartet: eine der Länge: um, mm, nm, m oder in"},
    {"found the column {0=} without a unit, expected one such as um, urad or arcsec",
     "Spalte {0} ohne Einheit; erwartet: eine wie um, urad oder arcsec"},
    {"found the error {0=} after {1=}, expected one in a file", "Abweichung {0} nach {1}; erwartet: eine je Datei"},
    {"found the error {0=} in the file, expected {1=} as given",
     "Abweichung {0} in der Datei; erwartet: {1}, wie angegeben"},
    {"found the test's name {0=}, expected a file ending in {1=}",
     "Name {0} für die Prüfung; erwartet: eine Datei mit der Endung {1}"},
    {"found the unit {0=} of the column {1=}, expected a unit of angle: deg, arcsec, mdeg, rad, mrad or urad",
     "Einheit {0} der Spalte {1}; erwartet: eine Winkeleinheit: deg, arcsec, mdeg, rad, mrad oder urad"},
    {"found the unit {0=} of the column {1=}, expected a unit of length: um, mm, nm, m or in",
     "Einheit {0} der Spalte {1}; erwartet: eine Längeneinheit: um, mm, nm, m oder in"},
    {"found the unit {0=} of the column {1=}, expected one of angle: urad, mrad, arcsec or deg",
     "Einheit {0} der Spalte {1}; erwartet: eine des Winkels: urad, mrad, arcsec oder deg"},
    {"found the unit {0=} of the column {1=}, expected one of length: um, mm, nm, m or in",
     "Einheit {0} der Spalte {1}; erwartet: eine der Länge: um, mm, nm, m oder in"},
    {"found the unit {0=} of the column {1=}, expected one such as um, urad or arcsec",
     "Einheit {0} der Spalte {1}; erwartet: eine wie um, urad oder arcsec"},
    {"found {0#} at {1#} (line {2#}), expected it within its travel of {3#} to {4#}; are axes, signs or units mixed "
     "up?",
     "{0} bei {1} (Zeile {2}); erwartet: innerhalb des Verfahrwegs von {3} bis {4}; sind Achsen, Vorzeichen oder "
     "Einheiten vertauscht?"},
    {"found {0#} members of {1=}, expected at most {2#}", "{0} Einträge von {1}; erwartet: höchstens {2}"},
    {"found {0=} beside {1=}, expected one column of them", "{0} neben {1}; erwartet: eine Spalte davon"},
    {"the table that was made", "die erzeugte Tabelle"},
    {"{0=}: found a number that is not finite in value {1#}", "{0}: eine Zahl in Wert {1}, die nicht endlich ist"},
    {"{0=}: found the position {1#} behind {2#}, expected them to rise",
     "{0}: Position {1} nach {2}; erwartet: steigende"},
    {"{0=}: found {1#} numbers, expected two ends", "{0}: {1} Zahlen; erwartet: zwei Enden"},
    {"{0=}: found {1#} of them, expected at most {2#}", "{0}: {1} Stück; erwartet: höchstens {2}"},
    {"{0=}: found {1#} values, expected {2#} to {3#}", "{0}: {1} Werte; erwartet: {2} bis {3}"},
    {"{0=}: found {1}, expected array", "{0}: {1}; erwartet: eine Liste"},
    {"{0=}: found {1}, expected number", "{0}: {1}; erwartet: eine Zahl"},
    {"{0=}: found {1}, expected object", "{0}: {1}; erwartet: ein Objekt"},
    {"{0=}: found {1}, expected string", "{0}: {1}; erwartet: ein Text"},
};

}  // namespace

const std::span<const Phrase> german_volume_files = rows;

}  // namespace axiometry::language
