// SPDX-License-Identifier: Apache-2.0
// Plans of volumetric calibrations, and what requests about them are refused for.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase volume_plan_rows[] = {
    {"1 station leaves little to see a wrong one by; four or more are usual",
     "1 Station lässt kaum erkennen, ob eine falsch ist; vier oder mehr sind üblich"},
    {"A run is one program: one station with one tool. Between programs the instrument is moved or the "
     "tool changed. Where the beam is lost the program stops until it is found again, and another segment "
     "begins.",
     "Ein Durchlauf ist ein Programm: eine Station mit einem Werkzeug. Zwischen Programmen wird das "
     "Gerät umgestellt oder das Werkzeug gewechselt. Wo der Strahl verloren geht, hält das Programm an, "
     "bis er wiedergefunden ist, und ein weiterer Abschnitt beginnt."},
    {"All 21 errors over the positions of X, Y and Z", "Alle 21 Abweichungen über den Positionen von X, Y und Z"},
    {"Beam lost", "Strahl verloren"},
    {"Beckhoff TwinCAT CNC TF5280 and ISG kernels", "Beckhoff TwinCAT CNC TF5280 und ISG-Kerne"},
    {"First point", "Erster Punkt"},
    {"From where the axes stand to the centre of the reflector.",
     "Von der Stelle der Achsen zur Mitte des Reflektors."},
    {"In the coordinates of the reflector. The instrument need not stand there exactly: where it stood "
     "comes out of the lengths.",
     "In den Koordinaten des Reflektors. Das Gerät muss dort nicht genau stehen: Wo es stand, folgt aus "
     "den Längen."},
    {"Positioning of each axis alone", "Positionieren jeder Achse allein"},
    {"Reach of the reflector with all tools, and {0#} station.",
     "Reichweite des Reflektors mit allen Werkzeugen, und {0} Station."},
    {"Reach of the reflector with all tools, and {0#} stations.",
     "Reichweite des Reflektors mit allen Werkzeugen, und {0} Stationen."},
    {"Read the findings before the plan is measured.", "Vor der Messung die Feststellungen lesen."},
    {"Run number", "Nummer des Laufs"},
    {"Standard uncertainties (k = 1), from the uncertainties that are stated of the instrument and the "
     "machine.",
     "Standardunsicherheiten (k = 1), aus den Unsicherheiten, die von Gerät und Maschine angegeben sind."},
    {"Tool point, {0=}", "Werkzeugpunkt, {0}"},
    {"What the lengths will tell", "Was die Längen bestimmen werden"},
    {"found a line of which the readings do not tell all errors, expected one that they tell: see the "
     "findings of the result",
     "eine Linie, von der die Messwerte nicht alle Abweichungen bestimmen; erwartet: eine, die sie "
     "bestimmen: siehe die Feststellungen des Ergebnisses"},
    {"found files lengths that are not numbered one after another, expected lengths, lengths-2, …",
     "Dateien lengths, die nicht fortlaufend nummeriert sind; erwartet: lengths, lengths-2, …"},
    {"found no form, expected one with the files lengths and machine",
     "kein Formular; erwartet: eines mit den Dateien lengths und machine"},
    {"found no plan, expected one", "kein Plan; erwartet: einer"},
    {"found no point that the instrument sees from any station, expected some: are the stations given in "
     "the machine's coordinates, and where does the reflector look?",
     "kein Punkt, den das Gerät von einer Station sieht; erwartet: einige: Sind die Stationen in den "
     "Koordinaten der Maschine angegeben, und wohin blickt der Reflektor?"},
    {"found no result, expected one", "kein Ergebnis; erwartet: eines"},
    {"found no tool that both results have with the same name and offset, expected at least one",
     "kein Werkzeug, das beide Ergebnisse mit gleichem Namen und Versatz haben; erwartet: wenigstens eines"},
    {"found no {0=}, expected that of a result", "kein Eintrag {0}; erwartet: der eines Ergebnisses"},
    {"found no {0=}, expected the result of a volumetric calibration",
     "kein Eintrag {0}; erwartet: das Ergebnis einer volumetrischen Kalibrierung"},
    {"found reversed lengths in tables alone, expected them of a continuous recording",
     "umgekehrte Längen nur in Tabellen; erwartet: in einer fortlaufenden Aufzeichnung"},
    {"found that the readings do not tell the error of the tool point with this tool, expected all of it: "
     "a control would take a number that nobody measured",
     "die Messwerte bestimmen die Abweichung des Werkzeugpunkts mit diesem Werkzeug nicht; erwartet: ganz "
     "bestimmt: Eine Steuerung nähme eine Zahl, die niemand gemessen hat"},
    {"found that the readings do not tell {0=}, expected all 21 errors: a control would take a number that "
     "nobody measured",
     "die Messwerte bestimmen {0} nicht; erwartet: alle 21 Abweichungen: Eine Steuerung nähme eine Zahl, "
     "die niemand gemessen hat"},
    {"found the part {0=} in the form, expected the files lengths, machine and plan, and options",
     "Teil {0} im Formular; erwartet: die Dateien lengths, machine und plan sowie options"},
    {"found two results whose travels do not overlap, expected two of one machine: before and after",
     "zwei Ergebnisse, deren Wege sich nicht überschneiden; erwartet: zwei einer Maschine: vorher und "
     "nachher"},
    {"found {0#} coefficients, expected at most {1#}", "{0} Koeffizienten; erwartet: höchstens {1}"},
    {"found {0#} files of lengths, expected at most {1#}", "{0} Dateien mit Längen; erwartet: höchstens {1}"},
    {"found {0#} obstacles, expected at most {1#}", "{0} Hindernisse; erwartet: höchstens {1}"},
    {"found {0#} points in all runs, expected at most {1#}",
     "{0} Punkte in allen Durchläufen; erwartet: höchstens {1}"},
    {"found {0#} segments, expected at most {1#}", "{0} Abschnitte; erwartet: höchstens {1}"},
    {"found {0#} stations with a tool, expected at most {1#}",
     "{0} Stationen mit einem Werkzeug; erwartet: höchstens {1}"},
    {"found {0#} stations, expected at most {1#}", "{0} Stationen; erwartet: höchstens {1}"},
    {"found {0#} tools, expected at most {1#}", "{0} Werkzeuge; erwartet: höchstens {1}"},
    {"u = {0#} µm, at most {1#} µm", "u = {0} µm, höchstens {1} µm"},
    {"{0#} of 21 errors will be told by {1#} lengths", "{0} von 21 Abweichungen werden durch {1} Längen bestimmt"},
    {"{0=}: found ends that fall, expected the lower one first", "{0}: fallende Enden; erwartet: das untere zuerst"},
};

}  // namespace

const std::span<const Phrase> german_volume_plan = volume_plan_rows;

}  // namespace axiometry::language
