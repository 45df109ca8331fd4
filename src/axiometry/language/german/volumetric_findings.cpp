// SPDX-License-Identifier: Apache-2.0
// What lengths of a volumetric calibration tell, and why they are refused.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase volumetric_findings_rows[] = {
    {"all lengths have the same tool point, so that a rotation of an axis that nothing but the tool lies behind cannot "
     "be told from its straightness; three tools whose points form a triangle tell all (a short and a long one, and "
     "one beside them)",
     "alle Längen haben denselben Werkzeugpunkt, sodass eine Drehung einer Achse, hinter der nur das Werkzeug liegt, "
     "nicht von deren Geradheit zu unterscheiden ist; drei Werkzeuge, deren Punkte ein Dreieck bilden, bestimmen alles "
     "(ein kurzes, ein langes und eines daneben)"},
    {"all stations stand at nearly one height; one that stands higher or lower tells rotations about the horizontal "
     "axes better",
     "alle Stationen stehen auf fast einer Höhe; eine, die höher oder tiefer steht, bestimmt Drehungen um die "
     "waagerechten Achsen besser"},
    {"all stations stand within {0#} of one line, and no length changes where points turn about it; a station beside "
     "this line tells such turns, more points do not",
     "alle Stationen stehen innerhalb von {0} um eine Gerade, und keine Länge ändert sich, wo Punkte sich um diese "
     "drehen; eine Station neben dieser Geraden bestimmt solche Drehungen, mehr Punkte nicht"},
    {"all stations stand {0#} from where they were said to: they are stated in another frame than the positions of the "
     "axes, or tool offsets are wrong by it, of all tools alike or of one",
     "alle Stationen stehen um {0} neben dem angegebenen Ort: Sie sind in einem anderen Koordinatensystem angegeben "
     "als die Positionen der Achsen, oder Werkzeugversätze sind um dies falsch, alle gleich oder einer"},
    {"all tool points lie on one line, and a rotation about that line moves none of them; a tool beside it tells this "
     "rotation",
     "alle Werkzeugpunkte liegen auf einer Geraden, und eine Drehung um diese bewegt keinen von ihnen; ein Werkzeug "
     "daneben bestimmt diese Drehung"},
    {"all tool points lie within {0#} of one line, and were taken to lie on it: a rotation about that line moves none "
     "of them; a tool beside it tells this rotation",
     "alle Werkzeugpunkte liegen innerhalb von {0} um eine Gerade und gelten als auf ihr gelegen: Eine Drehung um "
     "diese bewegt keinen von ihnen; ein Werkzeug daneben bestimmt diese Drehung"},
    {"all tool points lie within {0#} of one, and were taken to lie there, so that a rotation of an axis that nothing "
     "but the tool lies behind cannot be told from its straightness; three tools whose points form a triangle tell all "
     "(a short and a long one, and one beside them)",
     "alle Werkzeugpunkte liegen innerhalb von {0} um einen und gelten als dort gelegen, sodass eine Drehung einer "
     "Achse, hinter der nur das Werkzeug liegt, nicht von deren Geradheit zu unterscheiden ist; drei Werkzeuge, deren "
     "Punkte ein Dreieck bilden, bestimmen alles (ein kurzes, ein langes und eines daneben)"},
    {"before {0} all lengths jump by {1#}: the beam was broken, and the lengths from there on have a dead path of "
     "their own",
     "vor {0} springen alle Längen um {1}: Der Strahl war unterbrochen, und die Längen ab dort haben eine eigene "
     "Totstrecke"},
    {"between {0} and {1} all lengths jump by {2#}: the beam was broken, and the lengths from there on have a dead "
     "path of their own; on which side of the break the one length between was measured cannot be told, and it is left "
     "out",
     "zwischen {0} und {1} springen alle Längen um {2}: Der Strahl war unterbrochen, und die Längen ab dort haben eine "
     "eigene Totstrecke; auf welcher Seite der Unterbrechung die eine Länge dazwischen gemessen wurde, lässt sich "
     "nicht sagen, und sie ist ausgelassen"},
    {"between {0} and {1} all lengths jump by {2#}: the beam was broken, and the lengths from there on have a dead "
     "path of their own; on which side of the break the {3#} lengths between were measured cannot be told, and they "
     "are left out",
     "zwischen {0} und {1} springen alle Längen um {2}: Der Strahl war unterbrochen, und die Längen ab dort haben eine "
     "eigene Totstrecke; auf welcher Seite der Unterbrechung die {3} Längen dazwischen gemessen wurden, lässt sich "
     "nicht sagen, und sie sind ausgelassen"},
    {"both directions of an axis differ: with a constant of each for each direction χ² falls from {0#} to {1#} for "
     "{2#} more unknowns, as chance has it once in ten thousand cases at most; most clearly {3=} differs, by {4#} "
     "between both directions of {5=}; what is stated of errors is of no direction, and reversal is to be asked for "
     "(constant)",
     "beide Richtungen einer Achse unterscheiden sich: mit einer Konstante jeder Abweichung für jede Richtung fällt χ² "
     "von {0} auf {1} bei {2} Unbekannten mehr, was der Zufall höchstens einmal in zehntausend Fällen bewirkt; am "
     "deutlichsten unterscheidet sich {3}, um {4} zwischen beiden Richtungen von {5}; was von Abweichungen angegeben "
     "wird, gilt für keine Richtung, und Umkehr ist zu verlangen (constant)"},
    {"curves are taken to be smooth, as the lengths of all let it appear: {0}",
     "die Kurven gelten als glatt, wie es die Längen aller erkennen lassen: {0}"},
    {"curves are taken to be smooth, as was stated: {0}", "die Kurven gelten als glatt, wie angegeben: {0}"},
    {"dead paths drift with time, by up to {0#} between breaks of the beam; a straight drift of each was taken out",
     "die Totstrecken driften mit der Zeit, um bis zu {0} zwischen Unterbrechungen des Strahls; von jeder ist eine "
     "gerade Drift abgezogen"},
    {"found Legendre polynomials that are to be smooth, expected b-spline or nodes: polynomials are as smooth as their "
     "degree",
     "Legendre-Polynome gefunden, die glatt sein sollen, erwartet b-spline oder nodes: Polynome sind so glatt wie ihr "
     "Grad"},
    {"found X at {0#} ({1}), expected it within its travel of {2#} to {3#}; are axes, signs or units mixed up?",
     "X bei {0} ({1}) gefunden, erwartet innerhalb des Verfahrwegs von {2} bis {3}; sind Achsen, Vorzeichen oder "
     "Einheiten vertauscht?"},
    {"found Y at {0#} ({1}), expected it within its travel of {2#} to {3#}; are axes, signs or units mixed up?",
     "Y bei {0} ({1}) gefunden, erwartet innerhalb des Verfahrwegs von {2} bis {3}; sind Achsen, Vorzeichen oder "
     "Einheiten vertauscht?"},
    {"found Z at {0#} ({1}), expected it within its travel of {2#} to {3#}; are axes, signs or units mixed up?",
     "Z bei {0} ({1}) gefunden, erwartet innerhalb des Verfahrwegs von {2} bis {3}; sind Achsen, Vorzeichen oder "
     "Einheiten vertauscht?"},
    {"found a smoothness of {0#}, expected {1#} to {2#} (µm, µrad)",
     "eine Glattheit von {0} gefunden, erwartet {1} bis {2} (µm, µrad)"},
    {"found all readings at one place of {0=}, expected them spread over its travel",
     "alle Messwerte an einem Ort von {0} gefunden, erwartet über den Verfahrweg verteilt"},
    {"found lengths of station {0=} with tool {1=} that fit when the lengths are read as inches, expected all numbers "
     "in mm, or their unit in the head",
     "Längen von Station {0} mit Werkzeug {1} gefunden, die passen, wenn die Längen als Zoll gelesen werden, erwartet "
     "alle Zahlen in mm oder ihre Einheit im Kopf"},
    {"found lengths of station {0=} with tool {1=} that fit when the lengths are read as m, expected all numbers in "
     "mm, or their unit in the head",
     "Längen von Station {0} mit Werkzeug {1} gefunden, die passen, wenn die Längen als m gelesen werden, erwartet "
     "alle Zahlen in mm oder ihre Einheit im Kopf"},
    {"found lengths of station {0=} with tool {1=} that fit when the lengths are read as µm, expected all numbers in "
     "mm, or their unit in the head",
     "Längen von Station {0} mit Werkzeug {1} gefunden, die passen, wenn die Längen als µm gelesen werden, erwartet "
     "alle Zahlen in mm oder ihre Einheit im Kopf"},
    {"found lengths of station {0=} with tool {1=} that fit when the positions and tools are read as inches, expected "
     "all numbers in mm, or their unit in the head",
     "Längen von Station {0} mit Werkzeug {1} gefunden, die passen, wenn Positionen und Werkzeuge als Zoll gelesen "
     "werden, erwartet alle Zahlen in mm oder ihre Einheit im Kopf"},
    {"found lengths with tool {0=}, expected a tool of the machine: {1=}",
     "Längen mit dem Werkzeug {0} gefunden, erwartet ein Werkzeug der Maschine: {1}"},
    {"found no errors and stations that fit the lengths in {0#} steps, expected lengths, tools and positions that "
     "belong together",
     "in {0} Schritten keine Abweichungen und Stationen gefunden, die zu den Längen passen, erwartet Längen, Werkzeuge "
     "und Positionen, die zusammengehören"},
    {"found {0#} length for {1#} unknowns, expected more lengths than unknowns: measure more points or ask for simpler "
     "curves",
     "{0} Länge für {1} Unbekannte gefunden, erwartet mehr Längen als Unbekannte: mehr Punkte messen oder einfachere "
     "Kurven verlangen"},
    {"found {0#} lengths for {1#} unknowns, expected more lengths than unknowns: measure more points or ask for "
     "simpler curves",
     "{0} Längen für {1} Unbekannte gefunden, erwartet mehr Längen als Unbekannte: mehr Punkte messen oder einfachere "
     "Kurven verlangen"},
    {"found {0=}, expected none, auto, or one or two numbers from 0.1 to 1000000 (µm, µrad)",
     "{0} gefunden, erwartet none, auto oder ein oder zwei Zahlen von 0.1 bis 1000000 (µm, µrad)"},
    {"from station {0=} only {1#} of {2#} points are in sight and in reach with tool {3=}: range, elevation, "
     "incidence, the safe radius or an obstacle hides the others",
     "von Station {0} sind nur {1} von {2} Punkten mit Werkzeug {3} sichtbar und erreichbar: Reichweite, Elevation, "
     "Einfall, der sichere Radius oder ein Hindernis verdecken die übrigen"},
    {"how smooth the curves are was still changing when the search for it ended: curves and their uncertainties may "
     "depend on where it ended, and another smoothness may be stated",
     "wie glatt die Kurven sind, änderte sich noch, als die Suche danach endete: Kurven und ihre Unsicherheiten können "
     "davon abhängen, wo sie endete; eine Glattheit kann stattdessen angegeben werden"},
    {"lengths from {0#} station leave ways in which the machine can bend without changing one of them; three stations "
     "are the least, four or more are better",
     "Längen von {0} Station lassen Verformungen der Maschine offen, die keine von ihnen ändern; drei Stationen sind "
     "das Mindeste, vier oder mehr sind besser"},
    {"lengths from {0#} stations leave ways in which the machine can bend without changing one of them; three stations "
     "are the least, four or more are better",
     "Längen von {0} Stationen lassen Verformungen der Maschine offen, die keine von ihnen ändern; drei Stationen sind "
     "das Mindeste, vier oder mehr sind besser"},
    {"line {0#} of station {1=} with tool {2=}", "Zeile {0} von Station {1} mit Werkzeug {2}"},
    {"more is told of {0} by the smoothness than by the lengths: by the lengths alone uncertainties would be up to "
     "{1#} times as large",
     "über {0} sagt die Glattheit mehr als die Längen: Aus den Längen allein wären die Unsicherheiten bis zu {1}-mal "
     "so groß"},
    {"no curve is told that could be smooth: the smoothness changes nothing",
     "von keiner Kurve, die glatt sein könnte, sagen die Längen etwas: Die Glattheit ändert nichts"},
    {"nobody said where stations {0=} stand, which have lengths, and of {1=}, whose places are stated, there are none: "
     "are they called otherwise? these places were not looked at",
     "für die Stationen {0}, von denen es Längen gibt, ist kein Ort angegeben, und von {1}, deren Orte angegeben sind, "
     "gibt es keine: Heißen sie anders? Diese Orte wurden nicht geprüft"},
    {"nobody said where stations {0=} stand, which have lengths: their places were not looked at",
     "für die Stationen {0}, von denen es Längen gibt, ist kein Ort angegeben: Ihre Orte wurden nicht geprüft"},
    {"nothing is said of an error that all lengths have in common, as of the wavelength in air or the temperature of "
     "the machine: it would appear in the slopes of EXX, EYY and EZZ, whose uncertainties do not hold it "
     "(scale_u_um_per_m in the machine's file)",
     "über einen Fehler, den alle Längen gemeinsam haben, etwa der Wellenlänge in Luft oder der Temperatur der "
     "Maschine, ist nichts gesagt: Er würde in den Steigungen von EXX, EYY und EZZ erscheinen, deren Unsicherheiten "
     "ihn nicht enthalten (scale_u_um_per_m in der Datei der Maschine)"},
    {"nothing tells in which direction axes had come to rest at {0#} length before their first move at a station with "
     "a tool, or where {1=} did not move at all: it counts as of the mean of both",
     "nichts sagt, in welcher Richtung Achsen bei {0} Länge vor ihrer ersten Bewegung an einer Station mit einem "
     "Werkzeug, oder wo {1} sich gar nicht bewegte, zur Ruhe gekommen waren: sie zählt als eine des Mittels beider "
     "Richtungen"},
    {"nothing tells in which direction axes had come to rest at {0#} length before their first move at a station with "
     "a tool: it counts as of the mean of both",
     "nichts sagt, in welcher Richtung Achsen bei {0} Länge vor ihrer ersten Bewegung an einer Station mit einem "
     "Werkzeug zur Ruhe gekommen waren: sie zählt als eine des Mittels beider Richtungen"},
    {"nothing tells in which direction axes had come to rest at {0#} length before their first move at a station with "
     "a tool: it is left out",
     "nichts sagt, in welcher Richtung Achsen bei {0} Länge vor ihrer ersten Bewegung an einer Station mit einem "
     "Werkzeug zur Ruhe gekommen waren: sie ist ausgelassen"},
    {"nothing tells in which direction axes had come to rest at {0#} lengths before their first move at a station with "
     "a tool, or where {1=} did not move at all: they count as of the mean of both",
     "nichts sagt, in welcher Richtung Achsen bei {0} Längen vor ihrer ersten Bewegung an einer Station mit einem "
     "Werkzeug, oder wo {1} sich gar nicht bewegte, zur Ruhe gekommen waren: sie zählen als solche des Mittels beider "
     "Richtungen"},
    {"nothing tells in which direction axes had come to rest at {0#} lengths before their first move at a station with "
     "a tool: they are left out",
     "nichts sagt, in welcher Richtung Achsen bei {0} Längen vor ihrer ersten Bewegung an einer Station mit einem "
     "Werkzeug zur Ruhe gekommen waren: sie sind ausgelassen"},
    {"nothing tells in which direction axes had come to rest at {0#} lengths before their first move at a station with "
     "a tool: they count as of the mean of both",
     "nichts sagt, in welcher Richtung Achsen bei {0} Längen vor ihrer ersten Bewegung an einer Station mit einem "
     "Werkzeug zur Ruhe gekommen waren: sie zählen als solche des Mittels beider Richtungen"},
    {"of displacements the smoothness draws {0=} the farthest towards a straight line, by about {1#}; uncertainties "
     "hold this only as far as the smoothness holds",
     "von den Verschiebungen zieht die Glattheit {0} am weitesten zu einer Geraden hin, um etwa {1}; die "
     "Unsicherheiten enthalten das nur, soweit die Glattheit zutrifft"},
    {"of rotations the smoothness draws {0=} the farthest towards a straight line, by about {1#}; uncertainties hold "
     "this only as far as the smoothness holds",
     "von den Drehungen zieht die Glattheit {0} am weitesten zu einer Geraden hin, um etwa {1}; die Unsicherheiten "
     "enthalten das nur, soweit die Glattheit zutrifft"},
    {"on {0#} way between points the beam is lost and must be found again, which begins a segment",
     "auf {0} Weg zwischen Punkten geht der Strahl verloren und muss neu gefunden werden, womit ein Segment beginnt"},
    {"on {0#} ways between points the beam is lost and must be found again, which begins a segment",
     "auf {0} Wegen zwischen Punkten geht der Strahl verloren und muss neu gefunden werden, womit ein Segment beginnt"},
    {"passed over the member {0=} of the machine's file", "das Element {0} der Datei der Maschine übergangen"},
    {"passed over the members {0=} of the machine's file", "die Elemente {0} der Datei der Maschine übergangen"},
    {"reading {0#} of station {1=} with tool {2=}", "Messwert {0} von Station {1} mit Werkzeug {2}"},
    {"readings of {0=} reach from {1#} to {2#} of a travel from {3#} to {4#}: curves are stated where readings are, "
     "and nothing is said of the rest",
     "die Messwerte von {0} reichen von {1} bis {2} bei einem Verfahrweg von {3} bis {4}: Kurven sind dort angegeben, "
     "wo Messwerte sind; über den Rest ist nichts gesagt"},
    {"residuals go with the direction in which axes came to rest, and these stations and tools do not tell which error "
     "differs between both directions, or of which axis: what is stated of errors is of no direction, and reversal is "
     "to be asked for (constant)",
     "die Residuen hängen an der Richtung, in der Achsen zur Ruhe kamen, und diese Stationen und Werkzeuge zeigen "
     "nicht, welche Abweichung sich zwischen beiden Richtungen unterscheidet, noch von welcher Achse: was von "
     "Abweichungen angegeben wird, gilt für keine Richtung, und Umkehr ist zu verlangen (constant)"},
    {"slopes of displacements change by no more than {0#} from one end of an axis to the other (standard deviation)",
     "Steigungen von Verschiebungen ändern sich von einem Ende einer Achse zum anderen um höchstens {0} "
     "(Standardabweichung)"},
    {"slopes of displacements change by {0#} from one end of an axis to the other (standard deviation)",
     "Steigungen von Verschiebungen ändern sich von einem Ende einer Achse zum anderen um {0} (Standardabweichung)"},
    {"slopes of rotations change by no more than {0#} from one end of an axis to the other (standard deviation)",
     "Steigungen von Drehungen ändern sich von einem Ende einer Achse zum anderen um höchstens {0} "
     "(Standardabweichung)"},
    {"slopes of rotations change by {0#} from one end of an axis to the other (standard deviation)",
     "Steigungen von Drehungen ändern sich von einem Ende einer Achse zum anderen um {0} (Standardabweichung)"},
    {"smoothness: {0}", "Glattheit: {0}"},
    {"station {0=} stands at {1#}, {2#} from where it was said to",
     "Station {0} steht bei {1}, {2} neben dem angegebenen Ort"},
    {"station {0=} stands where {1=} was said to, and {2=} where {3=} was: the names of both are exchanged in the "
     "lengths, or where they stand in the machine's file",
     "Station {0} steht, wo {1} stehen soll, und {2}, wo {3} stehen soll: Die Namen beider sind in den Längen "
     "vertauscht, oder ihre Orte in der Datei der Maschine"},
    {"station {0=} with tool {1=} stands about {2#} elsewhere in segment {3=} than in the others: the instrument was "
     "moved, or lengths of two set-ups or days are mixed",
     "Station {0} mit Werkzeug {1} steht im Segment {3} etwa {2} anderswo als in den übrigen: Das Messgerät wurde "
     "bewegt, oder Längen zweier Aufbauten oder Tage sind vermischt"},
    {"the axes seem longer, shorter or less square for some of the lengths than for others, most of all for station "
     "{0=} with tool {1=} in segment {2=}: machine or air were warmer or colder then, or lengths of two days are mixed",
     "die Achsen scheinen für einen Teil der Längen länger, kürzer oder weniger rechtwinklig als für die übrigen, am "
     "meisten für Station {0} mit Werkzeug {1} im Segment {2}: Maschine oder Luft waren dort wärmer oder kälter, oder "
     "Längen zweier Tage sind vermischt"},
    {"the axes seem longer, shorter or less square in later lengths of the same station and tool than in earlier ones, "
     "of one such pair or of several: the machine or the air became warmer or colder, lengths of two days are mixed, "
     "or both directions differ and all was measured forth and then back",
     "die Achsen scheinen in späteren Längen derselben Station mit demselben Werkzeug länger, kürzer oder weniger "
     "rechtwinklig als in früheren, bei einem solchen Paar oder bei mehreren: Maschine oder Luft wurden wärmer oder "
     "kälter, Längen zweier Tage sind vermischt, oder beide Richtungen unterscheiden sich und alles wurde hin und dann "
     "zurück gemessen"},
    {"the lengths do not tell {0}; {1}: no number is given for it",
     "die Längen bestimmen {0} nicht; {1}: dafür ist kein Wert angegeben"},
    {"the lengths do not tell {0}; {1}: no number is given for them",
     "die Längen bestimmen {0} nicht; {1}: dafür sind keine Werte angegeben"},
    {"the lengths fit axes in the order {0=} from the workpiece to the tool (χ²/ν = {1#}), not {2=} as the chain {3=} "
     "has it (χ²/ν = {4#})",
     "die Längen passen zu Achsen in der Reihenfolge {0} vom Werkstück zum Werkzeug (χ²/ν = {1}), nicht {2} wie in der "
     "Kette {3} (χ²/ν = {4})"},
    {"the lengths show that {0} bend farther than the smoothness allows, up to {1#} times as far: uncertainties may "
     "not hold the truth",
     "die Längen zeigen, dass sich {0} stärker biegen, als die Glattheit zulässt, bis zu {1}-mal so stark: Die "
     "Unsicherheiten enthalten die Wahrheit womöglich nicht"},
    {"the lengths show that {0} bends farther than the smoothness allows, up to {1#} times as far: uncertainties may "
     "not hold the truth",
     "die Längen zeigen, dass sich {0} stärker biegt, als die Glattheit zulässt, bis zu {1}-mal so stark: Die "
     "Unsicherheiten enthalten die Wahrheit womöglich nicht"},
    {"the names of stations {0=} and {1=} are exchanged in the lengths with tool {2=}, or in those with tool {3=}: "
     "exchanged once more, all stations tell the same difference of both offsets",
     "die Namen der Stationen {0} und {1} sind in den Längen mit Werkzeug {2} oder in denen mit Werkzeug {3} "
     "vertauscht: noch einmal getauscht, zeigen alle Stationen denselben Unterschied beider Versätze"},
    {"the number of stations and tools and the lines they stand on do not show why; coarser curves ask for less, and "
     "more points, approached from other directions, tell more",
     "aus der Anzahl der Stationen und Werkzeuge und den Geraden, auf denen sie stehen, geht nicht hervor, warum; "
     "gröbere Kurven verlangen weniger, und mehr Punkte, aus anderen Richtungen angefahren, bestimmen mehr"},
    {"the offset of tool {0=} less that of tool {1=} is {2#}, not {3#} as stated, as {4#} station shows",
     "der Versatz von Werkzeug {0} gegen den von Werkzeug {1} ist {2}, nicht {3} wie angegeben, wie {4} Station zeigt"},
    {"the offset of tool {0=} less that of tool {1=} is {2#}, not {3#} as stated, as {4#} station shows, as if {5}",
     "der Versatz von Werkzeug {0} gegen den von Werkzeug {1} ist {2}, nicht {3} wie angegeben, wie {4} Station zeigt, "
     "als ob {5}"},
    {"the offset of tool {0=} less that of tool {1=} is {2#}, not {3#} as stated, as {4#} stations show alike",
     "der Versatz von Werkzeug {0} gegen den von Werkzeug {1} ist {2}, nicht {3} wie angegeben, wie {4} Stationen "
     "übereinstimmend zeigen"},
    {"the offset of tool {0=} less that of tool {1=} is {2#}, not {3#} as stated, as {4#} stations show alike, as if "
     "{5}",
     "der Versatz von Werkzeug {0} gegen den von Werkzeug {1} ist {2}, nicht {3} wie angegeben, wie {4} Stationen "
     "übereinstimmend zeigen, als ob {5}"},
    {"the residuals are {0#} times as large as the uncertainties of instrument and machine allow (χ²/ν = {1#}): either "
     "these are stated too small, or the machine does something that 21 errors of its axes do not describe, as drift, "
     "play or bending under load, or its chain is another one, or its curves bend farther than they were taken to; all "
     "uncertainties were multiplied by {2#}",
     "die Residuen sind {0} mal so groß, wie die Unsicherheiten von Messgerät und Maschine erlauben (χ²/ν = {1}): "
     "Entweder sind diese zu klein angegeben, oder die Maschine tut etwas, das 21 Abweichungen ihrer Achsen nicht "
     "beschreiben, etwa Drift, Spiel oder Verformung unter Last, oder ihre Kette ist eine andere, oder ihre Kurven "
     "biegen sich stärker als angenommen; alle Unsicherheiten sind mit {2} multipliziert"},
    {"the residuals are {0#} times as large as the uncertainties of instrument and machine allow (χ²/ν = {1#}): either "
     "these are stated too small, or the machine does something that 21 errors of its axes do not describe, as drift, "
     "play or bending under load, or its chain is another one; all uncertainties were multiplied by {2#}",
     "die Residuen sind {0} mal so groß, wie die Unsicherheiten von Messgerät und Maschine erlauben (χ²/ν = {1}): "
     "Entweder sind diese zu klein angegeben, oder die Maschine tut etwas, das 21 Abweichungen ihrer Achsen nicht "
     "beschreiben, etwa Drift, Spiel oder Verformung unter Last, oder ihre Kette ist eine andere; alle Unsicherheiten "
     "sind mit {2} multipliziert"},
    {"the residuals are {0#} times what the uncertainties of instrument and machine let one expect: these are stated "
     "too large, and so are all uncertainties",
     "die Residuen sind {0} mal so groß, wie die Unsicherheiten von Messgerät und Maschine erwarten lassen: Diese sind "
     "zu groß angegeben, und damit alle Unsicherheiten"},
    {"the result from which this was made should not be used as it is: {0}",
     "das Ergebnis, aus dem dies gemacht ist, sollte nicht so verwendet werden: {0}"},
    {"the stations stand where they were said to if the names of {0=} and {1=} are exchanged, or if {2}",
     "die Stationen stehen am angegebenen Ort, wenn die Namen von {0} und {1} vertauscht sind oder wenn {2}"},
    {"the stations stand where they were said to only if {0}: axes or signs of the positions, or of the stations, are "
     "mixed up",
     "die Stationen stehen nur dann am angegebenen Ort, wenn {0}: Achsen oder Vorzeichen der Positionen oder der "
     "Stationen sind vertauscht"},
    {"the tool points do not form a triangle: add a longer tool and one beside it, for example {0=} and {1=} mm",
     "die Werkzeugpunkte bilden kein Dreieck: ein längeres Werkzeug und eines daneben hinzunehmen, zum Beispiel {0} "
     "und {1} mm"},
    {"the tool points lie within {0#} of one line, less than a twentieth of the {1#} that they are apart: rotations "
     "about this line are told by that lever alone, and a tool farther beside it would be moved by what they are wrong",
     "die Werkzeugpunkte liegen innerhalb von {0} um eine Gerade, weniger als ein Zwanzigstel der {1}, die sie "
     "auseinanderliegen: Drehungen um diese Gerade bestimmt dieser Hebel allein, und ein Werkzeug weiter neben ihr "
     "würde um das verschoben, was an ihnen falsch ist"},
    {"the tool points stand on one line: add a tool beside it, for example {0=} mm",
     "die Werkzeugpunkte liegen auf einer Geraden: ein Werkzeug daneben hinzunehmen, zum Beispiel {0} mm"},
    {"the travels of X, Y and Z are {0=}, {1=} and {2#}: are the numbers of the machine's file in inches? all of them "
     "are read as mm",
     "die Verfahrwege von X, Y und Z sind {0}, {1} und {2}: Sind die Zahlen der Datei der Maschine Zoll? Alle werden "
     "als mm gelesen"},
    {"these stations, tools and points will not tell {0=}; {1}",
     "diese Stationen, Werkzeuge und Punkte bestimmen {0} nicht; {1}"},
    {"what both directions differ by changes along an axis: with curves in place of constants χ² falls from {0#} to "
     "{1#} for {2#} more unknowns, as chance has it once in a thousand cases at most; what is stated of each direction "
     "is too certain, and reversal is to be asked for as curves",
     "worin sich beide Richtungen unterscheiden, ändert sich längs einer Achse: mit Kurven statt Konstanten fällt χ² "
     "von {0} auf {1} bei {2} Unbekannten mehr, was der Zufall höchstens einmal in tausend Fällen bewirkt; was von "
     "jeder Richtung angegeben wird, ist zu sicher, und Umkehr ist als Kurven zu verlangen"},
    {"what both directions differ by changes along {0=}, most clearly of {1=}: with curves in place of constants χ² "
     "falls from {2#} to {3#} for {4#} more unknowns, as chance has it once in a thousand cases at most; what is "
     "stated of each direction is too certain, and reversal is to be asked for as curves",
     "worin sich beide Richtungen unterscheiden, ändert sich längs {0}, am deutlichsten bei {1}: mit Kurven statt "
     "Konstanten fällt χ² von {2} auf {3} bei {4} Unbekannten mehr, was der Zufall höchstens einmal in tausend Fällen "
     "bewirkt; was von jeder Richtung angegeben wird, ist zu sicher, und Umkehr ist als Kurven zu verlangen"},
    {"what both directions differ by changes along {0=}: with curves in place of constants χ² falls from {1#} to {2#} "
     "for {3#} more unknowns, as chance has it once in a thousand cases at most; what is stated of each direction is "
     "too certain, and reversal is to be asked for as curves",
     "worin sich beide Richtungen unterscheiden, ändert sich längs {0}: mit Kurven statt Konstanten fällt χ² von {1} "
     "auf {2} bei {3} Unbekannten mehr, was der Zufall höchstens einmal in tausend Fällen bewirkt; was von jeder "
     "Richtung angegeben wird, ist zu sicher, und Umkehr ist als Kurven zu verlangen"},
    {"what residuals have too much goes with the direction in which axes came to rest: {0=} differs most, by {1#} "
     "between both directions of {2=}; where reversal is asked for (constant), errors hold it",
     "was die Residuen zu viel haben, hängt an der Richtung, in der Achsen zur Ruhe kamen: {0} unterscheidet sich am "
     "meisten, um {1} zwischen beiden Richtungen von {2}; wird Umkehr verlangt (constant), enthalten die Abweichungen "
     "sie"},
    {"where stations stand differs between tools {0=} and {1=} by {2#}, and not alike for all stations: the instrument "
     "was moved between the tools, or stations are mixed up",
     "der Ort der Stationen unterscheidet sich zwischen den Werkzeugen {0} und {1} um {2}, und nicht für alle "
     "Stationen gleich: Das Messgerät wurde zwischen den Werkzeugen bewegt, oder Stationen sind vertauscht"},
    {"{0#} of {1#} lengths lie farther from what the others predict than chance allows, and was set aside; the "
     "farthest is {2}, by {3#}",
     "{0} von {1} Längen liegt weiter von dem entfernt, was die übrigen vorhersagen, als der Zufall erlaubt, und ist "
     "beiseitegelegt; am weitesten {2}, um {3}"},
    {"{0#} of {1#} lengths lie farther from what the others predict than chance allows, and were set aside; the "
     "farthest is {2}, by {3#}",
     "{0} von {1} Längen liegen weiter von dem entfernt, was die übrigen vorhersagen, als der Zufall erlaubt, und sind "
     "beiseitegelegt; am weitesten {2}, um {3}"},
    {"{0#} row is a copy of earlier ones in every cell, and counts once",
     "{0} Zeile ist in jeder Zelle die Kopie einer früheren und zählt einmal"},
    {"{0#} rows are copies of earlier ones in every cell, and count once",
     "{0} Zeilen sind in jeder Zelle Kopien früherer und zählen einmal"},
    {"{0#} station leaves little to see a wrong one by; four or more are usual",
     "{0} Station lässt eine falsche kaum erkennen; vier oder mehr sind üblich"},
    {"{0#} stations leave little to see a wrong one by; four or more are usual",
     "{0} Stationen lassen eine falsche kaum erkennen; vier oder mehr sind üblich"},
    {"{0} came to rest at {1#} moving down only: what it does there moving up, and so the mean of both directions, is "
     "what its curves make of readings elsewhere",
     "{0} kam bei {1} nur abwärts zur Ruhe: Was die Achse dort aufwärts macht, und damit das Mittel beider Richtungen, "
     "ist das, was ihre Kurven aus Messungen an anderen Orten machen"},
    {"{0} came to rest at {1#} moving up only: what it does there moving down, and so the mean of both directions, is "
     "what its curves make of readings elsewhere",
     "{0} kam bei {1} nur aufwärts zur Ruhe: Was die Achse dort abwärts macht, und damit das Mittel beider Richtungen, "
     "ist das, was ihre Kurven aus Messungen an anderen Orten machen"},
    {"{0} came to rest from {1#} to {2#} moving down only: what it does there moving up, and so the mean of both "
     "directions, is what its curves make of readings elsewhere",
     "{0} kam von {1} bis {2} nur abwärts zur Ruhe: Was die Achse dort aufwärts macht, und damit das Mittel beider "
     "Richtungen, ist das, was ihre Kurven aus Messungen an anderen Orten machen"},
    {"{0} came to rest from {1#} to {2#} moving up only: what it does there moving down, and so the mean of both "
     "directions, is what its curves make of readings elsewhere",
     "{0} kam von {1} bis {2} nur aufwärts zur Ruhe: Was die Achse dort abwärts macht, und damit das Mittel beider "
     "Richtungen, ist das, was ihre Kurven aus Messungen an anderen Orten machen"},
    {"{0} ran the other way", "{0} andersherum lief"},
    {"{0} was read at {1#} places only: its curves go through what was read there, nothing shows what they are "
     "between, and no uncertainty holds it",
     "{0} wurde nur an {1} Orten gemessen: Die Kurven gehen durch das dort Gemessene, nichts zeigt, wie sie dazwischen "
     "sind, und keine Unsicherheit enthält es"},
    {"{0} were exchanged", "{0} vertauscht wären"},
    {"{0} were exchanged and {1} ran the other way", "{0} vertauscht wären und {1} andersherum lief"},
};

}  // namespace

const std::span<const Phrase> german_volumetric_findings = volumetric_findings_rows;

}  // namespace axiometry::language
