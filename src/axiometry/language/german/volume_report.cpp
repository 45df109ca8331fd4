// SPDX-License-Identifier: Apache-2.0
// What reports of volumetric calibrations draw, predict and export, and what tables from them are told of.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase volume_report_rows[] = {
    {"Added to the commanded position: a positive value moves the axis in the positive direction.",
     "Zur befohlenen Position addiert: Ein positiver Wert bewegt die Achse in positiver Richtung."},
    {"At / mm", "Bei / mm"},
    {"B of the measured test, which the errors do not hold",
     "B der gemessenen Prüfung, in den Abweichungen nicht enthalten"},
    {"B, reversal value", "B, Umkehrspanne"},
    {"Breaks of the beam found", "Gefundene Strahlunterbrechungen"},
    {"Compensation of the volume", "Kompensation des Volumens"},
    {"Covariances are multiplied by χ²/ν where that is above 1.",
     "Kovarianzen sind mit χ²/ν multipliziert, wo das über 1 liegt."},
    {"Curves", "Kurven"},
    {"Deviation / µm", "Abweichung / µm"},
    {"Deviations", "Abweichungen"},
    {"Deviations along the line, as predicted", "Vorhergesagte Abweichungen entlang der Linie"},
    {"Diagonals, predicted", "Diagonalen, vorhergesagt"},
    {"Difference over u", "Differenz durch u"},
    {"Direction that is corrected", "Richtung, die korrigiert wird"},
    {"Directions of which the lengths say nothing", "Richtungen, über die die Längen nichts sagen"},
    {"Displacement", "Verlagerung"},
    {"Displacement of the tool point along the line through the middle of the volume, without the table and with it, "
     "with the band of its uncertainty.",
     "Verlagerung des Werkzeugpunkts entlang der Linie durch die Mitte des Arbeitsraums, ohne die Tabelle und mit ihr, "
     "mit dem Band ihrer Unsicherheit."},
    {"Displacement on the line", "Verlagerung auf der Linie"},
    {"Displacement on the line from {0#} to {1#} µm, as predicted from the 21 errors",
     "Verlagerung auf der Linie von {0} auf {1} µm, wie aus den 21 Abweichungen vorhergesagt"},
    {"Displacement on the line without and with the table", "Verlagerung auf der Linie ohne und mit Tabelle"},
    {"Displacement on the line, range", "Verlagerung auf der Linie, Spannweite"},
    {"E of the mean of both directions, without reversal", "E des Mittelwerts beider Richtungen, ohne Umkehrspanne"},
    {"E, bidirectional systematic deviation", "E, beidseitige systematische Abweichung"},
    {"Each station has a place of its own with each tool, so that a wrong offset of a tool enters as a lever alone.",
     "Jede Station hat mit jedem Werkzeug einen eigenen Ort, sodass ein falscher Versatz eines Werkzeugs nur als "
     "Hebel eingeht."},
    {"Error motions", "Bewegungsabweichungen"},
    {"Error motions of {0=}", "Bewegungsabweichungen von {0}"},
    {"Error motions over the travel", "Bewegungsabweichungen über dem Verfahrweg"},
    {"Error of the tool point", "Abweichung des Werkzeugpunkts"},
    {"Error of the tool point on the planes through the middle of the volume",
     "Abweichung des Werkzeugpunkts in den Ebenen durch die Mitte des Arbeitsraums"},
    {"Error of the tool point over the volume", "Abweichung des Werkzeugpunkts im Arbeitsraum"},
    {"Error of the tool point, 95 % below", "Fehler des Werkzeugpunkts, 95 % darunter"},
    {"Error of the tool point, largest", "Fehler des Werkzeugpunkts, größter"},
    {"Error of the tool point, mean", "Fehler des Werkzeugpunkts, Mittel"},
    {"Errors", "Abweichungen"},
    {"Errors can cancel along a diagonal: a small E of one proves little alone.",
     "Abweichungen können sich entlang einer Diagonale aufheben: Ein kleines E einer einzigen beweist allein wenig."},
    {"Errors of a machine measured singly", "Einzeln gemessene Abweichungen einer Maschine"},
    {"From X; Y; Z / mm", "Von X; Y; Z / mm"},
    {"From the 21 errors of a machine", "Aus den 21 Abweichungen einer Maschine"},
    {"Functional points of the axes", "Funktionspunkte der Achsen"},
    {"Functional points of the axes, x; y; z in mm", "Funktionspunkte der Achsen, x; y; z in mm"},
    {"ISO 230-1, names of errors", "ISO 230-1, Namen der Abweichungen"},
    {"ISO 230-1:2012, names of errors", "ISO 230-1:2012, Namen der Abweichungen"},
    {"In the axes of the machine, without constants and without the slope of straightness, rotations taken out of "
     "displacements by their levers. Uncertainties (k = 1): scatter of the means and, where it was stated, the "
     "instrument, independent from one position to the next.",
     "In den Achsen der Maschine, ohne Konstanten und ohne die Steigung der Geradheit, Drehungen über ihre Hebel aus "
     "den Verschiebungen herausgerechnet. Unsicherheiten (k = 1): Streuung der Mittelwerte und, wo angegeben, "
     "Messgerät, von Position zu Position unabhängig."},
    {"Kinematic chain", "Kinematische Kette"},
    {"Legendre polynomials, degree: {0=}", "Legendre-Polynome, Grad: {0}"},
    {"Lengths", "Längen"},
    {"Less the mean of all: the zero of a deviation curve is a convention. u: standard uncertainty (k = 1).",
     "Abzüglich des Mittels aller: Die Null einer Abweichungskurve ist eine Übereinkunft. u: Standardunsicherheit (k = "
     "1)."},
    {"Mean / µm", "Mittel / µm"},
    {"Measured / µm", "Gemessen / µm"},
    {"Measured test", "Gemessene Prüfung"},
    {"Measured ↑ / µm", "Gemessen ↑ / µm"},
    {"Measured ↓ / µm", "Gemessen ↓ / µm"},
    {"Measurement", "Messung"},
    {"Nothing tells by what the directions differ of some errors on {0}: E is that of the mean of both directions "
     "there, without reversal.",
     "Nichts sagt, worin sich die Richtungen einiger Abweichungen auf {0} unterscheiden: E ist dort das des "
     "Mittelwerts beider Richtungen, ohne Umkehrspanne."},
    {"Over a grid of the travel that was observed, the largest between its nodes too. Without rigid motion: less the "
     "displacement and rotation of the whole machine that fit best, which the place of a workpiece takes away. 95 % of "
     "the grid have no more than the last column.",
     "Auf einem Gitter über dem beobachteten Verfahrweg, die größte auch zwischen seinen Knoten. Ohne "
     "Starrkörperbewegung: abzüglich der bestpassenden "
     "Verlagerung und Verdrehung der ganzen Maschine, die die Lage eines Werkstücks aufnimmt. 95 % des Gitters haben "
     "höchstens den Wert der letzten Spalte."},
    {"Positions of axis", "Positionen der Achse"},
    {"Predicted from the 21 errors, along the diagonals of the travel that was observed: E is that of the mean of both "
     "directions, and the bidirectional systematic deviation of ISO 230-6 holds reversal beside it. P and N name the "
     "ends of the axes, P the larger; of a face the third axis stands in the middle.",
     "Aus den 21 Abweichungen vorhergesagt, längs der Diagonalen des erfassten Verfahrwegs: E ist das des Mittelwerts "
     "beider Richtungen, und die beidseitige systematische Abweichung der ISO 230-6 enthält daneben die Umkehrspanne. "
     "P und N benennen die Enden der Achsen, P das größere; bei einer Fläche steht die dritte Achse in der Mitte."},
    {"Predicted from the 21 errors, along the diagonals of the travel that was observed: E is the bidirectional "
     "systematic deviation that ISO 230-6 would show. P and N name the ends of the axes, P the larger; of a face the "
     "third axis stands in the middle.",
     "Aus den 21 Abweichungen vorhergesagt, entlang der Diagonalen des beobachteten Verfahrwegs: E ist die beidseitige "
     "systematische Abweichung, die ISO 230-6 zeigen würde. P und N nennen die Enden der Achsen, P das größere; bei "
     "einer Fläche steht die dritte Achse in der Mitte."},
    {"Predicted from the 21 errors, not measured: only another calibration proves it.",
     "Aus den 21 Abweichungen vorhergesagt, nicht gemessen: Erst eine weitere Kalibrierung beweist es."},
    {"Prediction", "Vorhersage"},
    {"Probability of as much by chance", "Wahrscheinlichkeit, dass es Zufall ist"},
    {"Range and u are those of the mean of both directions; ↑ − ↓ is what these differ by, – where nothing tells it.",
     "Spannweite und u sind die des Mittelwerts beider Richtungen; ↑ − ↓ ist, worin sich diese unterscheiden, – wo "
     "nichts es sagt."},
    {"Range or value", "Spannweite oder Wert"},
    {"Reading, in the order of measurement", "Messwert in der Reihenfolge der Messung"},
    {"Readings set aside", "Ausgesonderte Messwerte"},
    {"Residuals", "Residuen"},
    {"Residuals of the lengths", "Residuen der Längen"},
    {"Rotation", "Verdrehung"},
    {"Slope", "Steigung"},
    {"Slope / (µm/m)", "Steigung / (µm/m)"},
    {"Spread", "Spannweite"},
    {"Squareness", "Rechtwinkligkeit"},
    {"Standard uncertainties (k = 1). The mean of each function over its range is 0, and the best straight line of "
     "straightness is level.",
     "Standardunsicherheiten (k = 1). Das Mittel jeder Funktion über ihrem Bereich ist 0, und die Ausgleichsgerade der "
     "Geradheit liegt waagerecht."},
    {"Station and tool", "Station und Werkzeug"},
    {"Table", "Tabelle"},
    {"Test predicted from the 21 errors", "Aus den 21 Abweichungen vorhergesagte Prüfung"},
    {"The 21 errors of the machine", "Die 21 Abweichungen der Maschine"},
    {"The errors, the places of the stations and the dead paths are those that minimise the weighted squares of the "
     "residuals of all lengths.",
     "Die Abweichungen, die Orte der Stationen und die Totstrecken sind die, bei denen die gewichteten Quadrate der "
     "Residuen aller Längen am kleinsten sind."},
    {"The line runs through the middle of the volume that was observed, both directions of approach. The error of the "
     "tool point is over that volume, without rigid motion, with this table alone.",
     "Die Linie läuft durch die Mitte des beobachteten Volumens, in beiden Anfahrrichtungen. Der Fehler des "
     "Werkzeugpunkts gilt über dieses Volumen, ohne Starrkörperbewegung, mit dieser Tabelle allein."},
    {"The picture is of the tool {0=}, as found.", "Das Bild gilt für das Werkzeug {0}, wie gefunden."},
    {"The range of a curve counts, not its height: the table does nothing at the reference point of the axis, and what "
     "is the same everywhere the zero of the workpiece takes up.",
     "Es zählt die Spannweite einer Kurve, nicht ihre Höhe: Am Referenzpunkt der Achse tut die Tabelle nichts, und was "
     "überall gleich ist, nimmt der Nullpunkt des Werkstücks auf."},
    {"The straightness of an axis is that of the tool point for the chain {0=}, with each axis' functional point as "
     "stated in the "
     "result; for another chain it would be other numbers.",
     "Die Geradheit ist die des Werkzeugpunkts für die Kette {0} mit dem im Ergebnis genannten Bezugspunkt jeder "
     "Achse; für eine andere Kette wären es andere Zahlen."},
    {"The three displacements and the three rotations of the axis over its position, with the bands in which they lie.",
     "Die drei Verlagerungen und die drei Verdrehungen der Achse über ihrer Position, mit den Bändern, in denen sie "
     "liegen."},
    {"The volume", "Der Arbeitsraum"},
    {"Three planes of the volume: colours show how large the error of the tool point is, arrows where it points within "
     "the plane.",
     "Drei Ebenen des Arbeitsraums: Farben zeigen, wie groß die Abweichung des Werkzeugpunkts ist, Pfeile, wohin sie "
     "in der Ebene zeigt."},
    {"To X; Y; Z / mm", "Nach X; Y; Z / mm"},
    {"To the squares of the residuals are added those of how far curves bend, over what the findings say of it: both "
     "together are least.",
     "Zu den Quadraten der Residuen kommen die der Biegung der Kurven, bezogen auf das, was die Feststellungen dazu "
     "sagen: "
     "Beide zusammen sind am kleinsten."},
    {"Tool", "Werkzeug"},
    {"Unknowns", "Unbekannte"},
    {"Value / µrad", "Wert / µrad"},
    {"Volumetric calibration", "Volumetrische Kalibrierung"},
    {"What a test along the line would show, with the band in which it lies.",
     "Was eine Prüfung entlang der Linie zeigen würde, mit dem Band, in dem es liegt."},
    {"What is left of each length, in the order of measurement, over the positions of the axes and by station.",
     "Was von jeder Länge übrig bleibt: in der Reihenfolge der Messung, über den Positionen der Achsen und nach "
     "Station."},
    {"What remains", "Was bleibt"},
    {"With the table / µm", "Mit der Tabelle / µm"},
    {"With the table ↑ / µm", "Mit der Tabelle ↑ / µm"},
    {"With the table ↓ / µm", "Mit der Tabelle ↓ / µm"},
    {"Without / µm", "Ohne / µm"},
    {"Without ↑ / µm", "Ohne ↑ / µm"},
    {"Without ↓ / µm", "Ohne ↓ / µm"},
    {"Y to X", "Y zu X"},
    {"Z to X", "Z zu X"},
    {"Z to Y", "Z zu Y"},
    {"as found", "wie gefunden"},
    {"cubic B-splines, spans: {0=}", "kubische B-Splines, Abschnitte: {0}"},
    {"error", "Abweichung"},
    {"found no target that was approached twice from the same side: what of the deviations is scatter nobody can tell, "
     "and the table corrects it too",
     "keine Zielposition, die zweimal von derselben Seite angefahren wurde: Was von den Abweichungen Streuung ist, "
     "kann niemand sagen, und die Tabelle korrigiert sie mit"},
    {"found positions of a table for {0=}, expected none: it has one straight line everywhere",
     "Positionen einer Tabelle für {0} gefunden, keine erwartet: Sie hat überall eine Gerade"},
    {"found that a re-test would show E of {0#} (median) where the axis has {1#}: no table of these points makes the "
     "axis better; no table is written",
     "eine Nachprüfung würde E von {0} (Median) zeigen, wo die Achse {1} hat: Keine Tabelle mit diesen Punkten macht "
     "die Achse besser; keine Tabelle wird geschrieben"},
    {"found that a re-test would show E of {0#} (median) where the axis has {1#}: one curve for both directions leaves "
     "the reversal error, up to {2#}; no table is written",
     "eine Nachprüfung würde E von {0} (Median) zeigen, wo die Achse {1} hat: Eine Kurve für beide Richtungen lässt "
     "die Umkehrspanne, bis zu {2}; keine Tabelle wird geschrieben"},
    {"found {0#} targets where a test after ISO 230-2 has {1#} at least: what the axis does between them nobody "
     "measured",
     "{0} Zielpositionen, wo eine Prüfung nach ISO 230-2 mindestens {1} hat: Was die Achse zwischen ihnen tut, hat "
     "niemand gemessen"},
    {"largest u", "größtes u"},
    {"largest ↑ − ↓", "größtes ↑ − ↓"},
    {"mean of both directions", "Mittel beider Richtungen"},
    {"moving down", "Bewegung abwärts"},
    {"moving up", "Bewegung aufwärts"},
    {"not measured: {0=}; what depends on them has no number",
     "nicht gemessen: {0}; was davon abhängt, hat keinen Wert"},
    {"not told", "nicht bestimmt"},
    {"not told: not all errors of this line are known by direction",
     "nicht bestimmt: nicht alle Abweichungen dieser Linie sind nach der Richtung bekannt"},
    {"not told: the errors have no directions", "nicht bestimmt: die Abweichungen kennen keine Richtung"},
    {"nothing tells by what the directions differ of {0} on this line: what is predicted is the mean of both, without "
     "reversal",
     "nichts sagt, worin sich die Richtungen von {0} auf dieser Linie unterscheiden: Vorhergesagt ist der Mittelwert "
     "beider, ohne Umkehrspanne"},
    {"nothing tells by what the directions differ of {0}: the table holds the mean of both on this line, and what they "
     "differ by stays beside what remains here",
     "nichts sagt, worin sich die Richtungen von {0} unterscheiden: Die Tabelle enthält auf dieser Linie den "
     "Mittelwert beider, und worin sie sich unterscheiden, bleibt neben dem, was hier bleibt"},
    {"of many readings the central 95 % with their median, and the farthest",
     "von vielen Messwerten die mittleren 95 % mit ihrem Median, und die äußersten"},
    {"of the errors measured singly, from which this was made: {0}",
     "von den einzeln gemessenen Abweichungen, aus denen dies gemacht ist: {0}"},
    {"one count of the control is taken for 1 µm (--resolution), and many controls in inches count in 0.0001 inch "
     "(2.54 µm): where it is another amount, all that the table does is wrong in that proportion",
     "ein Zählschritt der Steuerung gilt als 1 µm (--resolution), und viele Steuerungen in Zoll zählen in 0,0001 Zoll "
     "(2,54 µm): Ist er ein anderer, so ist alles, was die Tabelle tut, in diesem Verhältnis falsch"},
    {"one count of the control is taken for 1 µm (--resolution): where it is another amount, all that the table does "
     "is wrong in that proportion",
     "ein Zählschritt der Steuerung gilt als 1 µm (--resolution): Ist er ein anderer, so ist alles, was die Tabelle "
     "tut, in diesem Verhältnis falsch"},
    {"one count of the control is taken for 1 ″ (--resolution), and many controls count in 0.001° (3.6 ″): where it is "
     "another amount, all that the table does is wrong in that proportion",
     "ein Zählschritt der Steuerung gilt als 1 ″ (--resolution), und viele Steuerungen zählen in 0,001° (3,6 ″): Ist "
     "er ein anderer, so ist alles, was die Tabelle tut, in diesem Verhältnis falsch"},
    {"pitch", "Nicken"},
    {"positioning", "Positionieren"},
    {"predicted", "vorhergesagt"},
    {"predicted ↑", "vorhergesagt ↑"},
    {"predicted ↓", "vorhergesagt ↓"},
    {"read in one direction alone, which is taken for the mean of both: {0=}",
     "nur in einer Richtung abgelesen, die als Mittelwert beider genommen wird: {0}"},
    {"roll", "Rollen"},
    {"root mean square of a station", "quadratisches Mittel einer Station"},
    {"rotation {0=} at {1#} mm", "Drehung {0} bei {1} mm"},
    {"set aside, at the edge where beyond it", "ausgesondert, außerhalb liegende am Rand"},
    {"straight lines between nodes, spans: {0#}", "Geraden zwischen Knoten, Abschnitte: {0}"},
    {"straightness", "Geradheit"},
    {"the best straight line of the six straightness functions is level: their slopes are squareness, or turn the "
     "whole machine",
     "die beste Gerade der sechs Geradheitsfunktionen liegt eben: Ihre Steigungen sind Rechtwinkligkeit oder "
     "drehen die ganze Maschine"},
    {"the comparison holds the uncertainty of the errors and the scatter of the test, but not what all readings of the "
     "test have in common, as its temperature or wavelength: that would appear as a slope",
     "der Vergleich enthält die Unsicherheit der Abweichungen und die Streuung der Prüfung, aber nicht, was alle "
     "Messwerte der Prüfung gemeinsam haben, wie Temperatur oder Wellenlänge: Das würde als Steigung erscheinen"},
    {"the directions of the measured test differ by up to {0#} at {1#}, which the errors do not hold: E of the test is "
     "{2#}, where {3#} is predicted for the mean of both directions",
     "die Richtungen der gemessenen Prüfung unterscheiden sich um bis zu {0} bei {1}, was die Abweichungen nicht "
     "enthalten: E der Prüfung ist {2}, wo {3} für den Mittelwert beider Richtungen vorhergesagt ist"},
    {"the file of the table has no comments: it does not say itself that the result it was made from should not be "
     "used",
     "die Datei der Tabelle hat keine Kommentare: Sie sagt nicht selbst, dass das Ergebnis, aus dem sie gemacht ist, "
     "nicht verwendet werden sollte"},
    {"the machine's zero", "der Nullpunkt der Maschine"},
    {"the mean of each of the 18 functions over its range is 0: constants are a place of the whole machine",
     "der Mittelwert jeder der 18 Funktionen über ihren Bereich ist 0: Konstanten sind ein Ort der ganzen Maschine"},
    {"the measured test agrees with the prediction but for what its directions differ by: χ² = {0#} with ν = {1#}; the "
     "largest difference is {2#} µm at {3#} mm, {4#} of its standard uncertainties",
     "die gemessene Prüfung stimmt bis auf den Unterschied ihrer Richtungen mit der Vorhersage überein: χ² = {0} mit ν "
     "= {1}; die größte Differenz ist {2} µm bei {3} mm, {4} ihrer Standardunsicherheiten"},
    {"the measured test agrees with the prediction: χ² = {0#} with ν = {1#}; the largest difference is {2#} µm at {3#} "
     "mm, {4#} of its standard uncertainties",
     "die gemessene Prüfung stimmt mit der Vorhersage überein: χ² = {0} mit ν = {1}; die größte Differenz ist {2} µm "
     "bei {3} mm, das {4}-fache ihrer Standardunsicherheit"},
    {"the measured test departs from the prediction by more than chance: χ² = {0#} with ν = {1#}; the largest "
     "difference is {2#} µm at {3#} mm, {4#} of its standard uncertainties",
     "die gemessene Prüfung weicht stärker als zufällig von der Vorhersage ab: χ² = {0} mit ν = {1}; die größte "
     "Differenz ist {2} µm bei {3} mm, das {4}-fache ihrer Standardunsicherheit"},
    {"the table goes from {0#} to {1#} mm, what was observed from {2#} to {3#} mm: beyond its ends the control holds "
     "the last value",
     "die Tabelle reicht von {0} bis {1} mm, das Beobachtete von {2} bis {3} mm: Jenseits ihrer Enden hält die "
     "Steuerung den letzten Wert"},
    {"the table goes from {0#} to {1#} mm, what was observed from {2#} to {3#} mm: over all of that the file holds the "
     "last value beyond its ends",
     "die Tabelle reicht von {0} bis {1} mm, das Beobachtete von {2} bis {3} mm: Über all das hält die Datei jenseits "
     "ihrer Enden den letzten Wert"},
    {"the table goes from {0#} to {1#} mm, what was observed from {2#} to {3#} mm: there it holds the value at the end "
     "of what was observed, which nobody measured",
     "die Tabelle reicht von {0} bis {1} mm, das Beobachtete von {2} bis {3} mm: Dort hält sie den Wert vom Ende des "
     "Beobachteten, den niemand gemessen hat"},
    {"the test states the tool point {0#}, and the tool {1=} has {2#}: where both are counted alike, this is the "
     "prediction of another point",
     "die Prüfung gibt den Werkzeugpunkt {0} an, und das Werkzeug {1} hat {2}: Wo beide gleich gezählt sind, ist dies "
     "die Vorhersage eines anderen Punkts"},
    {"what the directions of {0=} differ by is told only at the line where it was read: there it holds {1}, not read "
     "in both directions",
     "worin sich die Richtungen von {0} unterscheiden, ist nur auf der Linie bestimmt, auf der es abgelesen wurde: "
     "Dort enthält es {1}, nicht in beiden Richtungen abgelesen"},
    {"with the table", "mit Tabelle"},
    {"with the table ↑", "mit Tabelle ↑"},
    {"with the table ↓", "mit Tabelle ↓"},
    {"with {0#} of {1#} tools the readings do not tell the error of the tool point, and no number is given for it",
     "bei {0} von {1} Werkzeugen bestimmen die Messwerte die Abweichung des Werkzeugpunkts nicht, und dafür wird keine "
     "Zahl angegeben"},
    {"without rigid motion", "ohne Starrkörperbewegung"},
    {"without the table", "ohne Tabelle"},
    {"without the table ↑", "ohne Tabelle ↑"},
    {"without the table ↓", "ohne Tabelle ↓"},
    {"yaw", "Gieren"},
    {"{0#} of 21 errors found from {1#} lengths", "{0} von 21 Abweichungen aus {1} Längen gefunden"},
    {"{0#}, of which {1#} are of errors", "{0}, davon {1} der Abweichungen"},
    {"{0=} (lever {1#} mm)", "{0} (Hebel {1} mm)"},
    {"{0=} has no number: at its line it holds {1}, not measured",
     "{0} hat keinen Wert: Auf seiner Linie enthält es {1}, nicht gemessen"},
    {"{0=} has no number: its lines hold {1}, not measured",
     "{0} hat keinen Wert: Seine Linien enthalten {1}, nicht gemessen"},
    {"{0=} has no number: the errors of {1=} were read over different ranges, and without {2=} nothing tells over "
     "which "
     "the squareness was",
     "{0} hat keinen Wert: Die Abweichungen von {1} sind über verschiedene Bereiche abgelesen, und ohne {2} sagt "
     "nichts, "
     "über welchen die Rechtwinkligkeit gemessen ist"},
    {"{0=} is uncertain by {1#}, with everything else by {2#}, because nothing states in which direction an axis came "
     "to rest that has other rotations in each: {3}",
     "{0} ist um {1} unsicher, mit allem anderen um {2}, weil nichts angibt, in welcher Richtung eine Achse zum "
     "Stillstand kam, die in jeder andere Drehungen hat: {3}"},
    {"{0=} while {1=} moved", "{0} bei der Fahrt von {1}"},
    {"{0=}: no uncertainty of the instrument is stated: U does not hold it",
     "{0}: Keine Unsicherheit des Messgeräts angegeben: U enthält sie nicht"},
    {"{0=}: of one run of each direction, what these differ by is taken to be as uncertain as readings of the "
     "instrument that have nothing in common",
     "{0}: Bei einem Durchlauf je Richtung gilt, worin sich diese unterscheiden, als so unsicher wie Messwerte des "
     "Messgeräts, die nichts gemeinsam haben"},
    {"{0=}: only from {1#} to {2#} mm, where all its errors were read",
     "{0}: nur von {1} bis {2} mm, wo alle Abweichungen abgelesen sind"},
    {"{0=}: positions at the ends that were approached from one side alone are left out: {1}",
     "{0}: Positionen an den Enden, die nur von einer Seite angefahren wurden, sind weggelassen: {1}"},
    {"{0=}: readings between the {1#} nodes lie up to {2#} from the straight lines",
     "{0}: Messwerte zwischen den {1} Stützpunkten liegen bis zu {2} neben den Geraden"},
};

}  // namespace

const std::span<const Phrase> german_volume_report = volume_report_rows;

}  // namespace axiometry::language
