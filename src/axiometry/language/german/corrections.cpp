// SPDX-License-Identifier: Apache-2.0
// Corrections of readings, and where air and temperatures came from.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase corrections_rows[] = {
    {"Air humidity", "Luftfeuchte"},
    {"Air pressure", "Luftdruck"},
    {"Air temperature", "Lufttemperatur"},
    {"Calibrated positions at 20 °C", "Kalibrierte Positionen bei 20\u00a0°C"},
    {"Calibrated positions of the artefact (Annex D)", "Kalibrierte Positionen des Prüfkörpers (Anhang D)"},
    {"Carbon dioxide", "Kohlendioxid"},
    {"Course of the test", "Ablauf der Prüfung"},
    {"Datum", "Bezugspunkt"},
    {"Dead path", "Totstrecke"},
    {"Drift over the test", "Drift über die Prüfung"},
    {"Edlén, Birch and Downs 1994", "Edlén, Birch und Downs 1994"},
    {"Equation", "Gleichung"},
    {"Estimate", "Schätzung"},
    {"Expansion of the artefact", "Dehnung des Prüfkörpers"},
    {"Expansion of the equipment", "Dehnung des Messmittels"},
    {"Expansion of the machine", "Dehnung der Maschine"},
    {"Gain", "Verstärkung"},
    {"Gain of the sensor", "Verstärkung des Sensors"},
    {"Index assumed by the instrument", "Vom Messgerät angenommene Brechzahl"},
    {"Nominal differential expansion", "Nominelle Differenzdehnung"},
    {"Readings corrected by this program: {0}", "Messwerte durch dieses Programm korrigiert: {0}"},
    {"Refractive index of air", "Brechzahl der Luft"},
    {"Sign of the readings", "Vorzeichen der Messwerte"},
    {"Standard uncertainty over the test", "Standardunsicherheit über die Prüfung"},
    {"Vacuum wavelength", "Vakuumwellenlänge"},
    {"What was reversed", "Was umgekehrt wurde"},
    {"by this program from start and end temperatures (see Provenance)",
     "durch dieses Programm aus Temperaturen am Anfang und am Ende (siehe Herkunft)"},
    {"calibrated less indicated position, both from the first one",
     "kalibrierte minus angezeigte Position, beide von der ersten an"},
    {"calibrated positions of the artefact (Annex D)", "kalibrierte Positionen des Prüfkörpers (Anhang D)"},
    {"dead path", "Totstrecke"},
    {"dead path ({0=})", "Totstrecke ({0})"},
    {"drift", "Drift"},
    {"found neither the times of the readings nor a cycle that tells their order, expected one of them to estimate a "
     "drift",
     "weder die Zeiten der Messwerte noch ein Zyklus, der ihre Reihenfolge nennt; erwartet: eines von beiden, um eine "
     "Drift zu schätzen"},
    {"least squares of a straight line in time, a constant per target and direction",
     "Ausgleichsgerade über der Zeit, eine Konstante je Zielposition und Richtung"},
    {"nominal differential expansion", "nominelle Differenzdehnung"},
    {"none: the readings were already corrected for it", "keine: die Messwerte waren schon darum korrigiert"},
    {"not known: neither times nor the cycle tell the order of the readings",
     "nicht bekannt: Weder Zeiten noch der Zyklus nennen die Reihenfolge der Messwerte"},
    {"readings equally far apart in the order of the pilgrim cycle",
     "zeitlich gleich weit entfernten Messwerten in der Reihenfolge des Pilgerschrittzyklus"},
    {"readings equally far apart in the order of the standard cycle",
     "zeitlich gleich weit entfernten Messwerten in der Reihenfolge des Normzyklus"},
    {"readings equally far apart in the order of the standard cycle, their own not being known",
     "zeitlich gleich weit entfernten Messwerten in der Reihenfolge des Normzyklus, da ihre eigene nicht bekannt ist"},
    {"readings equally far apart in the order of the step cycle",
     "zeitlich gleich weit entfernten Messwerten in der Reihenfolge des Stufenzyklus"},
    {"readings equally far apart in the order of the {0} cycle",
     "zeitlich gleich weit entfernten Messwerten in der Reihenfolge des Zyklus ({0})"},
    {"refractive index of air", "Brechzahl der Luft"},
    {"refractive index of air ({0=})", "Brechzahl der Luft ({0})"},
    {"the dead path", "die Totstrecke"},
    {"the deviations; displayed positions rise with the targets",
     "die Abweichungen; angezeigte Positionen steigen mit den Zielpositionen"},
    {"the displayed positions, which fall as the targets rise",
     "die angezeigten Positionen, die fallen, wenn die Zielpositionen steigen"},
    {"the times of the readings", "den Zeiten der Messwerte"},
    {"{0#} at the start, {1#} at the end", "{0} am Anfang, {1} am Ende"},
    {"{0#}, assumed", "{0}, angenommen"},
    {"{0#}, beam longer at higher positions", "{0}, Strahl bei höheren Positionen länger"},
    {"{0#}, beam shorter at higher positions", "{0}, Strahl bei höheren Positionen kürzer"},
    {"{0#}, read at the end only and taken as constant", "{0}, nur am Ende abgelesen und als konstant angenommen"},
    {"{0#}, read at the start only and taken as constant", "{0}, nur am Anfang abgelesen und als konstant angenommen"},
    {"{0#}, {1#} at the start, {2#} at the end", "{0}, {1} am Anfang, {2} am Ende"},
    {"{0#}, {1#} at the start, {2#} at the end (mean of {3#} sensors)",
     "{0}, {1} am Anfang, {2} am Ende (Mittel von {3} Sensoren)"},
};

}  // namespace

const std::span<const Phrase> german_corrections{corrections_rows};

}  // namespace axiometry::language
