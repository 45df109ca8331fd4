// SPDX-License-Identifier: Apache-2.0
// Calibrations in the archive: what is refused.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase calibrations_rows[] = {
    {"calibration", "Kalibrierung"},
    {"curves: {0}", "curves: {0}"},
    {"drift: {0}", "drift: {0}"},
    {"find_outliers: {0}", "find_outliers: {0}"},
    {"found a calibration without a title, expected one", "Kalibrierung ohne Titel; erwartet: ein Titel"},
    {"found a calibration without files, expected what it was evaluated from",
     "Kalibrierung ohne Dateien; erwartet: das, woraus sie ausgewertet wurde"},
    {"found a {0} whose figures cannot be read, expected them as they were written",
     "{0}, deren Werte nicht lesbar sind; erwartet: wie sie geschrieben wurden"},
    {"found a {0} whose files cannot be read, expected them as they were written",
     "{0}, deren Dateien nicht lesbar sind; erwartet: wie sie geschrieben wurden"},
    {"found an instrument without its version, expected both or none",
     "Messmittel ohne seine Version; erwartet: beides oder keines"},
    {"found another kind or other files for calibration {0#}, expected those that it was kept with",
     "andere Art oder andere Dateien für Kalibrierung {0}; erwartet: die, mit denen sie behalten wurde"},
    {"found calibration {0#} in the lists already, expected it not to be",
     "Kalibrierung {0} steht schon in den Listen"},
    {"found calibration {0#} withdrawn already, expected it not to be", "Kalibrierung {0} ist schon zurückgezogen"},
    {"found calibration {0#} withdrawn, expected one that is not: reinstate it first",
     "Kalibrierung {0} ist zurückgezogen; erwartet: eine, die es nicht ist; erst wieder aufnehmen"},
    {"found calibrations of the kinds {0=} and {1=}, expected two of the same",
     "Kalibrierungen der Arten {0} und {1}; erwartet: zwei derselben Art"},
    {"found measured_on = {0=}, expected a date such as 2026-01-31",
     "measured_on = {0}; erwartet: ein Datum wie 2026-01-31"},
    {"found no bytes with the SHA-256 {0=}, expected those of the result",
     "keine Bytes mit SHA-256 {0}; erwartet: die des Ergebnisses"},
    {"found no bytes with the SHA-256 {0=}, expected those of {1=}",
     "keine Bytes mit SHA-256 {0}; erwartet: die von {1}"},
    {"found no calibration {0=}", "keine Kalibrierung {0}"},
    {"found no calibration {0=} in version {1#}, expected one", "keine Version {1} der Kalibrierung {0}"},
    {"found no calibration {0=}, expected one", "keine Kalibrierung {0}"},
    {"found no file {0=} of calibration {1#}", "keine Datei {0} der Kalibrierung {1}"},
    {"found no file {0=}, expected one", "keine Datei {0}; erwartet: eine"},
    {"found no form, expected one with kind and files", "kein Formular; erwartet: eines mit kind und Dateien"},
    {"found no other calibration to compare with, expected with=NUMBER",
     "keine andere Kalibrierung zum Vergleichen; erwartet: with=NUMMER"},
    {"found other figures for calibration {0#} in version {1#} than {2=} kept with it, expected the same: evaluate it "
     "again, which makes a new version",
     "andere Werte für Kalibrierung {0} in Version {1}, als {2} mit ihr behalten hat; erwartet: dieselben. Eine neue "
     "Auswertung ergibt eine neue Version"},
    {"found the figure {0=} without a number, expected one", "Wert {0} ohne Zahl; erwartet: eine"},
    {"found the file {0=} as {1=}, expected {2=}", "Datei {0} als {1}; erwartet: {2}"},
    {"found the kind of calibration {0=}, expected lines, volumetric, straightness, angles or squareness",
     "Art der Kalibrierung {0}; erwartet: lines, volumetric, straightness, angles oder squareness"},
    {"found the kind {0=}, expected lines, volumetric, straightness, angles or squareness",
     "Art {0}; erwartet: lines, volumetric, straightness, angles oder squareness"},
    {"found the options {0=}, expected a JSON object", "Optionen {0}; erwartet: ein JSON-Objekt"},
    {"found the order {0=}, expected received, measured or title",
     "Reihenfolge {0}; erwartet: received, measured oder title"},
    {"found the part {0=} in the form, expected kind, about, options and files",
     "Teil {0} im Formular; erwartet: kind, about, options und Dateien"},
    {"found {0#} of them, expected one number, or three for X, Y, Z",
     "{0} Stück; erwartet: eine Zahl, oder drei für X, Y, Z"},
    {"found {0=} of {1#} bytes, expected at most {2#}", "{0} mit {1} Bytes; erwartet: höchstens {2}"},
    {"found {0=}, expected one of {1=}", "{0}; erwartet: eines von {1}"},
    {"reversal: {0}", "reversal: {0}"},
    {"spans: {0}", "spans: {0}"},
};

}  // namespace

const std::span<const Phrase> german_calibrations = calibrations_rows;

}  // namespace axiometry::language
