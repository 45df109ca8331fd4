// SPDX-License-Identifier: Apache-2.0
// What is refused of stations: to be located, to be measured from, of angles and ranges.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase station_refusals_rows[] = {
    {"a better station to be suggested", "der Wunsch nach einer besseren Station"},
    {"a rule for diagonals from the station", "eine Regel für Diagonalen von der Station aus"},
    {"a safe radius about the station", "ein Sicherheitsradius um die Station"},
    {"are points and stations exchanged?", "sind Punkte und Stationen vertauscht?"},
    {"found a located station for a plan whose interferometer is aligned with each line, expected none",
     "eine bestimmte Station für einen Plan, dessen Interferometer auf jede Linie ausgerichtet wird; erwartet: keine"},
    {"found a station farther than 1e9 mm, expected one at the machine",
     "Station weiter als 1e9 mm entfernt; erwartet: eine an der Maschine"},
    {"found a station that is not finite, expected numbers in mm",
     "eine nicht endliche Station; erwartet: Zahlen in mm"},
    {"found a station that should not be used as it is: {0}; expected one without a serious finding, or its "
     "coordinates by hand, as {1=}",
     "eine Station, die so nicht verwendet werden sollte: {0}; erwartet: eine ohne ernste Feststellung, oder ihre "
     "Koordinaten von Hand, als {1}"},
    {"found a station that should not be used as it is; expected one without a serious finding, or its coordinates by "
     "hand, as {0=}",
     "eine Station, die so nicht verwendet werden sollte; erwartet: eine ohne ernste Feststellung, oder ihre "
     "Koordinaten von Hand, als {0}"},
    {"found all {0#} nominal points of station {1=} at one place, expected different ones",
     "alle {0} Sollpunkte der Station {1} an einem Ort; erwartet: verschiedene"},
    {"found an approximate station that is not finite, expected three numbers in mm",
     "eine nicht endliche ungefähre Station; erwartet: drei Zahlen in mm"},
    {"found an instrument of station {0=}, which the files do not have",
     "Messgerät der Station {0}, die in den Dateien nicht vorkommt"},
    {"found fewer than three points off one line that station {0=} sees and that have nominal places, expected three "
     "or more",
     "weniger als drei Punkte mit Sollpunkt, nicht auf einer Geraden, die Station {0} sieht; erwartet: drei oder mehr"},
    {"found fewer than three points off one line that station {0=} shares with those placed before, expected three or "
     "more",
     "weniger als drei Punkte, nicht auf einer Geraden, die Station {0} mit den schon bestimmten gemeinsam hat; "
     "erwartet: drei oder mehr"},
    {"found lengths of line {0=} that fall where the reflector recedes from the station, expected them to grow: the "
     "instrument counts the other way (--reversed), or these are the lengths of another plan",
     "Längen der Linie {0}, die abnehmen, wo der Reflektor sich von der Station entfernt; erwartet: dass sie zunehmen: "
     "Das Messgerät zählt andersherum (--reversed), oder dies sind die Längen eines anderen Plans"},
    {"found lengths of station {0=} that change by more than their points are apart in {1#} of {2#} places (by {3#} "
     "over {4#} before reading {5#}), expected less",
     "Längen der Station {0}, die sich an {1} von {2} Stellen um mehr ändern, als ihre Punkte auseinanderliegen (um "
     "{3} über {4} vor Messwert {5}); erwartet: weniger"},
    {"found lengths of station {0=} that leave {1#} (root mean square) to the nominal points from the place that fits "
     "best, expected a few tenths",
     "Längen der Station {0}, die vom bestpassenden Ort aus {1} (quadratisches Mittel) zu den Sollpunkten übrig "
     "lassen; erwartet: wenige Zehntel"},
    {"found line {0=} running past the station ({1#} mm beside it, next to it at position {2#}), expected all targets "
     "on one side of the station",
     "Linie {0}, die an der Station vorbeiführt ({1} mm neben ihr, am nächsten bei Position {2}); erwartet: alle "
     "Zielpositionen auf einer Seite der Station"},
    {"found more than {0#} points, expected fewer to locate a station by",
     "mehr als {0} Punkte; erwartet: weniger, um eine Station zu bestimmen"},
    {"found no angles, expected them of one station at least; lengths alone are for axiometry tracking multilaterate",
     "keine Winkel; erwartet: von mindestens einer Station; Längen allein sind für axiometry tracking multilaterate"},
    {"found no choice of {0#} points that tells the station (best condition {1#}), expected travels that are no plane "
     "through the station",
     "keine Auswahl von {0} Punkten, die die Station bestimmt (beste Kondition {1}); erwartet: Verfahrwege, die keine "
     "Ebene durch die Station sind"},
    {"found no points that tell the station, expected travels in three directions",
     "keine Punkte, die die Station bestimmen; erwartet: Verfahrwege in drei Richtungen"},
    {"found no reading of station {0=}", "kein Messwert der Station {0}"},
    {"found no readings, expected lengths of points from stations",
     "keine Messwerte; erwartet: Längen von Stationen zu Punkten"},
    {"found no station near which the lengths fit, expected at least one",
     "keine Station, in deren Nähe die Längen passen; erwartet: mindestens eine"},
    {"found no station, expected its place or the file of a located one",
     "keine Station; erwartet: ihr Ort oder die Datei einer bestimmten"},
    {"found no station, expected its place or the file of a located one: only diagonals of the travels need none",
     "keine Station; erwartet: ihr Ort oder die Datei einer bestimmten: Nur Diagonalen der Verfahrwege brauchen keine"},
    {"found point {0=} without angles, and no station that sees three nominal places off one line, expected one of "
     "them",
     "Punkt {0} ohne Winkel, und keine Station, die drei Sollpunkte nicht auf einer Geraden sieht; erwartet: eines von "
     "beiden"},
    {"found reading {0#} (station {1=}, point {2=}) that looks away from where the point comes out, expected angles "
     "within 90° of it: one of the readings of this point is wrong",
     "Messwert {0} (Station {1}, Punkt {2}), der von dem Ort wegblickt, an dem sich der Punkt ergibt; erwartet: Winkel "
     "innerhalb von 90° dazu: Einer der Messwerte dieses Punkts ist falsch"},
    {"found reading {0#} (station {1=}, point {2=}) that looks away from where the point comes out, expected angles "
     "within 90° of it: one of the readings of this point, or its nominal place, is wrong",
     "Messwert {0} (Station {1}, Punkt {2}), der von dem Ort wegblickt, an dem sich der Punkt ergibt; erwartet: Winkel "
     "innerhalb von 90° dazu: Einer der Messwerte dieses Punkts, oder sein Sollpunkt, ist falsch"},
    {"found reading {0#} of point {1#} from station {2#}, expected one of {3#} points and {4#} stations",
     "Messwert {0} von Punkt {1} aus Station {2}; erwartet: einer von {3} Punkten und {4} Stationen"},
    {"found readings of point {0=} that leave it undetermined, expected angles, or lengths from three stations off one "
     "line with it",
     "Messwerte von Punkt {0}, die ihn unbestimmt lassen; erwartet: Winkel, oder Längen von drei Stationen, die nicht "
     "mit ihm auf einer Geraden liegen"},
    {"found readings that leave {0#} direction of the stations undetermined beyond position and orientation, expected "
     "more points that several stations see, off one line",
     "Messwerte, die außer Lage und Orientierung {0} Richtung der Stationen unbestimmt lassen; erwartet: mehr Punkte, "
     "die mehrere Stationen sehen und die nicht auf einer Geraden liegen"},
    {"found readings that leave {0#} directions of the stations undetermined beyond position and orientation, expected "
     "more points that several stations see, off one line",
     "Messwerte, die außer Lage und Orientierung {0} Richtungen der Stationen unbestimmt lassen; erwartet: mehr "
     "Punkte, die mehrere Stationen sehen und die nicht auf einer Geraden liegen"},
    {"found station {0#} within 1 mm of point {1=}, expected it away from all points",
     "Station {0} weniger als 1 mm von Punkt {1} entfernt; erwartet: abseits aller Punkte"},
    {"found station {0=} in a second file, expected each in one: another name where the instrument was moved",
     "Station {0} in einer zweiten Datei; erwartet: jede in einer: ein anderer Name, wo das Messgerät umgestellt "
     "wurde"},
    {"found target {0#} of line {1=} {2#} mm from the station, expected at least {3#} mm",
     "Zielposition {0} der Linie {1} {2} mm von der Station; erwartet: mindestens {3} mm"},
    {"found the coordinate {0#} of the station, expected at most 1e9 mm",
     "Koordinate {0} der Station; erwartet: höchstens 1e9 mm"},
    {"found the length {0=} at a station with angles, expected the distance from the instrument, above 0",
     "Länge {0} an einer Station mit Winkeln; erwartet: der Abstand vom Messgerät, über 0"},
    {"found the length {0=} mm in reading {1#} (station {2=}, point {3=}), expected a finite length",
     "Länge {0} mm in Messwert {1} (Station {2}, Punkt {3}); erwartet: eine endliche Länge"},
    {"found the station at {0=}, expected finite coordinates within {1#} mm",
     "Station bei {0}; erwartet: endliche Koordinaten innerhalb von {1} mm"},
    {"found the station {0#} mm from the obstacle {1=}, expected it {2#} mm outside at least",
     "Station {0} mm vom Hindernis {1} entfernt; erwartet: mindestens {2} mm außerhalb"},
    {"found two instruments of all stations, expected one", "zwei Messgeräte aller Stationen; erwartet: eines"},
    {"found two instruments of station {0=}, expected one", "zwei Messgeräte der Station {0}; erwartet: eines"},
    {"found {0#} point in one plane with all stations that see them (the first is {1=}), expected a station off it: "
     "across the plane they stay undetermined",
     "{0} Punkt in einer Ebene mit allen Stationen, die ihn sehen (der erste ist {1}); erwartet: eine Station "
     "außerhalb: quer zur Ebene bleibt er unbestimmt"},
    {"found {0#} point seen by fewer than {1#} stations ({2=}), expected {3#} or more for each: leave such points out",
     "{0} Punkt, der von weniger als {1} Stationen aus gesehen wird ({2}); erwartet: {3} oder mehr für jeden: solche "
     "Punkte weglassen"},
    {"found {0#} points and {1#} stations whose lengths leave {2#} direction undetermined beyond position and "
     "orientation, expected more points or stations elsewhere",
     "{0} Punkte und {1} Stationen, deren Längen außer Lage und Orientierung {2} Richtung unbestimmt lassen; erwartet: "
     "mehr Punkte oder Stationen an anderen Orten"},
    {"found {0#} points and {1#} stations whose lengths leave {2#} direction undetermined beyond position, orientation "
     "and size, expected more points or stations elsewhere",
     "{0} Punkte und {1} Stationen, deren Längen außer Lage, Orientierung und Größe {2} Richtung unbestimmt lassen; "
     "erwartet: mehr Punkte oder Stationen an anderen Orten"},
    {"found {0#} points and {1#} stations whose lengths leave {2#} directions undetermined beyond position and "
     "orientation, expected more points or stations elsewhere",
     "{0} Punkte und {1} Stationen, deren Längen außer Lage und Orientierung {2} Richtungen unbestimmt lassen; "
     "erwartet: mehr Punkte oder Stationen an anderen Orten"},
    {"found {0#} points and {1#} stations whose lengths leave {2#} directions undetermined beyond position, "
     "orientation and size, expected more points or stations elsewhere",
     "{0} Punkte und {1} Stationen, deren Längen außer Lage, Orientierung und Größe {2} Richtungen unbestimmt lassen; "
     "erwartet: mehr Punkte oder Stationen an anderen Orten"},
    {"found {0#} points from {1#} stations: {2#} equations for {3#} unknowns, expected at least as many",
     "{0} Punkte von {1} Stationen aus: {2} Gleichungen für {3} Unbekannte; erwartet: mindestens ebenso viele"},
    {"found {0#} points in one plane with all stations that see them (the first is {1=}), expected a station off it: "
     "across the plane they stay undetermined",
     "{0} Punkte in einer Ebene mit allen Stationen, die sie sehen (der erste ist {1}); erwartet: eine Station "
     "außerhalb: quer zur Ebene bleiben sie unbestimmt"},
    {"found {0#} points seen by fewer than {1#} stations ({2=}), expected {3#} or more for each: leave such points out",
     "{0} Punkte, die von weniger als {1} Stationen aus gesehen werden ({2}); erwartet: {3} oder mehr für jeden: "
     "solche Punkte weglassen"},
    {"found {0#} reading of station {1=} in {2#} segment, expected at least {3#}",
     "{0} Messwert der Station {1} in {2} Segment; erwartet: mindestens {3}"},
    {"found {0#} reading of station {1=} in {2#} segments, expected at least {3#}",
     "{0} Messwert der Station {1} in {2} Segmenten; erwartet: mindestens {3}"},
    {"found {0#} readings of station {1=} in {2#} segment, expected at least {3#}",
     "{0} Messwerte der Station {1} in {2} Segment; erwartet: mindestens {3}"},
    {"found {0#} readings of station {1=} in {2#} segments, expected at least {3#}",
     "{0} Messwerte der Station {1} in {2} Segmenten; erwartet: mindestens {3}"},
    {"found {0#} station, expected at least {1#}: with fewer no number of points is enough",
     "{0} Station; erwartet: mindestens {1}: Mit weniger genügt keine Anzahl von Punkten"},
    {"found {0#} stations on one line within {1#} mm, expected stations around the points: {2#} directions stay "
     "undetermined",
     "{0} Stationen auf einer Geraden, auf {1} mm; erwartet: Stationen um die Punkte herum: {2} Richtungen bleiben "
     "unbestimmt"},
    {"found {0#} stations on one plane within {1#} mm, expected one well off it or {2#} stations: {3#} direction stays "
     "undetermined beyond position and orientation",
     "{0} Stationen auf einer Ebene, auf {1} mm; erwartet: eine weit neben ihr oder {2} Stationen: {3} Richtung bleibt "
     "außer Lage und Orientierung unbestimmt"},
    {"found {0#} stations on one plane within {1#} mm, expected one well off it or {2#} stations: {3#} directions stay "
     "undetermined beyond position and orientation",
     "{0} Stationen auf einer Ebene, auf {1} mm; erwartet: eine weit neben ihr oder {2} Stationen: {3} Richtungen "
     "bleiben außer Lage und Orientierung unbestimmt"},
    {"found {0#} stations with {1#} segments and {2#} points, expected at most {3#} unknowns of stations (here {4#})",
     "{0} Stationen mit {1} Segmenten und {2} Punkten; erwartet: höchstens {3} Unbekannte der Stationen (hier {4})"},
    {"found {0#} stations with {1#} unknowns, expected no more than {2#} with {3#}",
     "{0} Stationen mit {1} Unbekannten; erwartet: höchstens {2} mit {3}"},
    {"found {0#} stations, expected 1 to {1#}", "{0} Stationen; erwartet: 1 bis {1}"},
    {"found {0#} stations, expected at least {1#}: with fewer no number of points is enough",
     "{0} Stationen; erwartet: mindestens {1}: Mit weniger genügt keine Anzahl von Punkten"},
    {"found {0} at the top, expected an object with the station",
     "{0} auf oberster Ebene; erwartet: ein Objekt mit der Station"},
    {"found {0} without a station, expected none: the interferometer is aligned with each diagonal",
     "{0} ohne Station; erwartet: keine Angabe davon, denn das Interferometer wird auf jede Diagonale ausgerichtet"},
    {"no direction leads from the station to a corner of the travels",
     "keine Richtung führt von der Station zu einer Ecke der Verfahrwege"},
    {"no place fits the lengths of station {0=}", "kein Ort passt zu den Längen der Station {0}"},
    {"reading {0#} (station {1=}, point {2=}) is farthest from the others",
     "Messwert {0} (Station {1}, Punkt {2}) ist am weitesten von den anderen entfernt"},
    {"{0#} points are the least for {1#} stations that see all of them",
     "mindestens {0} Punkte sind nötig bei {1} Stationen, die alle sehen"},
};

}  // namespace

const std::span<const Phrase> german_station_refusals = station_refusals_rows;

}  // namespace axiometry::language
