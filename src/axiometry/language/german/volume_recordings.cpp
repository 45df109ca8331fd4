// SPDX-License-Identifier: Apache-2.0
// Lengths of a volumetric calibration out of several files and continuous recordings.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase volume_recordings_rows[] = {
    {"Found", "Gefunden"},
    {"Lengths out of continuous recordings are means over the rests that were matched to the points of the "
     "plan.",
     "Längen aus fortlaufenden Aufzeichnungen sind Mittel über die Stillstände, die den Punkten des Plans "
     "zugeordnet wurden."},
    {"Part of the plan", "Teil des Plans"},
    {"Plan", "Plan"},
    {"continuous recording", "fortlaufende Aufzeichnung"},
    {"found a continuous recording, expected the plan that was driven beside it (--plan), or a table of "
     "lengths",
     "eine fortlaufende Aufzeichnung; erwartet: daneben der Plan, der gefahren wurde (--plan), oder eine "
     "Tabelle von Längen"},
    {"found a datum or a zero for lengths, expected none: their dead path is not known",
     "ein Bezug oder eine Null für Längen; erwartet: keine, ihre Totstrecke ist nicht bekannt"},
    {"found a length at point {0#} of part {1#} (station {2=}, tool {3=}) again, which {4} has too, "
     "expected each once",
     "eine Länge an Punkt {0} von Teil {1} (Station {2}, Werkzeug {3}) noch einmal, die auch {4} hat; "
     "erwartet: jede einmal"},
    {"found a plan of {0#} parts, expected the one that is measured: --part 1 to {1#}",
     "ein Plan mit {0} Teilen; erwartet: der, der gemessen wird: --part 1 bis {1}"},
    {"found a plan without points, expected at least one", "ein Plan ohne Punkte; erwartet: mindestens einer"},
    {"found lengths of part {0#} (station {1=}, tool {2=}), which {3} has too, expected each part in one "
     "file; where a recording goes on with a part that another began, say the part of each (--parts)",
     "Längen von Teil {0} (Station {1}, Werkzeug {2}), die auch {3} hat; erwartet: jeder Teil in einer "
     "Datei; wo eine Aufzeichnung einen Teil fortsetzt, den eine andere begann, ist der Teil einer jeden "
     "anzugeben (--parts)"},
    {"found lengths of station {0} with tool {1} again, which {2} has too, expected each station with each "
     "tool in one file",
     "Längen der Station {0} mit Werkzeug {1} noch einmal, die auch {2} hat; erwartet: jede Station mit "
     "jedem Werkzeug in einer Datei"},
    {"found neither a machine nor a plan, expected --machine or --plan",
     "weder eine Maschine noch ein Plan; erwartet: --machine oder --plan"},
    {"found no file of lengths, expected at least one", "keine Datei mit Längen; erwartet: mindestens eine"},
    {"found no length for any of the {0#} points of {1} in {2#} standstill",
     "keine Länge für einen der {0} Punkte von {1} in {2} Stillstand"},
    {"found no length for any of the {0#} points of {1} in {2#} standstills",
     "keine Länge für einen der {0} Punkte von {1} in {2} Stillständen"},
    {"found no point in {0}, expected at least one", "kein Punkt in {0}; erwartet: mindestens einer"},
    {"found part {0#} asked for, expected 1 to {1#}: a run for each station and tool",
     "Teil {0} verlangt; erwartet: 1 bis {1}, ein Lauf für jede Station mit jedem Werkzeug"},
    {"found parts for {0#} recordings and one more recording, expected as many",
     "Teile für {0} Aufzeichnungen und eine weitere Aufzeichnung; erwartet: gleich viele"},
    {"found parts for {0#} recordings and {1#} recordings, expected as many",
     "Teile für {0} Aufzeichnungen und {1} Aufzeichnungen; erwartet: gleich viele"},
    {"found recordings asked for without a plan, expected the ways of one (--plan)",
     "Aufzeichnungen ohne Plan verlangt; erwartet: die Wege eines Plans (--plan)"},
    {"found {0#} of {1#} lengths of station {2} with tool {3} at the points of {4}, expected them at those "
     "of their own part: station or tool are named wrongly",
     "{0} von {1} Längen der Station {2} mit Werkzeug {3} an den Punkten von {4}; erwartet: an denen ihres "
     "eigenen Teils; Station oder Werkzeug sind falsch benannt"},
    {"found {0#} standstill that fits {1} about as well as {2}, expected those of one: say which part it is "
     "(--parts), if it is one of this plan at all",
     "{0} Stillstand, der zu {1} etwa so gut passt wie zu {2}; erwartet: die eines Teils; welcher es ist, ist "
     "anzugeben (--parts), falls es überhaupt einer dieses Plans ist"},
    {"found {0#} standstill that fits {1} far better, expected those of {2}",
     "{0} Stillstand, der weit besser zu {1} passt; erwartet: die von {2}"},
    {"found {0#} standstills that fit {1} about as well as {2}, expected those of one: say which part it "
     "is (--parts), if it is one of this plan at all",
     "{0} Stillstände, die zu {1} etwa so gut passen wie zu {2}; erwartet: die eines Teils; welcher es "
     "ist, ist anzugeben (--parts), falls es überhaupt einer dieses Plans ist"},
    {"found {0#} standstills that fit {1} far better, expected those of {2}",
     "{0} Stillstände, die weit besser zu {1} passen; erwartet: die von {2}"},
    {"found {0}, expected the number of a part from 1, or the first and the last of several as 3-5",
     "{0}; erwartet: die Nummer eines Teils ab 1, oder die erste und die letzte von mehreren wie 3-5"},
    {"no lengths of part {0#} (station {1=}, tool {2=}), which the plan has",
     "keine Längen von Teil {0} (Station {1}, Werkzeug {2}), den der Plan hat"},
    {"part {0#} (station {1=}, tool {2=})", "Teil {0} (Station {1}, Werkzeug {2})"},
    {"part {0#} (station {1=}, tool {2=}): a continuous recording of {3#} samples gave {4#} of {5#} "
     "lengths",
     "Teil {0} (Station {1}, Werkzeug {2}): Eine fortlaufende Aufzeichnung von {3} Abtastwerten ergab {4} "
     "von {5} Längen"},
    {"parts {0#} to {1#}", "Teile {0} bis {1}"},
    {"parts {0#} to {1#}: a continuous recording of {2#} samples gave {3#} of {4#} lengths",
     "Teile {0} bis {1}: Eine fortlaufende Aufzeichnung von {2} Abtastwerten ergab {3} von {4} Längen"},
    {"recording {0=}: {1}", "Aufzeichnung {0}: {1}"},
    {"table", "Tabelle"},
    {"the machine of {0} is not in all that of {1}: the former was used",
     "die Maschine von {0} ist nicht in allem die von {1}: Die erste wurde verwendet"},
    {"{0#} files", "{0} Dateien"},
    {"{0#} of {1#} lengths of station {2=} with tool {3=} are at no point that the plan has for them",
     "{0} von {1} Längen der Station {2} mit Werkzeug {3} liegen an keinem Punkt, den der Plan für sie hat"},
};

}  // namespace

const std::span<const Phrase> german_volume_recordings = volume_recordings_rows;

}  // namespace axiometry::language
