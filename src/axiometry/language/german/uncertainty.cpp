// SPDX-License-Identifier: Apache-2.0
// Annex A, GUM, Monte Carlo and their budgets.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase uncertainty_rows[] = {
    {"A single approach has no scatter: there the known noise counts alone",
     "Eine einzelne Anfahrt hat keine Streuung: dort zählt allein das bekannte Rauschen"},
    {"Above 2 000 mm the annex has no formula for repeatability: (A.11) and (A.14) are used all the same, and nothing "
     "is corrected for the environment (A.2.6)",
     "Über 2\u00a0000\u00a0mm hat der Anhang keine Formel für die Wiederholpräzision: (A.11) und (A.14) werden dennoch "
     "verwendet, und nichts wird um die Umgebung korrigiert (A.2.6)"},
    {"Accuracy", "Genauigkeit"},
    {"Against GUM", "Gegen GUM"},
    {"Against Monte Carlo", "Gegen Monte Carlo"},
    {"Against Monte Carlo: {0#} compared with half the {1#} interval; alike: within 5 %.",
     "Gegen Monte Carlo: {0} verglichen mit dem halben {1}-Intervall; gleich: innerhalb von 5\u00a0%."},
    {"Alignment of the measuring device with the axis", "Ausrichtung des Messgeräts zur Achse"},
    {"All together", "Alle zusammen"},
    {"Annex A is written for linear axes: of its contributors the device (A.1) and the environmental variation (A.9) "
     "are combined in ″, the terms in µm/m do not apply",
     "Anhang A ist für Linearachsen geschrieben: von seinen Beiträgen werden Messgerät (A.1) und Umgebungsschwankung "
     "(A.9) in ″ zusammengefasst, die Terme in µm/m sind nicht anwendbar"},
    {"Approaches: of the mean of the approaches. Thermal: expansion of the machine and of the device. Alignment, "
     "resolution of the axis, instrument with calibration and environment: as in the table of inputs.",
     "Anfahrten: des Mittelwerts der Anfahrten. Thermisch: Dehnung von Maschine und Messgerät. Ausrichtung, Auflösung "
     "der Achse, Messgerät mit Kalibrierung und Umgebung: wie in der Tabelle der Eingangsgrößen."},
    {"As measured", "Gemessen"},
    {"Bias", "Verzerrung"},
    {"Bias: value less mean. The parameters are extremes: noise in the readings pushes them apart and makes the bias "
     "positive; systematic inputs, such as a temperature, widen them more often than they narrow them and make it "
     "negative. The measured value stays the result.",
     "Verzerrung: Wert minus Mittelwert. Die Kennwerte sind Extremwerte: Rauschen der Messwerte treibt sie auseinander "
     "und macht die Verzerrung positiv; systematische Eingangsgrößen, etwa eine Temperatur, weiten sie öfter, als sie "
     "sie verengen, und machen sie negativ. Der gemessene Wert bleibt das Ergebnis."},
    {"Budget: expanded contributions", "Messunsicherheitsbilanz: erweiterte Beiträge"},
    {"Calibration of the artefact", "Kalibrierung des Prüfkörpers"},
    {"Calibration of the artefact, by length", "Kalibrierung des Prüfkörpers, längenabhängig"},
    {"Calibration of the measuring device", "Gerätekalibrierung"},
    {"Calibration of the measuring device, constant part", "Gerätekalibrierung, fester Teil"},
    {"Common to", "Gemeinsam"},
    {"Components of the standard uncertainty at the targets, {0#}",
     "Anteile der Standardunsicherheit an den Zielpositionen, {0}"},
    {"Composed here of the contributors of Annex A and combined as for the parameters; the annex itself states no "
     "uncertainty of mean deviations.",
     "Hier aus den Beiträgen von Anhang A zusammengesetzt und wie für die Kennwerte verknüpft; der Anhang selbst gibt "
     "keine Unsicherheit mittlerer Abweichungen an."},
    {"Contributions to the uncertainty", "Beiträge zur Unsicherheit"},
    {"Contributor", "Beitrag"},
    {"Contributors", "Beiträge"},
    {"Corrected", "Korrigiert"},
    {"Coverage", "Überdeckung"},
    {"Distribution", "Verteilung"},
    {"Distributions of inputs ({0=})", "Verteilungen von Eingangsgrößen ({0})"},
    {"Drift from run to run", "Drift von Durchlauf zu Durchlauf"},
    {"Environmental variation", "Umgebungsschwankung"},
    {"Environmental variation of a reading", "Umgebungsschwankung eines Messwerts"},
    {"Every input is varied alone, the others stay at their estimates; all together is {0#} of the run. The squares "
     "add up as far as the evaluation is linear and the inputs are independent.",
     "Jede Eingangsgröße wird allein verändert, die anderen bleiben bei ihren Schätzwerten; alle zusammen ist {0} des "
     "Laufs. Die Quadrate addieren sich, soweit die Auswertung linear ist und die Eingangsgrößen unabhängig sind."},
    {"Expanded uncertainty of the mean deviations, composed of the contributors of Annex A (k = 2), {0#}",
     "Erweiterte Unsicherheit der mittleren Abweichungen, zusammengesetzt aus den Beiträgen von Anhang A (k = 2), {0}"},
    {"Expanded uncertainty of the parameters, {0#}", "Erweiterte Unsicherheit der Kennwerte, {0}"},
    {"Expansion coefficient and temperature together", "Ausdehnungskoeffizient und Temperatur zusammen"},
    {"Expansion coefficient and temperature together ({0})", "Ausdehnungskoeffizient und Temperatur zusammen ({0})"},
    {"Expansion coefficient of the artefact", "Ausdehnungskoeffizient des Prüfkörpers"},
    {"Expansion coefficient of the machine", "Ausdehnungskoeffizient der Maschine"},
    {"Expansion coefficient of the machine tool", "Ausdehnungskoeffizient der Werkzeugmaschine"},
    {"Expansion coefficient of the measuring device", "Ausdehnungskoeffizient des Messgeräts"},
    {"Factor", "Faktor"},
    {"Factors that multiply every position, µm/m", "Faktoren, mit denen jede Position multipliziert wird, µm/m"},
    {"Floored: the environmental variation exceeds the spread of the readings, {0#}² < ({1#}/2)², and 0 was taken for "
     "the corrected {2#} of that direction.",
     "Auf 0 gesetzt: Die Umgebungsschwankung übersteigt die Streuung der Messwerte, {0}² < ({1}/2)², und für das "
     "korrigierte {2} dieser Richtung wurde 0 angenommen."},
    {"For B̄ the annex has no formula; U(B), which bounds it, is stated",
     "Für B̄ hat der Anhang keine Formel; angegeben ist U(B), das eine obere Grenze dafür ist"},
    {"For n = {0#} the factors printed for n = 5 and n = 1 are generalised: U_EVE²/n in A.15, U_EVE²/2n in A.16, 2 "
     "U_EVE/√n in A.12; those of A.11 and A.14 are kept",
     "Für n = {0} werden die für n = 5 und n = 1 gedruckten Faktoren verallgemeinert: U_EVE²/n in A.15, U_EVE²/2n in "
     "A.16, 2 U_EVE/√n in A.12; die von A.11 und A.14 bleiben"},
    {"Formula", "Formel"},
    {"GUM and Monte Carlo", "GUM und Monte Carlo"},
    {"GUM: contributions |{0#}| {1#} of the sources, {2#}", "GUM: Beiträge |{0}| {1} der Quellen, {2}"},
    {"GUM: contributions |{0#}|{1#} of the sources, {2#}", "GUM: Beiträge |{0}|{1} der Quellen, {2}"},
    {"How it was found", "Wie es ermittelt wurde"},
    {"Input", "Eingangsgröße"},
    {"Inputs", "Eingangsgrößen"},
    {"Inputs and their distributions", "Eingangsgrößen und ihre Verteilungen"},
    {"Inputs as resolved", "Eingangsgrößen, wie sie zählen"},
    {"Instrument away from standard conditions", "Messgerät abseits der Bezugsbedingungen"},
    {"Intervals widened to hold the measured value, of which known noise or systematic inputs explain a part: {0#}",
     "Intervalle, die erweitert wurden, um den Messwert zu enthalten, von dem bekanntes Rauschen oder systematische "
     "Eingangsgrößen einen Teil erklären: {0}"},
    {"JCGM 101: every trial is a complete test that may have happened, evaluated by clause 3.",
     "JCGM 101: Jeder Versuch ist eine vollständige Prüfung, die so hätte stattfinden können, ausgewertet nach "
     "Abschnitt 3."},
    {"K of the instrument is left out because the air temperature was not given",
     "K des Messgeräts ist weggelassen, weil die Lufttemperatur nicht angegeben wurde"},
    {"Law of propagation of uncertainty (GUM)", "Unsicherheitsfortpflanzung (GUM)"},
    {"Law of propagation, linear at the extreme targets of this test; correlation {0#} between the errors of ↑ and ↓ "
     "at a target.",
     "Fortpflanzungsgesetz, linear an den extremen Zielpositionen dieser Prüfung; Korrelation {0} zwischen den "
     "Abweichungen von ↑ und ↓ an einer Zielposition."},
    {"Less 1", "Minus 1"},
    {"Mean", "Mittelwert"},
    {"Mean error of the alignment, not corrected", "Mittlerer Ausrichtfehler, nicht korrigiert"},
    {"Mean error of the station, not corrected", "Mittlere Abweichung durch die Station, nicht korrigiert"},
    {"Measurement uncertainty (Annex A)", "Messunsicherheit (Anhang A)"},
    {"Measuring device", "Messgerät"},
    {"Misalignment of the artefact", "Ausrichtfehler des Prüfkörpers"},
    {"Misalignment of the measuring device", "Ausrichtfehler des Messgeräts"},
    {"Monte Carlo: coverage interval and numerical tolerance, {0#}",
     "Monte Carlo: Überdeckungsintervall und numerische Toleranz, {0}"},
    {"Monte Carlo: standard uncertainty {0#} from each input alone, {1#}",
     "Monte Carlo: Standardunsicherheit {0} durch jede Eingangsgröße allein, {1}"},
    {"No given input acts on {0#}: an uncertainty is not stated, rather than 0",
     "Keine angegebene Eingangsgröße wirkt auf {0}: statt 0 wird keine Unsicherheit angegeben"},
    {"No interval", "Kein Intervall"},
    {"No interval is stated (Monte Carlo)", "Es wird kein Intervall angegeben (Monte Carlo)"},
    {"No interval is stated, since no normal scatter explains a reading: {0}.",
     "Es wird kein Intervall angegeben, da keine normale Streuung einen Messwert erklärt: {0}."},
    {"Not estimated: no input of Annex A was given.",
     "Nicht ermittelt: Keine Eingangsgröße von Anhang A wurde angegeben."},
    {"Of several statements about the measuring device the calibration was taken",
     "Von mehreren Angaben zum Messgerät wurde die Kalibrierung verwendet"},
    {"Of several statements about the measuring device the error range was taken",
     "Von mehreren Angaben zum Messgerät wurde der Fehlerbereich verwendet"},
    {"On a rotary axis the calibration of the device counts as independent from target to target",
     "An einer Drehachse gilt die Gerätekalibrierung als von Zielposition zu Zielposition unabhängig"},
    {"Origin", "Herkunft"},
    {"Probing of the artefact", "Antastung des Prüfkörpers"},
    {"R(α) of the {0} is left out because its temperature was not given",
     "R(α) ({0}) ist weggelassen, weil die zugehörige Temperatur nicht angegeben wurde"},
    {"R(α) of the {0} was not given; 2 µm/(m·°C) is assumed (A.2.4.3)",
     "R(α) ({0}) wurde nicht angegeben; 2\u00a0µm/(m·°C) ist angenommen (A.2.4.3)"},
    {"R(θ) of the measuring device is left out because its α was not given (formula A.6)",
     "R(θ) des Messgeräts ist weggelassen, weil dessen α nicht angegeben wurde (Formel A.6)"},
    {"R(θ) of the {0} is left out because its α was not given",
     "R(θ) ({0}) ist weggelassen, weil das zugehörige α nicht angegeben wurde"},
    {"R(θ) of the {0} was not given; its temperature counts as known",
     "R(θ) ({0}) wurde nicht angegeben; die Temperatur gilt als bekannt"},
    {"Remark", "Bemerkung"},
    {"Repeatability at the targets, as measured and corrected (A.10), {0#}",
     "Wiederholpräzision an den Zielpositionen, gemessen und korrigiert (A.10), {0}"},
    {"Repeatability of the axis, corrected for the environmental variation (A.2.6)",
     "Wiederholpräzision der Achse, um die Umgebungsschwankung korrigiert (A.2.6)"},
    {"Resolution of the axis", "Auflösung der Achse"},
    {"Resolution of the measuring instrument", "Auflösung des Messgeräts"},
    {"Run", "Lauf"},
    {"Sampling", "Ziehung"},
    {"Sampling of the approaches", "Ziehung der Anfahrten"},
    {"Scatter of the approaches (type A)", "Streuung der Anfahrten (Typ A)"},
    {"Seed", "Startwert"},
    {"Simplified formulas of the standard, {0#} = 2, for this test.",
     "Vereinfachte Formeln der Norm, {0} = 2, für diese Prüfung."},
    {"Some sources are correlated: effective degrees of freedom are not defined, and k = 2",
     "Einige Quellen sind korreliert: effektive Freiheitsgrade sind nicht definiert, und k = 2"},
    {"Source", "Quelle"},
    {"Stable", "Stabil"},
    {"Station beside the line, larger component", "Station neben der Linie, größere Komponente"},
    {"Station beside the line, smaller component", "Station neben der Linie, kleinere Komponente"},
    {"Station of the tracking interferometer", "Station des nachführenden Interferometers"},
    {"Temperature measurement of the artefact", "Temperaturmessung des Prüfkörpers"},
    {"Temperature measurement of the machine tool", "Temperaturmessung der Werkzeugmaschine"},
    {"Temperature measurement of the measuring device", "Temperaturmessung des Messgeräts"},
    {"Temperature of the artefact, less 20 °C", "Temperatur des Prüfkörpers minus 20\u00a0°C"},
    {"Temperature of the machine, less 20 °C", "Temperatur der Maschine minus 20\u00a0°C"},
    {"Temperature of the measuring device, less 20 °C", "Temperatur des Messgeräts minus 20\u00a0°C"},
    {"Temperature sensors ({0})", "Temperatursensoren ({0})"},
    {"The artefact takes the place of the measuring device (Annex D); R(θ) of its temperature was not given, and "
     "U_M,DEVICE counts as zero",
     "Der Prüfkörper tritt an die Stelle des Messgeräts (Anhang D); R(θ) seiner Temperatur wurde nicht angegeben, und "
     "U_M,DEVICE gilt als null"},
    {"The artefact takes the place of the measuring device, whose calibration and error range are left out",
     "Der Prüfkörper tritt an die Stelle des Messgeräts, dessen Kalibrierung und Fehlergrenzen weggelassen sind"},
    {"The beam of a tracking interferometer follows the reflector: the uncertainty of its station takes the place of "
     "the misalignment, which is left out",
     "Der Strahl eines nachführenden Interferometers folgt dem Reflektor: Die Unsicherheit seiner Station tritt an die "
     "Stelle des Ausrichtfehlers, der weggelassen ist"},
    {"The distribution of {0} is used about its mean: the readings are not corrected by {1#}",
     "Die Verteilung von {0} wird um ihren Mittelwert verwendet: die Messwerte werden nicht um {1} korrigiert"},
    {"The known noise of a reading (u = {0#}) is not small against the scatter (s up to {1#}): to first order A, R and "
     "their like are uncertain by less than they are, see the Monte Carlo method",
     "Das bekannte Rauschen eines Messwerts (u = {0}) ist nicht klein gegen die Streuung (s bis {1}): in erster "
     "Ordnung erscheinen A, R und ihresgleichen sicherer, als sie sind, siehe Monte-Carlo-Methode"},
    {"The known noise of readings and runs is part of the scatter and not counted again",
     "Das bekannte Rauschen der Messwerte und Durchläufe ist Teil der Streuung und wird nicht noch einmal gezählt"},
    {"The length difference of the station grows with the square of its offset: to first order the squares are inputs "
     "with a mean and a standard deviation; the readings are not corrected for the mean, which counts as a source of "
     "its own",
     "Die Längendifferenz durch die Station wächst mit dem Quadrat ihres Versatzes: in erster Ordnung sind die "
     "Quadrate Eingangsgrößen mit Mittelwert und Standardabweichung; die Messwerte sind nicht um den Mittelwert "
     "korrigiert, der als eigene Quelle zählt"},
    {"The means of {0#} of the {1#} targets have an interval here",
     "Die Mittelwerte von {0} der {1} Zielpositionen haben hier ein Intervall"},
    {"The methods side by side, {0#}", "Die Verfahren im Vergleich, {0}"},
    {"The parameters are extremes; this method follows the targets that are extreme in this test and does not see the "
     "bias of extremes, see the Monte Carlo method",
     "Die Kennwerte sind Extremwerte; dieses Verfahren folgt den Zielpositionen, die in dieser Prüfung extrem sind, "
     "und sieht die Verzerrung von Extremwerten nicht, siehe Monte-Carlo-Methode"},
    {"The readings are not corrected for thermal expansion: over the travel they hold about {0#} µm of it, which the "
     "uncertainty does not include",
     "Die Messwerte sind nicht um die Wärmedehnung korrigiert: über den Weg enthalten sie etwa {0}\u00a0µm davon, "
     "welche die Unsicherheit nicht umfasst"},
    {"The station of the tracking interferometer is left out: {0}",
     "Die Station des nachführenden Interferometers ist weggelassen: {0}"},
    {"The temperature of the {0} was not given; 20 °C ± R(θ)/2 is assumed, and α counts as known",
     "Die Temperatur ({0}) wurde nicht angegeben; 20\u00a0°C ± R(θ)/2 ist angenommen, und α gilt als bekannt"},
    {"The temperature of the {0} was not given; it counts as 20 °C exactly",
     "Die Temperatur ({0}) wurde nicht angegeben; sie gilt als genau 20\u00a0°C"},
    {"The uncertainty is that of this machine: by how much the parameters of this test may differ from those that the "
     "axis has in the long run. Besides instruments and temperature it counts that {0#} approach per direction is only "
     "a sample.",
     "Die Unsicherheit ist die dieser Maschine: um wie viel die Kennwerte dieser Prüfung von denen abweichen können, "
     "die die Achse auf lange Sicht hat. Neben Messgeräten und Temperatur zählt, dass {0} Anfahrt je Richtung nur eine "
     "Stichprobe ist."},
    {"The uncertainty is that of this machine: by how much the parameters of this test may differ from those that the "
     "axis has in the long run. Besides instruments and temperature it counts that {0#} approaches per direction are "
     "only a sample.",
     "Die Unsicherheit ist die dieser Maschine: um wie viel die Kennwerte dieser Prüfung von denen abweichen können, "
     "die die Achse auf lange Sicht hat. Neben Messgeräten und Temperatur zählt, dass {0} Anfahrten je Richtung nur "
     "eine Stichprobe sind."},
    {"The uncertainty is that of this test: by how much the parameters may differ from those that the same approaches "
     "would have given with perfect instruments at 20 °C. The scatter of the machine itself is part of the result and "
     "not of its uncertainty.",
     "Die Unsicherheit ist die dieser Prüfung: um wie viel die Kennwerte von denen abweichen können, die dieselben "
     "Anfahrten mit vollkommenen Messgeräten bei 20\u00a0°C ergeben hätten. Die Streuung der Maschine selbst ist Teil "
     "des Ergebnisses und nicht seiner Unsicherheit."},
    {"Thermal expansion of the machine", "Wärmedehnung der Maschine"},
    {"Thermal expansion of the measuring device", "Wärmedehnung des Messgeräts"},
    {"Thermal factor of the {0}: u = {1#} µm/m by equation 15, {2#} µm/m by its exact distribution; the difference "
     "counts as a source of its own",
     "Wärmedehnungsfaktor ({0}): u = {1}\u00a0µm/m nach Gleichung 15, {2}\u00a0µm/m nach der exakten Verteilung; der "
     "Unterschied zählt als eigene Quelle"},
    {"Thermal factor of the {0}: u = {1#} µm/m by equation 15, {2#} µm/m by its exact distribution; the former is used",
     "Wärmedehnungsfaktor ({0}): u = {1}\u00a0µm/m nach Gleichung 15, {2}\u00a0µm/m nach der exakten Verteilung; der "
     "erste Wert wird verwendet"},
    {"U_M,DEVICE and U_E,DEVICE count as zero: right if the statement about the device includes its temperature, or if "
     "the device takes the temperature of the machine (A.6, A.8)",
     "U_M,DEVICE und U_E,DEVICE gelten als null: richtig, wenn die Angabe zum Messgerät dessen Temperatur einschließt "
     "oder das Messgerät die Temperatur der Maschine annimmt (A.6, A.8)"},
    {"U_MISALIGNMENT counts as zero because no misalignment was given; it grows as 1/L and is not negligible under 300 "
     "mm (1 mm over {0#} mm gives {1#} µm)",
     "U_MISALIGNMENT gilt als null, weil kein Ausrichtfehler angegeben wurde; es wächst mit 1/L und ist unter "
     "300\u00a0mm nicht vernachlässigbar (1\u00a0mm über {0}\u00a0mm ergibt {1}\u00a0µm)"},
    {"U_MISALIGNMENT grows as 1/L and is not negligible under 300 mm: {0#} µm at L = {1#} mm",
     "U_MISALIGNMENT wächst mit 1/L und ist unter 300\u00a0mm nicht vernachlässigbar: {0}\u00a0µm bei L = {1}\u00a0mm"},
    {"U_STATION is not in Annex A: it bounds, with 95 %, what a wrongly determined station does to the lengths along "
     "the line (Lee et al., eqs 17 to 23)",
     "U_STATION steht nicht in Anhang A: es begrenzt mit 95\u00a0%, was eine falsch bestimmte Station mit den Längen "
     "entlang der Linie macht (Lee et al., Gl. 17 bis 23)"},
    {"Uncertainty of the parameters", "Unsicherheit der Kennwerte"},
    {"Uncertainty of {0#}", "Unsicherheit von {0}"},
    {"Used by", "Verwendet von"},
    {"What to improve first ({0=})", "Was zuerst zu verbessern ist ({0})"},
    {"a + b·L", "a + b·L"},
    {"air temperature", "Lufttemperatur"},
    {"align.", "Ausr."},
    {"alike", "gleich"},
    {"all methods", "allen Verfahren"},
    {"any two positions", "je zwei Positionen"},
    {"appr.", "Anf."},
    {"arcsine from {0#} to {1#}", "Arkussinus von {0} bis {1}"},
    {"beyond eq. 15", "über Gl. 15 hinaus"},
    {"constant {0#}", "konstant {0}"},
    {"corrected", "korrigiert"},
    {"derived", "abgeleitet"},
    {"each reading", "jedem Messwert"},
    {"each run", "jedem Durchlauf"},
    {"each target", "jeder Zielposition"},
    {"each target and direction", "jeder Zielposition und Richtung"},
    {"each target for itself: Student’s t for its mean, χ² for its variance",
     "jede Zielposition für sich: Student-t für ihren Mittelwert, χ² für ihre Varianz"},
    {"empirical, {0#} values", "empirisch, {0} Werte"},
    {"entered for this test", "zu dieser Prüfung eingetragen"},
    {"file", "Datei"},
    {"flag", "Aufruf"},
    {"floored", "auf 0 gesetzt"},
    {"for linear axes only", "nur für Linearachsen"},
    {"from", "von"},
    {"from a normal distribution about the value, or from Student’s t where degrees of freedom are known",
     "aus einer Normalverteilung um den Wert, oder aus Students t, wo Freiheitsgrade bekannt sind"},
    {"from the angle over L", "aus dem Winkel über L"},
    {"from the misalignment over L", "aus dem Ausrichtfehler über L"},
    {"from the targets", "aus den Zielpositionen"},
    {"instr.", "Gerät"},
    {"instrument {0=}", "Messgerät {0}"},
    {"largest of the sensors", "größter Wert der Sensoren"},
    {"measured travel", "Messweg"},
    {"normal, mean {0#}, standard deviation {1#}", "normal, Mittelwert {0}, Standardabweichung {1}"},
    {"not defined", "nicht definiert"},
    {"not given; left out", "nicht angegeben; weggelassen"},
    {"not used: {0=} takes its place", "nicht verwendet: {0} tritt an die Stelle"},
    {"not used: {0}", "nicht verwendet: {0}"},
    {"of a + b·L", "aus a + b·L"},
    {"of the NDE correction", "der NDE-Korrektur"},
    {"of the scale", "des Maßstabs"},
    {"of √(a² + (b·L)²)", "aus √(a² + (b·L)²)"},
    {"other", "übrige"},
    {"over {0#}", "über {0}"},
    {"over {0#} narrower", "über {0} enger"},
    {"over {0#} wider", "über {0} weiter"},
    {"part of the device’s statement", "in der Angabe zum Messgerät enthalten"},
    {"part of the scatter", "Teil der Streuung"},
    {"pooled: the scatter at all targets tells about that at each",
     "gemeinsam: Die Streuung an allen Zielpositionen sagt etwas über die an jeder einzelnen"},
    {"res.", "Aufl."},
    {"scale", "Maßstab"},
    {"t with {0#} degrees of freedom, location {1#}, scale {2#}", "t mit {0} Freiheitsgraden, Lage {1}, Skala {2}"},
    {"the beam follows the reflector", "der Strahl folgt dem Reflektor"},
    {"the whole test", "der ganzen Prüfung"},
    {"therm.", "therm."},
    {"this machine: what the axis does in the long run, of which the approaches are a sample",
     "diese Maschine: was die Achse auf lange Sicht tut, wovon die Anfahrten eine Stichprobe sind"},
    {"this test: what the same approaches would have given with perfect instruments at 20 °C",
     "diese Prüfung: was dieselben Anfahrten mit vollkommenen Messgeräten bei 20\u00a0°C ergeben hätten"},
    {"to", "bis"},
    {"trapezoidal from {0#} to {1#}, top to base {2#}", "Trapez von {0} bis {1}, Oberseite zu Grundseite {2}"},
    {"triangular from {0#} to {1#}", "Dreieck von {0} bis {1}"},
    {"u by the GUM", "u nach dem GUM"},
    {"u, mean, bias and the histogram are those of one hypothesis about the noise, of each parameter the one with the "
     "largest u; the interval holds for all of them, and for noise of any size up to what they say",
     "u, Mittel, systematische Abweichung und Histogramm gehören zu einer Annahme über das Rauschen, bei jedem "
     "Kennwert zu der mit dem größten u; das Intervall gilt für alle und für Rauschen jeder Größe bis zu dem, was sie "
     "besagen"},
    {"u, mean, bias and the histogram are those of one hypothesis about the noise, of each parameter the one with the "
     "largest u; the interval holds for all of them, and for noise of any size up to what they say.",
     "u, Mittel, systematische Abweichung und Histogramm gehören zu einer Annahme über das Rauschen, bei jedem "
     "Kennwert zu der mit dem größten u; das Intervall gilt für alle und für Rauschen jeder Größe bis zu dem, was sie "
     "besagen."},
    {"uniform from {0#} to {1#}", "Rechteck von {0} bis {1}"},
    {"uniform from {0#} to {1#}, limits ± {2#}", "Rechteck von {0} bis {1}, Grenzen ± {2}"},
    {"whole runs drawn with replacement (bootstrap)", "ganze Durchläufe mit Zurücklegen gezogen (Bootstrap)"},
    {"{0#} = {1#}", "{0} = {1}"},
    {"{0#} = {1#} ({2})", "{0} = {1} ({2})"},
    {"{0#} for a probability of about 95 %: 2, or after Student’s t where {1#} is finite (GUM, G.4). A parameter "
     "without a row is not touched by any source.",
     "{0} für eine Wahrscheinlichkeit von etwa 95\u00a0%: 2, oder nach Student-t, wo {1} endlich ist (GUM, G.4). Auf "
     "einen Kennwert ohne Zeile wirkt keine Quelle."},
    {"{0#} from", "{0} von"},
    {"{0#} from the air temperature", "{0} aus der Lufttemperatur"},
    {"{0#} narrower", "{0} enger"},
    {"{0#} stated", "{0} angegeben"},
    {"{0#} trials, as asked for; every u is stable within its numerical tolerance",
     "{0} Versuche, wie verlangt; jedes u ist innerhalb seiner numerischen Toleranz stabil"},
    {"{0#} trials, as asked for; not stable within the numerical tolerance: {1#}",
     "{0} Versuche, wie verlangt; innerhalb der numerischen Toleranz nicht stabil: {1}"},
    {"{0#} trials, as many as the numerical tolerance asked for (JCGM 101, 7.9); every u is stable within its "
     "numerical tolerance",
     "{0} Versuche, so viele, wie die numerische Toleranz verlangte (JCGM 101, 7.9); jedes u ist innerhalb seiner "
     "numerischen Toleranz stabil"},
    {"{0#} trials, the most that were allowed; not stable within the numerical tolerance: {1#}",
     "{0} Versuche, die größte erlaubte Zahl; innerhalb der numerischen Toleranz nicht stabil: {1}"},
    {"{0#} wider", "{0} weiter"},
    {"{0#}, exact (A.1)", "{0}, exakt (A.1)"},
    {"{0#}, linear (15)", "{0}, linear (15)"},
    {"{0#}, used", "{0}, verwendet"},
    {"{0#}: the length from where the instrument was set to zero, else from the first target.",
     "{0}: die Länge ab der Stelle, an der das Messgerät genullt wurde, sonst ab der ersten Zielposition."},
    {"{0=}; the same seed gives the same numbers on any number of threads.",
     "{0}; derselbe Startwert ergibt bei jeder Zahl von Threads dieselben Zahlen."},
    {"{0} acts as noise of the readings and is taken as normal with its standard deviation",
     "{0} wirkt als Rauschen der Messwerte und wird als normalverteilt mit der zugehörigen Standardabweichung "
     "angesetzt"},
    {"{0} is left out: at L = {1#} m it has no sensible value",
     "{0} ist weggelassen: bei L = {1} m ergibt sich kein sinnvoller Wert"},
    {"{0}, {1#} of the variance; without it {2#} would fall from {3#} to about {4#}",
     "{0}, {1} der Varianz; ohne diesen Beitrag sänke {2} von {3} auf etwa {4}"},
    {"{0}, {1#} of the variance; without it {2#} would fall from {3#} to about {4#}.",
     "{0}, {1} der Varianz; ohne diesen Beitrag sänke {2} von {3} auf etwa {4}."},
    {"{0}, {1#} of the variance; {2#} = {3#}", "{0}, {1} der Varianz; {2} = {3}"},
    {"{0}, {1#} of the variance; {2#} = {3#}.", "{0}, {1} der Varianz; {2} = {3}."},
    {"{0}; part of the scatter", "{0}; Teil der Streuung"},
    {"ΔT_e from the air temperature", "ΔT_e aus der Lufttemperatur"},
    {"α of the machine tool was not given; 12 µm/(m·°C) is assumed (Table A.2)",
     "α der Werkzeugmaschine wurde nicht angegeben; 12\u00a0µm/(m·°C) ist angenommen (Tabelle A.2)"},
    {"α of the {0} was not given; 12 µm/(m·°C) is assumed (Table A.2)",
     "α ({0}) wurde nicht angegeben; 12\u00a0µm/(m·°C) ist angenommen (Tabelle A.2)"},
    {"δ: half a unit of the last significant digit of {0#} that shall be right (JCGM 101, 7.9.2). Stable: mean and "
     "{1#} are known better than δ under every hypothesis about the noise, and the ends of its interval better than "
     "half a unit of the last such digit of half the widest.",
     "δ: halbe Einheit der letzten signifikanten Stelle von {0}, die richtig sein soll (JCGM 101, 7.9.2). Stabil: "
     "Mittelwert und {1} sind unter jeder Annahme über das Rauschen genauer als δ bekannt und die Grenzen ihres "
     "Intervalls genauer als eine halbe Einheit der letzten solchen Stelle der halben Breite des weitesten."},
    {"δ: half a unit of the last significant digit of {0#} that shall be right (JCGM 101, 7.9.2). Stable: mean, {1#} "
     "and the ends of the symmetric interval are known better than δ.",
     "δ: halbe Einheit der letzten signifikanten Stelle von {0}, die richtig sein soll (JCGM 101, 7.9.2). Stabil: "
     "Mittelwert, {1} und die Grenzen des symmetrischen Intervalls sind genauer als δ bekannt."},
    {"√(a² + (b·L)²)", "√(a² + (b·L)²)"},
};

}  // namespace

const std::span<const Phrase> german_uncertainty{uncertainty_rows};

}  // namespace axiometry::language
