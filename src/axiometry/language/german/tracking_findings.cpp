// SPDX-License-Identifier: Apache-2.0
// What a plan, a station or lengths of a tracking interferometer tell.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase tracking_findings_rows[] = {
    {"Axes count as straight and without rotations: what straightness and angular errors (with the tool's offset as "
     "lever) add along these lines is taken for scale or squareness. The result holds for the place of the lines",
     "Die Achsen gelten als gerade und ohne Drehungen: Was Geradheits- und Winkelabweichungen (mit dem Werkzeugversatz "
     "als Hebel) entlang dieser Linien beitragen, wird als Maßstab oder Rechtwinkligkeit gewertet. Das Ergebnis gilt "
     "für den Ort der Linien"},
    {"Line {0=} is {1#} long: {2#} of straightness at one of its ends is {3#} of slope",
     "Linie {0} ist {1} lang: {2} Geradheitsabweichung an einem ihrer Enden sind {3} Steigung"},
    {"The lines contradict each other by more than their uncertainties: {0#} for {1#}; the model of straight axes "
     "without rotations does not describe this machine, uncertainties are multiplied by {2#}",
     "Die Linien widersprechen einander stärker, als ihre Unsicherheiten erlauben: {0} bei {1}; das Modell gerader "
     "Achsen ohne Drehungen beschreibt diese Maschine nicht, die Unsicherheiten sind mit {2} multipliziert"},
    {"The uncertainty of at least one slope is not known: all lines count alike, none is stated",
     "Die Unsicherheit mindestens einer Steigung ist nicht bekannt: Alle Linien zählen gleich, keine Unsicherheit ist "
     "angegeben"},
    {"There are no more lines than combinations of terms: nothing checks whether they agree",
     "Es gibt nicht mehr Linien als Kombinationen der Größen: nichts kontrolliert, ob sie übereinstimmen"},
    {"These {0#} lines tell {1#} combination of the six terms; {2=} cannot be told from them and are left out, not set "
     "to zero",
     "Diese {0} Linien bestimmen {1} Kombination der sechs Größen; {2} sind daraus nicht bestimmbar und weggelassen, "
     "nicht null gesetzt"},
    {"These {0#} lines tell {1#} combination of the six terms; {2=} cannot be told from them and is left out, not set "
     "to zero",
     "Diese {0} Linien bestimmen {1} Kombination der sechs Größen; {2} ist daraus nicht bestimmbar und weggelassen, "
     "nicht null gesetzt"},
    {"These {0#} lines tell {1#} combinations of the six terms; {2=} cannot be told from them and are left out, not "
     "set to zero",
     "Diese {0} Linien bestimmen {1} Kombinationen der sechs Größen; {2} sind daraus nicht bestimmbar und weggelassen, "
     "nicht null gesetzt"},
    {"These {0#} lines tell {1#} combinations of the six terms; {2=} cannot be told from them and is left out, not set "
     "to zero",
     "Diese {0} Linien bestimmen {1} Kombinationen der sechs Größen; {2} ist daraus nicht bestimmbar und weggelassen, "
     "nicht null gesetzt"},
    {"a place that is not finite", "ein Ort, der nicht endlich ist"},
    {"a station at {0#} (raised or lowered) would keep {1#} of {2#} lines, the shortest of {3#}; here it is {4#} of "
     "{5#}, the shortest of {6#}",
     "mit einer Station bei {0} (höher oder tiefer gestellt) wären {1} von {2} Linien messbar, die kürzeste {3} lang; "
     "hier sind es {4} von {5}, die kürzeste {6} lang"},
    {"a station at {0#} would keep {1#} of {2#} lines, the shortest of {3#}; here it is {4#} of {5#}, the shortest of "
     "{6#}",
     "mit einer Station bei {0} wären {1} von {2} Linien messbar, die kürzeste {3} lang; hier sind es {4} von {5}, die "
     "kürzeste {6} lang"},
    {"all beams lie on a cone about the station with a half angle of {0#} deg",
     "alle Strahlen liegen auf einem Kegel um die Station mit einem halben Öffnungswinkel von {0}°"},
    {"all lengths from point {0#} on being {1} (the beam was broken before it)",
     "alle Längen ab Punkt {0} {1} (der Strahl war davor unterbrochen)"},
    {"all points lie on a critical surface of eq. 14: only the refined station can be had, and its mirror image must "
     "be told apart",
     "alle Punkte liegen auf einer kritischen Fläche von Gl. 14: Nur die verfeinerte Station ist bestimmbar, und ihr "
     "Spiegelbild muss ausgeschlossen werden"},
    {"all points lie on a hyperboloid of revolution with a focus at the station (eccentricity {0#})",
     "alle Punkte liegen auf einem Rotationshyperboloid mit einem Brennpunkt in der Station (Exzentrizität {0})"},
    {"all points lie on a paraboloid of revolution with a focus at the station (eccentricity {0#})",
     "alle Punkte liegen auf einem Rotationsparaboloid mit dem Brennpunkt in der Station (Exzentrizität {0})"},
    {"all points lie on a sphere about the station (all lengths are alike)",
     "alle Punkte liegen auf einer Kugel um die Station (alle Längen sind gleich)"},
    {"all points lie on an ellipsoid of revolution with a focus at the station (eccentricity {0#})",
     "alle Punkte liegen auf einem Rotationsellipsoid mit einem Brennpunkt in der Station (Exzentrizität {0})"},
    {"all points lie on one line along {0#}: eq. 14 has rank {1#} of 5, the station may stand anywhere on "
     "a circle about that line, and no estimator can tell where; choose points off the line",
     "alle Punkte liegen auf einer Geraden entlang {0}: Gl. 14 hat den Rang {1} von 5, die Station kann "
     "irgendwo auf einem Kreis um diese Gerade stehen, und kein Schätzer kann sagen, wo; Punkte neben der "
     "Geraden wählen"},
    {"all points lie on one plane", "alle Punkte liegen auf einer Ebene"},
    {"an error of 1 µm in each length moves the station by {0#}: give the points more room, or move the station",
     "ein Fehler von 1\u00a0µm in jeder Länge verschiebt die Station um {0}: den Punkten mehr Raum geben oder die "
     "Station versetzen"},
    {"an obstacle", "Hindernis"},
    {"an obstacle in the beam", "Hindernis im Strahl"},
    {"an obstacle in the way", "Hindernis im Weg"},
    {"at the station itself", "an der Station selbst"},
    {"elevations", "Höhenwinkeln"},
    {"eq. 14 is nearly critical (condition {0#}): an error of 1 µm in each length moves its station by {1#}; rely on "
     "the refined one",
     "Gl. 14 ist nahezu kritisch (Kondition {0}): Ein Fehler von 1\u00a0µm in jeder Länge verschiebt ihre Station um "
     "{1}; die verfeinerte verwenden"},
    {"fewer than five points are different", "weniger als fünf Punkte sind verschieden"},
    {"found a point only {0#} from the station, expected at least the radius of the instrument",
     "ein Punkt nur {0} von der Station entfernt; erwartet: mindestens der Radius des Messgeräts"},
    {"found a station {0#} from the points, expected one within 100 m: are units mixed up, or are the lengths from "
     "another set-up?",
     "eine Station {0} von den Punkten entfernt; erwartet: eine innerhalb von 100\u00a0m: Sind Einheiten verwechselt, "
     "oder gehören die Längen zu einem anderen Aufbau?"},
    {"found all points within {0#} of the station, expected the range of an instrument: are units mixed up?",
     "alle Punkte innerhalb von {0} um die Station; erwartet: der Messbereich eines Messgeräts: Sind Einheiten "
     "verwechselt?"},
    {"found lengths at points {0#} and {1#} that differ by {2#}, expected at most the distance of the points, {3#}, "
     "and what instrument and machine may err",
     "Längen an den Punkten {0} und {1}, die sich um {2} unterscheiden; erwartet: höchstens der Abstand der Punkte, "
     "{3}, und was Messgerät und Maschine abweichen dürfen"},
    {"found no reading at {0#} of the {1#} targets of the plan, expected one from every approach: left out of the test",
     "kein Messwert an {0} der {1} Zielpositionen des Plans; erwartet: einer aus jeder Anfahrt: in der Prüfung "
     "weggelassen"},
    {"found no way from {0#} to {1#}, expected one; straight on: {2}", "kein Weg von {0} nach {1}; geradeaus: {2}"},
    {"found points up to {0#} from the station, expected the range of an instrument (about 20 m): are units mixed up?",
     "Punkte bis {0} von der Station entfernt; erwartet: der Messbereich eines Messgeräts (etwa 20\u00a0m): Sind "
     "Einheiten verwechselt?"},
    {"found {0#} different points, expected 6 or more: {1}", "{0} verschiedene Punkte; erwartet: 6 oder mehr: {1}"},
    {"heights above the station", "Höhen über der Station"},
    {"its beam comes {0#} off the axis of the reflector, which takes {1#}: turn the reflector towards the station",
     "ihr Strahl trifft {0} neben der Achse des Reflektors ein, der {1} erlaubt: den Reflektor zur Station drehen"},
    {"its beam has an elevation of {0#}, the instrument takes {1#} to {2#}",
     "ihr Strahl hat einen Höhenwinkel von {0}, das Messgerät erlaubt {1} bis {2}"},
    {"least range of the instrument", "kleinster Messabstand"},
    {"line {0=} could not be measured: {1}", "Linie {0} war nicht messbar: {1}"},
    {"line {0=} of the plan has no readings and is left out",
     "Linie {0} des Plans hat keine Messwerte und ist weggelassen"},
    {"lower end of {0#}", "unteres Ende von\u00a0{0}"},
    {"mount the reflector so that it looks along {0#}: it then sees the station from {1#} of {2#} lines",
     "den Reflektor so anbauen, dass er in Richtung {0} blickt: dann sieht er die Station von {1} der {2} Linien aus"},
    {"no other place for the station keeps more lines, or a longer shortest one",
     "kein anderer Ort der Station macht mehr Linien messbar oder die kürzeste länger"},
    {"no safe way to it: {0}", "kein sicherer Weg dorthin: {0}"},
    {"nothing checks eq. 14, one equation the refined station",
     "nichts kontrolliert Gl. 14, eine Gleichung die verfeinerte Station"},
    {"nothing checks the station, and eq. 14 cannot be solved",
     "nichts kontrolliert die Station, und Gl. 14 ist nicht lösbar"},
    {"nothing is known about the uncertainty of the station, so that the length difference that it causes is not part "
     "of the uncertainty",
     "über die Unsicherheit der Station ist nichts bekannt, sodass die von ihr verursachte Längendifferenz nicht Teil "
     "der Unsicherheit ist"},
    {"nothing of it is left between {0} ({1#} from the station) and {2} ({3#})",
     "davon bleibt nichts zwischen {0} ({1} von der Station) und {2} ({3})"},
    {"only {0#} of it are usable, from {1} ({2#} from the station) to {3} ({4#}), expected {5#}",
     "nur {0} davon sind nutzbar, zwischen {1} ({2} von der Station) und {3} ({4}); erwartet: {5}"},
    {"point {0#} stands where point {1#} stood; it is a check of the lengths, not of the station: they differ by {2}",
     "Punkt {0} steht, wo Punkt {1} stand; er kontrolliert die Längen, nicht die Station: Sie unterscheiden sich um "
     "{2}"},
    {"range of the instrument", "größter Messabstand"},
    {"reading {0#} (station {1=}, point {2=}) by {3#}, {4#} times its standard uncertainty",
     "Messwert {0} (Station {1}, Punkt {2}) um {3}, das {4}-Fache seiner Standardunsicherheit"},
    {"reading {0#} ({1}) alone has a dead path of its own, so that it tells nothing of the machine: take it again",
     "Messwert {0} ({1}) hat für sich allein eine eigene Totstrecke und sagt deshalb nichts über die Maschine: ihn "
     "wiederholen"},
    {"reading {0#} ({1}) lies {2#} from where its neighbours say and the next one does not: kept as it is, and in all "
     "results",
     "Messwert {0} ({1}) liegt {2} neben dem, was seine Nachbarn sagen, der nächste nicht: beibehalten und in allen "
     "Ergebnissen enthalten"},
    {"safe radius", "Sicherheitsradius"},
    {"sphere below reach: the reflector comes down to {0#} only, the station is at {1#}: {2#} are missing; a tool "
     "longer or an instrument higher by that would help",
     "Kugel unter der Reichweite: Der Reflektor kommt nur bis {0} herunter, die Station steht bei {1}: {2} fehlen; ein "
     "um so viel längeres Werkzeug oder ein um so viel höher stehendes Messgerät würde helfen"},
    {"station {0=} has a standard uncertainty of {1#} along the direction known worst; beyond {2#} distances bend by "
     "more than lengths are known, and no covariance can be trusted",
     "Station {0} hat entlang der unsichersten Richtung eine Standardunsicherheit von {1}; oberhalb von {2} ist die "
     "Krümmung der Abstände größer als die Unsicherheit der Längen, und keiner Kovarianz ist zu trauen"},
    {"target {0#} run {1#}", "Zielposition {0}, Durchlauf {1}"},
    {"target {0#} run {1#} of line {2=}", "Zielposition {0}, Durchlauf {1} der Linie {2}"},
    {"the beam at an elevation of {0#}, above the highest of {1#}",
     "Höhenwinkel des Strahls {0}, über dem größten von {1}"},
    {"the beam at an elevation of {0#}, below the lowest of {1#}",
     "Höhenwinkel des Strahls {0}, unter dem kleinsten von {1}"},
    {"the beam is lost on the way from {0=} to {1=}: its readings begin a new dead path",
     "auf dem Weg von {0} zu {1} geht der Strahl verloren: dort beginnt eine neue Totstrecke"},
    {"the beam stands at up to {0#} to the line, which passes the station {1#} beside it: errors across the line enter "
     "the deviations",
     "der Strahl steht bis zu {0} schräg zur Linie, die in {1} Abstand an der Station vorbeiführt: Abweichungen quer "
     "zur Linie gehen in die Abweichungen ein"},
    {"the beam {0#} off the axis of the reflector, which takes {1#}",
     "Strahl {0} neben der Achse des Reflektors, der {1} erlaubt"},
    {"the calibration uncertainty of the device is that of the instrument of the plan, {0#} over the measured travel "
     "of {1#}: {2#}",
     "die Kalibrierunsicherheit des Messgeräts ist die des im Plan angegebenen, {0} über den Messweg von {1}: {2}"},
    {"the length of point {0#} being {1}", "die Länge von Punkt {0} {1}"},
    {"the lengths fit the mirror image of the nominal points: one of their axes points the wrong way, or two are "
     "exchanged",
     "die Längen passen zum Spiegelbild der Sollpunkte: Eine ihrer Achsen zeigt in die falsche Richtung, oder zwei "
     "sind vertauscht"},
    {"the lengths fit {0#} and {1#} alike; the first is {2#} from the place that was said, the other {3#}",
     "die Längen passen zu {0} und {1} gleich gut; die erste ist {2} vom angegebenen Ort entfernt, die andere {3}"},
    {"the lengths fit {0#} and {1#} alike; the first is {2#} from the place that was said, the other {3#}, which does "
     "not decide",
     "die Längen passen zu {0} und {1} gleich gut; die erste ist {2} vom angegebenen Ort entfernt, die andere {3}, was "
     "nicht entscheidet"},
    {"the lengths fit {0#} and {1#} alike; the first was taken: say about where the station stands",
     "die Längen passen zu {0} und {1} gleich gut; die erste wurde genommen: ungefähr angeben, wo die Station steht"},
    {"the lengths fit {0#} and {1#} alike; the lower was taken: say about where the station stands",
     "die Längen passen zu {0} und {1} gleich gut; die tiefere wurde genommen: ungefähr angeben, wo die Station steht"},
    {"the lengths jump by {0#} before reading {1#} ({2}) and stay there, more than {3#} that no machine does: the beam "
     "was broken; the readings from there on have a dead path of their own",
     "die Längen springen um {0} vor Messwert {1} ({2}) und bleiben dort, mehr als {3}, was keine Maschine tut: Der "
     "Strahl war unterbrochen; die Messwerte von dort an haben eine eigene Totstrecke"},
    {"the lengths of station {0=} are too long by {1#} against those of the others: its air or wavelength is not "
     "theirs, or it was taken for another; what all have in common no length tells",
     "die Längen von Station {0} sind gegenüber denen der anderen um {1} zu lang: Ihre Luft oder Wellenlänge ist nicht "
     "die der anderen, oder sie wurde für eine andere gehalten; was allen gemeinsam ist, zeigt keine Länge"},
    {"the lengths of station {0=} are too short by {1#} against those of the others: its air or wavelength is not "
     "theirs, or it was taken for another; what all have in common no length tells",
     "die Längen von Station {0} sind gegenüber denen der anderen um {1} zu kurz: Ihre Luft oder Wellenlänge ist nicht "
     "die der anderen, oder sie wurde für eine andere gehalten; was allen gemeinsam ist, zeigt keine Länge"},
    {"the lengths of station {0=} jump by {1#} before reading {2#} (point {3=}): taken as a beam that was broken, with "
     "a dead path of its own from there on",
     "die Längen von Station {0} springen um {1} vor Messwert {2} (Punkt {3}): als Strahlunterbrechung behandelt, von "
     "dort an mit eigener Totstrecke"},
    {"the line from the station leads past the travels",
     "die Linie von der Station aus führt an den Verfahrwegen vorbei"},
    {"the linear and the refined station are {0#} apart, {1#} times what the stated uncertainties explain: the "
     "machine's points or a length are wrong (an error of scale does this); neither is better known than this",
     "lineare und verfeinerte Station liegen {0} auseinander, das {1}-Fache dessen, was die angegebenen Unsicherheiten "
     "erklären: Die Punkte der Maschine oder eine Länge sind falsch (eine Maßstabsabweichung wirkt so); keine der "
     "beiden ist genauer bekannt"},
    {"the nominal points lie on a plane, and no length tells on which side of it the station {0=} stands: all were "
     "taken on its upper side",
     "die Sollpunkte liegen auf einer Ebene, und keine Länge sagt, auf welcher Seite davon Station {0} steht: Alle "
     "wurden auf ihrer Oberseite angenommen"},
    {"the nominal points lie on a plane, and no length tells on which side of it the stations {0=} stand: all were "
     "taken on its upper side",
     "die Sollpunkte liegen auf einer Ebene, und keine Länge sagt, auf welcher Seite davon die Stationen {0} stehen: "
     "Alle wurden auf ihrer Oberseite angenommen"},
    {"the points tell the station badly along {0#} (condition {1#}): an error of 1 µm in each length moves it by {2#}",
     "die Punkte bestimmen die Station entlang {0} schlecht (Kondition {1}): Ein Fehler von 1\u00a0µm in jeder Länge "
     "verschiebt sie um {2}"},
    {"the refinement did not converge", "die Verfeinerung ist nicht konvergiert"},
    {"the residuals ({0#} root mean square) are far smaller than the stated uncertainties (chi-squared {1#} with {2#} "
     "degree of freedom): these are computed data, or the uncertainties are stated too large",
     "die Residuen (quadratisches Mittel {0}) sind viel kleiner als die angegebenen Unsicherheiten (χ² {1} bei {2} "
     "Freiheitsgrad): Dies sind berechnete Daten, oder die Unsicherheiten sind zu groß angegeben"},
    {"the residuals ({0#} root mean square) are far smaller than the stated uncertainties (chi-squared {1#} with {2#} "
     "degrees of freedom): these are computed data, or the uncertainties are stated too large",
     "die Residuen (quadratisches Mittel {0}) sind viel kleiner als die angegebenen Unsicherheiten (χ² {1} bei {2} "
     "Freiheitsgraden): Dies sind berechnete Daten, oder die Unsicherheiten sind zu groß angegeben"},
    {"the residuals ({0#} root mean square) are {1#} times what the stated uncertainties explain (chi-squared {2#} "
     "with {3#} degree of freedom): errors of the machine's points of {4#} each would explain them; the covariance is "
     "that much larger",
     "die Residuen (quadratisches Mittel {0}) sind das {1}-Fache dessen, was die angegebenen Unsicherheiten erklären "
     "(χ² {2} bei {3} Freiheitsgrad): Abweichungen der Maschinenpunkte von je {4} würden sie erklären; um so viel "
     "größer ist die Kovarianz"},
    {"the residuals ({0#} root mean square) are {1#} times what the stated uncertainties explain (chi-squared {2#} "
     "with {3#} degrees of freedom): errors of the machine's points of {4#} each would explain them; the covariance is "
     "that much larger",
     "die Residuen (quadratisches Mittel {0}) sind das {1}-Fache dessen, was die angegebenen Unsicherheiten erklären "
     "(χ² {2} bei {3} Freiheitsgraden): Abweichungen der Maschinenpunkte von je {4} würden sie erklären; um so viel "
     "größer ist die Kovarianz"},
    {"the residuals are {0#} times as large as stated ({1#}): the uncertainty of the readings is stated too large",
     "die Residuen sind {0}-mal so groß wie angegeben ({1}): Die Unsicherheit der Messwerte ist zu groß angegeben"},
    {"the residuals are {0#} times as large as stated ({1#}); all covariances were multiplied by {2#}",
     "die Residuen sind {0}-mal so groß wie angegeben ({1}); alle Kovarianzen wurden mit {2} multipliziert"},
    {"the sign of all lengths was reversed, as asked for", "das Vorzeichen aller Längen wurde wie verlangt umgekehrt"},
    {"the station", "Station"},
    {"the station at {0#} is {1#} outside the travel of {2#}: the reflector reaches {3#} to {4#}",
     "die Station bei {0} liegt {1} außerhalb des Verfahrwegs von {2}: Der Reflektor erreicht {3} bis {4}"},
    {"the station is {0#} from where it was said to stand about, {1#}: are axes, signs or tools of the two those of "
     "the points?",
     "die Station steht {0} von dem Ort entfernt, der ungefähr angegeben war, {1}: Stimmen Achsen, Vorzeichen und "
     "Werkzeug mit denen der Punkte überein?"},
    {"the station lies in the plane of all points", "die Station liegt in der Ebene aller Punkte"},
    {"the station of {0=} stands {1#} from that of the plan",
     "die Station aus {0} steht {1} von der des Plans entfernt"},
    {"the station of {0=} stands {1#} from that of the plan: was the instrument moved, or does it belong to another "
     "plan?",
     "die Station aus {0} steht {1} von der des Plans entfernt: Wurde das Messgerät bewegt, oder gehört sie zu einem "
     "anderen Plan?"},
    {"the straight way from point {0#} to {1#} is no good ({2}): drive around it, with the beam in sight",
     "der gerade Weg von Punkt {0} nach {1} ist nicht fahrbar ({2}): außen herum fahren, ohne den Strahl zu verlieren"},
    {"the uncertainty of the station is not known: the length difference it causes is not judged",
     "die Unsicherheit der Station ist nicht bekannt: die von ihr verursachte Längendifferenz ist nicht beurteilt"},
    {"there are no more readings than unknowns: nothing checks the result",
     "es gibt nicht mehr Messwerte als Unbekannte: nichts kontrolliert das Ergebnis"},
    {"upper end of {0#}", "oberes Ende von\u00a0{0}"},
    {"{0#} at {1#}, beyond its travel {2#} to {3#}", "{0} bei {1}, außerhalb des Verfahrwegs von {2} bis {3}"},
    {"{0#} from an obstacle, nearer than {1#}", "{0} von einem Hindernis entfernt, näher als {1}"},
    {"{0#} from the station, farther than the range of {1#}",
     "{0} von der Station entfernt, weiter als der größte Messabstand von {1}"},
    {"{0#} from the station, nearer than the least range of {1#}",
     "{0} von der Station entfernt, näher als der kleinste Messabstand von {1}"},
    {"{0#} from the station, within its safe radius of {1#}",
     "{0} von der Station entfernt, innerhalb ihres Sicherheitsradius von {1}"},
    {"{0#} from {1=}, nearer than {2#}", "{0} von {1} entfernt, näher als {2}"},
    {"{0#} nominal point has no length and is left out", "{0} Sollpunkt hat keine Länge und ist weggelassen"},
    {"{0#} nominal points have no length and are left out", "{0} Sollpunkte haben keine Länge und sind weggelassen"},
    {"{0#} point is seen by three stations only: nothing checks the readings there",
     "{0} Punkt ist nur von drei Stationen aus gesehen: nichts kontrolliert die Messwerte dort"},
    {"{0#} points are seen by three stations only: nothing checks the readings there",
     "{0} Punkte sind nur von drei Stationen aus gesehen: nichts kontrolliert die Messwerte dort"},
    {"{0#} reading does not fit the others: {1}", "{0} Messwert passt nicht zu den anderen: {1}"},
    {"{0#} readings do not fit the others: {1}", "{0} Messwerte passen nicht zu den anderen: {1}"},
    {"{0#} readings from reading {1#} on have their own dead path, {2#} more than the first; {3#} of them tie it "
     "({4#})",
     "{0} Messwerte ab Messwert {1} haben ihre eigene Totstrecke, {2} mehr als die erste; {3} davon binden sie an "
     "({4})"},
    {"{0#} readings from reading {1#} on have their own dead path, {2#} more than the first; {3#} of them tie it "
     "({4#}), taking the reversal error for alike at all targets",
     "{0} Messwerte ab Messwert {1} haben ihre eigene Totstrecke, {2} mehr als die erste; {3} davon binden sie an "
     "({4}), wobei die Umkehrspanne an allen Zielpositionen als gleich gilt"},
    {"{0#} readings from reading {1#} on share no approach with those before, so that the line is split: what the "
     "deviation does between the parts cannot be told and was taken for no step",
     "{0} Messwerte ab Messwert {1} haben keine Anfahrt mit denen davor gemeinsam, sodass die Linie geteilt ist: Was "
     "die Abweichung zwischen den Teilen tut, ist nicht bestimmbar; ein Sprung wurde nicht angenommen"},
    {"{0#} too long", "{0} zu lang"},
    {"{0#} too short", "{0} zu kurz"},
    {"{0#}, expected less than {1#}", "{0}; erwartet: weniger als {1}"},
    {"{0#}, expected less than {1#}; the beam was broken or the reflector moved",
     "{0}; erwartet: weniger als {1}; der Strahl war unterbrochen, oder der Reflektor hat sich bewegt"},
    {"{0=} in the beam", "{0} im Strahl"},
    {"{0=} in the way", "{0} im Weg"},
    {"{0=}: above 2 000 mm the whole is measured {1} in each direction, at five targets per metre, which holds the "
     "test of every 2 000 mm in it",
     "{0}: Über 2\u00a0000\u00a0mm wird das Ganze {1} in jeder Richtung gemessen, mit fünf Zielpositionen je Meter, "
     "was die Prüfung über jeweils 2\u00a0000\u00a0mm einschließt"},
    {"{0=}: departs from {1#}, {2=}: {3}", "{0}: weicht ab von {1}, {2}: {3}"},
    {"{0=}: not all of it can be seen from the station: {1}",
     "{0}: Von der Station aus ist nicht alles davon zu sehen: {1}"},
    {"{0=}: the length difference may be neglected from {1#} on, the first target is {2#} from the station",
     "{0}: Die Längendifferenz ist ab {1} vernachlässigbar, die erste Zielposition ist {2} von der Station entfernt"},
    {"{0=}: the length difference may be neglected on the whole line, its first target is {1#} from the station",
     "{0}: Die Längendifferenz ist auf der ganzen Linie vernachlässigbar, ihre erste Zielposition ist {1} von der "
     "Station entfernt"},
    {"{0=}: the length difference may be neglected on the whole line, its first target is {1#} from the station, {2#} "
     "would do",
     "{0}: Die Längendifferenz ist auf der ganzen Linie vernachlässigbar, ihre erste Zielposition ist {1} von der "
     "Station entfernt, {2} würden genügen"},
    {"{0=}: the length difference may not be neglected anywhere",
     "{0}: Die Längendifferenz ist nirgends vernachlässigbar"},
    {"{0=}: the station is {1#} beside this diagonal; it needs an interferometer aligned with it, or a station on its "
     "extension",
     "{0}: Die Station steht {1} neben dieser Diagonale; sie braucht ein auf sie ausgerichtetes Interferometer oder "
     "eine Station auf ihrer Verlängerung"},
    {"{0=}: there is no way to it from above; drive to {1#} by hand",
     "{0}: Von oben führt kein Weg dorthin; von Hand nach {1} fahren"},
    {"{0} are out of question as one is: {1}", "{0} scheiden aus, eine davon: {1}"},
    {"{0} or {1}", "{0} oder {1}"},
    {"{0} would explain the residuals, chi-squared falling from {1#} to {2#}; so would {3}; without it the station "
     "would be {4#}",
     "{0}: Das würde die Residuen erklären, χ² fiele von {1} auf {2}; ebenso {3}; ohne diesen Fehler stünde die "
     "Station bei {4}"},
    {"{0} would explain the residuals, chi-squared falling from {1#} to {2#}; so would {3}; without it the station "
     "would be {4#}; this rests on one redundant length, measure more points",
     "{0}: Das würde die Residuen erklären, χ² fiele von {1} auf {2}; ebenso {3}; ohne diesen Fehler stünde die "
     "Station bei {4}; das beruht auf einer einzigen überzähligen Länge, mehr Punkte messen"},
    {"{0} would explain the residuals, chi-squared falling from {1#} to {2#}; without it the station would be {3#}",
     "{0}: Das würde die Residuen erklären, χ² fiele von {1} auf {2}; ohne diesen Fehler stünde die Station bei {3}"},
    {"{0} would explain the residuals, chi-squared falling from {1#} to {2#}; without it the station would be {3#}; "
     "this rests on one redundant length, measure more points",
     "{0}: Das würde die Residuen erklären, χ² fiele von {1} auf {2}; ohne diesen Fehler stünde die Station bei {3}; "
     "das beruht auf einer einzigen überzähligen Länge, mehr Punkte messen"},
    {"{0}: eq. 14 has rank {1#} of 5 (smallest singular value {2#}, below the {3#} that noise may produce) and gives "
     "no station; the refined one holds",
     "{0}: Gl. 14 hat Rang {1} von 5 (kleinster Singulärwert {2}, unter den {3}, die das Rauschen erzeugen kann) und "
     "ergibt keine Station; die verfeinerte gilt"},
    {"{0}: eq. 14 has rank {1#} of 5, the refined rows have the condition {2#}, and no estimator can tell the station "
     "along {3#}; choose points at different {4}",
     "{0}: Gl. 14 hat Rang {1} von 5, die verfeinerten Zeilen haben die Kondition {2}, und kein Schätzer kann die "
     "Station entlang {3} bestimmen; Punkte wählen mit verschiedenen {4}"},
    {"ψ of eq. 13 misses {0#} by {1#}, {2#} times what the stated uncertainties explain",
     "ψ aus Gl. 13 verfehlt {0} um {1}, das {2}-Fache dessen, was die angegebenen Unsicherheiten erklären"},
};

}  // namespace

const std::span<const Phrase> german_tracking_findings{tracking_findings_rows};

}  // namespace axiometry::language
