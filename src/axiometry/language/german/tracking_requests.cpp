// SPDX-License-Identifier: Apache-2.0
// What requests about a tracking interferometer are refused for.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase tracking_requests_rows[] = {
    {"break_threshold_mm: {0}", "break_threshold_mm: {0}"},
    {"find_breaks: {0}", "find_breaks: {0}"},
    {"found a form without a plan, expected the files lengths and plan",
     "Formular ohne Plan; erwartet: die Dateien lengths und plan"},
    {"found a form without lengths, expected the files lengths and plan",
     "Formular ohne Längen; erwartet: die Dateien lengths und plan"},
    {"found a plan whose interferometer is aligned with each line, expected one with a station: the simulator follows "
     "a reflector",
     "ein Plan, dessen Interferometer auf jede Linie ausgerichtet wird; erwartet: einer mit Station, denn der "
     "Simulator folgt einem Reflektor"},
    {"found a sheet as {0=}, expected one of {1=}", "Blatt als {0}; erwartet: eines von {1}"},
    {"found a step of {0#}, expected {1#} to {2#}", "Schrittweite {0}; erwartet: {1} bis {2}"},
    {"found an obstacle without exactly one shape, expected a box, a sphere or a cylinder",
     "Hindernis ohne genau eine Form; erwartet: ein Quader, eine Kugel oder ein Zylinder"},
    {"found an uncertainty of lengths of {0=}, expected one above 0",
     "Unsicherheit der Längen von {0}; erwartet: eine über 0"},
    {"found both a request and a plan, expected one of them",
     "Anforderung und Plan zugleich; erwartet: eines von beiden"},
    {"found limits of a tracking instrument without a station, expected none: the interferometer is aligned with each "
     "diagonal",
     "Grenzen eines nachführenden Geräts ohne Station; erwartet: keine, denn das Interferometer wird auf jede "
     "Diagonale "
     "ausgerichtet"},
    {"found no column {0=}, expected a header with {1=}", "keine Spalte {0}; erwartet: eine Kopfzeile mit {1}"},
    {"found no form, expected one with the files lengths and plan",
     "kein Formular; erwartet: eines mit den Dateien lengths und plan"},
    {"found no line that can be measured, expected one at least; x: {0}; y: {1}; z: {2}; xy: {3}; xz: {4}; yz: {5}; "
     "xyz: {6}",
     "keine Linie ist messbar; erwartet: wenigstens eine; x: {0}; y: {1}; z: {2}; xy: {3}; xz: {4}; yz: {5}; xyz: {6}"},
    {"found no line that can be measured, expected one at least; x: {0}; y: {1}; z: {2}; xy: {3}; xz: {4}; yz: {5}; "
     "xyz: {6}; {7}",
     "keine Linie ist messbar; erwartet: wenigstens eine; x: {0}; y: {1}; z: {2}; xy: {3}; xz: {4}; yz: {5}; "
     "xyz: {6}; {7}"},
    {"found no request, expected one", "keine Anforderung; erwartet: eine"},
    {"found no station, expected one", "keine Station; erwartet: eine"},
    {"found options of {0#} bytes, expected at most {1#}", "Optionen von {0} Bytes; erwartet: höchstens {1}"},
    {"found the end of the text, expected a member name in quotes",
     "Ende des Textes; erwartet: der Name eines Eintrags in Anführungszeichen"},
    {"found the line {0=} asked for, expected one of {1=}", "Linie {0} verlangt; erwartet: eine von {1}"},
    {"found the line {0=} asked for, which is lost ({1}), expected one of {2=}",
     "Linie {0} verlangt, die verloren ist ({1}); erwartet: eine von {2}"},
    {"found the line {0=} with the direction of {1=}, expected that of its name",
     "Linie {0} mit der Richtung von {1}; erwartet: die ihres Namens"},
    {"found the line {0=}, expected x, y, z, xy, xz, yz, xyz, body, face or a diagonal such as NNN-PPP or NN0-PP0",
     "Linie {0}; erwartet: x, y, z, xy, xz, yz, xyz, body, face oder eine Diagonale wie NNN-PPP oder NN0-PP0"},
    {"found the name of a tolerance table and no file tolerances, expected both",
     "Name einer Toleranztabelle und keine Datei tolerances; erwartet: beides"},
    {"found the part {0=} in the form, expected the files lengths, plan, station and tolerances, and options",
     "Teil {0} im Formular; erwartet: die Dateien lengths, plan, station und tolerances sowie options"},
    {"found the station at {0=} mm, {1#} from all that the reflector reaches, expected it within the range of {2#} "
     "(are "
     "its coordinates in mm, and in those of the reflector?)",
     "Station bei {0} mm, {1} von allem, was der Reflektor erreicht; erwartet: innerhalb der Reichweite von {2} (sind "
     "ihre Koordinaten in mm und die des Reflektors?)"},
    {"found the travel of {0=} {1#} to {2#}, expected its lower end and then its higher one",
     "Weg von {0} {1} bis {2}; erwartet: erst das untere, dann das obere Ende"},
    {"found the unknown dialect {0=}, expected one of {1=}", "unbekannte Steuerung {0}; erwartet: eine von {1}"},
    {"found two files {0=}, expected one", "zwei Dateien {0}; erwartet: eine"},
    {"found {0#} different point, expected 6 or more: the station has 3 coordinates and the zero of the lengths is "
     "unknown too",
     "{0} verschiedener Punkt; erwartet: 6 oder mehr: Die Station hat 3 Koordinaten, und auch der Nullpunkt der "
     "Längen ist unbekannt"},
    {"found {0#} different points, expected 6 or more: the station has 3 coordinates and the zero of the lengths is "
     "unknown too",
     "{0} verschiedene Punkte; erwartet: 6 oder mehr: Die Station hat 3 Koordinaten, und auch der Nullpunkt der "
     "Längen ist unbekannt"},
    {"found {0#} of them, expected one of X, Y and Z each", "{0} Stück; erwartet: je eine von X, Y und Z"},
    {"found {0#} points for the station location, expected {1#} to {2#}",
     "{0} Punkte für die Stationsbestimmung; erwartet: {1} bis {2}"},
    {"found {0#} readings in all lines, expected at most {1#}",
     "{0} Messwerte in allen Linien; erwartet: höchstens {1}"},
    {"found {0#} trials for each of {1#} lines, expected at most {2#} in all",
     "{0} Versuche für jede von {1} Linien; erwartet: höchstens {2} insgesamt"},
    {"found {0=} for {1=}, expected a whole number from 1", "{0} für {1}; erwartet: eine ganze Zahl ab 1"},
    {"found {0=} with {1#} values, expected {2}", "{0} mit {1} Werten; erwartet: {2}"},
    {"found {0=}, expected a length above 0 mm", "{0}; erwartet: eine Länge über 0 mm"},
    {"found {0=}, expected equal or corner", "{0}; erwartet: equal oder corner"},
    {"found {0=}, expected periods above 0", "{0}; erwartet: Perioden über 0"},
    {"found {0}, expected true or false", "{0}; erwartet: true oder false"},
    {"lines: {0}", "Linien: {0}"},
    {"machine_sigma_um: {0}", "machine_sigma_um: {0}"},
    {"obstacles: {0}", "Hindernisse: {0}"},
    {"one of the parameters {0=}", "einer der Kennwerte {0}"},
    {"one of {0=}", "eines von {0}"},
    {"periods_mm: {0}", "Perioden: {0}"},
    {"recording: found {0=}, which lengths do not have", "recording: {0}, was Längen nicht haben"},
    {"recording: found {0}, expected an object", "recording: {0}; erwartet: ein Objekt"},
    {"reversed: {0}", "reversed: {0}"},
    {"set: found {0=}, expected KEY=VALUE", "set: {0}; erwartet: SCHLÜSSEL=WERT"},
    {"three numbers [x, y, z]", "drei Zahlen [x, y, z]"},
    {"tolerances: {0}", "Grenzwerte: {0}"},
    {"turn_reflector: {0}", "turn_reflector: {0}"},
};

}  // namespace

const std::span<const Phrase> german_tracking_requests{tracking_requests_rows};

}  // namespace axiometry::language
