// SPDX-License-Identifier: Apache-2.0
// What departs from the standard, what is missing, what is worth a note.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase findings_rows[] = {
    {"--correct air=ciddor", "--correct air=ciddor"},
    {"--correct air=ciddor with temperature, pressure and humidity of the air",
     "--correct air=ciddor mit Temperatur, Druck und Feuchte der Luft"},
    {"--correct dead-path", "--correct dead-path"},
    {"--correct dead-path with temperature, pressure and humidity of the air",
     "--correct dead-path mit Temperatur, Druck und Feuchte der Luft"},
    {"--correct gain", "--correct gain"},
    {"--correct nde", "--correct nde"},
    {"--correct nde, or nde.applied = yes where the instrument has corrected it,",
     "--correct nde, oder nde.applied bejahen, wo das Messgerät sie korrigiert hat"},
    {"--correct sign", "--correct sign"},
    {"Annex A has no formula for {0=}: its uncertainties do not contain it",
     "Anhang A hat keine Formel für {0}: seine Unsicherheiten enthalten es nicht"},
    {"NDE correction: {0}", "NDE-Korrektur: {0}"},
    {"Table 1, above {0#}", "Tabelle 1, über {0}"},
    {"Table 1, up to {0#}", "Tabelle 1, bis {0}"},
    {"a correction for expansion with {0#} µm/(m·°C), which is not the coefficient of the machine, about {1#} over "
     "the travel,",
     "eine Korrektur der Ausdehnung mit {0} µm/(m·°C), der nicht der Koeffizient der Maschine ist, etwa {1} "
     "über den Weg,"},
    {"a dead path in an air that was not measured", "eine Totstrecke in einer Luft, die nicht gemessen wurde,"},
    {"a dead path, about {0#} in the course of the test,", "eine Totstrecke, etwa {0} im Lauf der Prüfung,"},
    {"a drift was taken out that was estimated from the readings themselves: what the machine does while it warms up "
     "is gone with it",
     "eine aus den Messwerten selbst geschätzte Drift wurde herausgerechnet: was die Maschine beim Warmwerden tut, ist "
     "mit ihr verschwunden"},
    {"a gain of {0#} of the sensor", "eine Verstärkung des Sensors von {0}"},
    {"a gain of {0#} of the sensor was given, and its readings were taken as they are",
     "für den Sensor wurde eine Verstärkung von {0} angegeben, und seine Messwerte wurden genommen, wie sie sind"},
    {"a later one takes its place", "eine spätere tritt an die Stelle"},
    {"a mean interval of about 250 mm", "mittlerer Abstand etwa 250\u00a0mm"},
    {"a rotary axis has no line beside which a station could stand",
     "eine Drehachse hat keine Linie, neben der eine Station stehen könnte"},
    {"a sensor ({0=}) without temperature at the {1}", "ein Sensor ({0}) ohne Temperatur am {1}"},
    {"a sensor without location", "ein Sensor ohne Ort"},
    {"a sensor without temperature at the {0}", "ein Sensor ohne Temperatur am {0}"},
    {"a warm-up is stated not to have been made; whether that was agreed is not",
     "es ist angegeben, dass kein Warmlauf stattfand; ob das vereinbart war, nicht"},
    {"air humidity at the start and the end", "Luftfeuchte am Anfang und am Ende"},
    {"air pressure at the start and the end", "Luftdruck am Anfang und am Ende"},
    {"air temperature at the start and the end", "Lufttemperatur am Anfang und am Ende"},
    {"air: {0}", "Luft: {0}"},
    {"an artefact takes the place of the measuring device", "ein Prüfkörper tritt an die Stelle des Messgeräts"},
    {"at any length", "bei jeder Länge"},
    {"axis: {0}", "Achse: {0}"},
    {"component {0#} without {1}", "Komponente {0} ohne {1}"},
    {"environmental variation (A.9)", "Umgebungsschwankung (A.9)"},
    {"equipment: test equipment", "Messmittel"},
    {"equipment: {0}", "Messmittel: {0}"},
    {"expansion coefficient of the machine tool (A.7)", "Ausdehnungskoeffizient der Werkzeugmaschine (A.7)"},
    {"found a calibrated position {0#} that is no number, expected one in mm",
     "kalibrierte Position {0} ohne Zahl; erwartet: eine in mm"},
    {"found a dwell of 0 s, expected the axis at rest while it is read",
     "Verweilzeit von 0 s; erwartet: die Achse in Ruhe, während sie gelesen wird"},
    {"found a feed of 0, expected the one that the axis was driven with",
     "gefunden: ein Vorschub von 0, erwartet der, mit dem die Achse gefahren wurde"},
    {"found a further period of {0#} with an amplitude of {1#} in what the curve leaves",
     "eine weitere Periode von {0} mit einer Amplitude von {1} in dem, was die Kurve übrig lässt"},
    {"found a further period of {0#} with an amplitude of {1#} in what the curve leaves; it is {2#} times the first, "
     "which may be its harmonic",
     "eine weitere Periode von {0} mit einer Amplitude von {1} in dem, was die Kurve übrig lässt; sie ist das "
     "{2}-Fache der ersten, die ihre Oberwelle sein kann"},
    {"found a line along which {0#} axes move: a diagonal displacement test after {1=}, evaluated as one of a single "
     "axis; the text of that standard was not at hand. Errors of the axes may cancel along a diagonal, so that a small "
     "E proves little alone",
     "eine Linie, auf der sich {0} Achsen bewegen: eine Diagonalprüfung nach {1}, ausgewertet wie die einer einzelnen "
     "Achse; der Text dieser Norm lag nicht vor. Abweichungen der Achsen können sich entlang einer Diagonale aufheben, "
     "sodass ein kleines E für sich allein wenig beweist"},
    {"found a period of {0#} given, expected {1#} after axis.expected_period",
     "eine vorgegebene Periode von {0}; nach axis.expected_period erwartet: {1}"},
    {"found a period of {0#}, expected {1#} after axis.expected_period",
     "eine Periode von {0}; nach axis.expected_period erwartet: {1}"},
    {"found a residual standard deviation of {0#}, where the scatter of the runs lets expect {1#}: the deviations hold "
     "more than a line and this period",
     "eine Reststandardabweichung von {0}, wo die Streuung der Durchläufe {1} erwarten lässt: die Abweichungen "
     "enthalten mehr als eine Gerade und diese Periode"},
    {"found a standard uncertainty of {0#} mm, expected one from 0 to {1#}",
     "eine Standardunsicherheit von {0}\u00a0mm; erwartet: 0 bis {1}"},
    {"found a straight slope of {0#} µm/m, without which {1=} would be {2#} instead of {3#}; such a slope comes "
     "from a scale, an expansion or a correction, and nothing of it is removed",
     "eine gerade Steigung von {0}\u00a0µm/m, ohne die {1} {2} statt {3} wäre; sie stammt von einem "
     "Maßstab, einer Dehnung oder einer Korrektur, und nichts davon ist abgezogen"},
    {"found a straight slope of {0#} µm/m, without which {1=} would be {2#} instead of {3#}; such a slope comes "
     "from a scale, an expansion, a squareness error or a correction, and nothing of it is removed",
     "eine gerade Steigung von {0}\u00a0µm/m, ohne die {1} {2} statt {3} wäre; sie stammt von einem "
     "Maßstab, einer Dehnung, einer Rechtwinkligkeitsabweichung oder einer Korrektur, und nichts davon ist abgezogen"},
    {"found a test on {0=}, when its equipment was out of calibration: {1=}",
     "Prüfung am {0}, an dem die Kalibrierung ihrer Messmittel nicht galt: {1}"},
    {"found a tolerance of {0=} ({1}) for a test with {2=}, where {3=} does not exist: no verdict on it, and none that "
     "the test conforms",
     "Grenzwert von {0} ({1}) für eine Prüfung mit {2}, in der es {3} nicht gibt: keine Entscheidung darüber und "
     "keine, dass die Prüfung konform ist"},
    {"found a user-defined cycle, expected the standard test cycle (Figure 1)",
     "benutzerdefinierter Zyklus; erwartet: der Normprüfzyklus (Bild 1)"},
    {"found an NDE correction with {0}", "NDE-Korrektur mit folgenden Lücken: {0}"},
    {"found an artefact test whose deviations are already made, expected readings",
     "eine Prüfung mit Prüfkörper, deren Abweichungen schon gebildet sind; erwartet: Messwerte"},
    {"found an artefact that spans {0#} of an axis travel of {1#}, expected it to be set up again with an overlap "
     "where the whole travel counts; the results hold for that part only",
     "ein Prüfkörper, der {0} eines Verfahrwegs von {1} überdeckt; wo der ganze Weg zählt, wird erwartet, dass er mit "
     "Überlappung erneut aufgestellt wird; die Ergebnisse gelten nur für diesen Teil"},
    {"found an end of the measurement travel approached from one side, {0}, expected both sides",
     "ein Ende des Messwegs ist nur von einer Seite angefahren, {0}; erwartet: von beiden Seiten"},
    {"found approaches from one direction only ({0#}), expected five from each; bidirectional parameters do not exist",
     "Anfahrten nur aus einer Richtung ({0}); erwartet: fünf aus jeder; beidseitige Kennwerte gibt es nicht"},
    {"found approaches from one direction only ({0#}), expected one from each; bidirectional parameters do not exist",
     "Anfahrten nur aus einer Richtung ({0}); erwartet: eine aus jeder; beidseitige Kennwerte gibt es nicht"},
    {"found axis.line_origin_mm or axis.line_direction that make no line in space, expected three numbers each of a "
     "linear axis, the direction not zero",
     "axis.line_origin_mm oder axis.line_direction ergeben keine Linie im Raum; erwartet: je drei Zahlen einer "
     "Linearachse, die Richtung nicht null"},
    {"found calibrated positions of an artefact on a rotary axis, expected a linear one (Annex D)",
     "kalibrierte Positionen eines Prüfkörpers an einer Drehachse; erwartet: eine Linearachse (Anhang D)"},
    {"found calibrated positions of an artefact that were not used: the readings were taken for deviations",
     "kalibrierte Positionen eines Prüfkörpers, die nicht verwendet wurden: die Messwerte wurden als Abweichungen "
     "genommen"},
    {"found equally spaced targets (every {0#}): a period of {1#} and one of {2#} give the same readings, expected "
     "uneven steps to tell them apart",
     "gleichabständige Zielpositionen (alle {0}): eine Periode von {1} und eine von {2} ergeben dieselben Messwerte; "
     "erwartet: ungleiche Schritte, um sie zu unterscheiden"},
    {"found nearly the same reversal error at every target, {0#} on average, without which {1#} would be {2#} instead "
     "of {3#}; such a reversal error comes from play or from its compensation, and nothing of it is removed",
     "an allen Zielpositionen nahezu dieselbe Umkehrspanne, im Mittel {0}, ohne die {1} {2} statt {3} wäre; sie stammt "
     "von Spiel oder von dessen Kompensation, und nichts davon ist abgezogen"},
    {"found no calibrated positions of the artefact, expected artefact.calibrated_positions, one per target",
     "keine kalibrierten Positionen des Prüfkörpers; erwartet: artefact.calibrated_positions, eine je Zielposition"},
    {"found no reading at {0}, expected one from every approach", "kein Messwert an {0}; erwartet: einer je Anfahrt"},
    {"found no target at {0}, expected these principal positions where practical",
     "keine Zielposition bei {0}; erwartet: diese Hauptpositionen, wo es möglich ist"},
    {"found no temperature of the artefact, expected a sensor with role equipment and "
     "nde.equipment_expansion_um_per_m_C; its calibrated positions are used as at 20 °C",
     "keine Temperatur des Prüfkörpers; erwartet: ein Sensor mit der Rolle equipment und "
     "nde.equipment_expansion_um_per_m_C; die kalibrierten Positionen werden wie bei 20\u00a0°C verwendet"},
    {"found places of the artefact probed from one side only, expected both: the reversal error does not show",
     "Stellen des Prüfkörpers nur von einer Seite angetastet; erwartet: von beiden; die Umkehrspanne zeigt sich nicht"},
    {"found readings from both directions, expected one: each is evaluated for itself",
     "Messwerte aus beiden Richtungen; erwartet: eine; jede wird für sich ausgewertet"},
    {"found readings from which a drift was taken, of which nobody can tell that the machine had no part in it",
     "gefunden: Messwerte, von denen eine Drift abgezogen wurde, von der niemand sagen kann, dass die Maschine keinen "
     "Teil daran hatte"},
    {"found s_i smaller than U_EVE/2 at target {0#}; the corrected repeatability takes 0 there",
     "s_i kleiner als U_EVE/2 an der Zielposition {0}; die korrigierte Wiederholpräzision nimmt dort 0 an"},
    {"found s_i smaller than U_EVE/2 at targets {0}; the corrected repeatability takes 0 there",
     "s_i kleiner als U_EVE/2 an den Zielpositionen {0}; die korrigierte Wiederholpräzision nimmt dort 0 an"},
    {"found steps of the artefact (every {0#}) that hold {1#} whole period of {2#}: a periodic error is the same at "
     "all of them and does not show",
     "Schritte des Prüfkörpers (alle {0}), die {1} ganze Periode von {2} enthalten: eine periodische Abweichung ist an "
     "allen gleich und zeigt sich nicht"},
    {"found steps of the artefact (every {0#}) that hold {1#} whole periods of {2#}: a periodic error is the same at "
     "all of them and does not show",
     "Schritte des Prüfkörpers (alle {0}), die {1} ganze Perioden von {2} enthalten: eine periodische Abweichung ist "
     "an allen gleich und zeigt sich nicht"},
    {"found targets every {0#} on average for a period of {1#}, that is {2#} per period, expected four or more",
     "Zielpositionen im Mittel alle {0} für eine Periode von {1}, das sind {2} je Periode; erwartet: vier oder mehr"},
    {"found temperatures of the artefact and no expansion coefficient, expected nde.equipment_expansion_um_per_m_C (0 "
     "for an artefact that does not expand)",
     "Temperaturen des Prüfkörpers ohne Ausdehnungskoeffizienten; erwartet: nde.equipment_expansion_um_per_m_C (0 für "
     "einen Prüfkörper, der sich nicht dehnt)"},
    {"found test equipment not fully identified: {0}", "Messmittel nicht vollständig bezeichnet: {0}"},
    {"found the calibrated position {0#} at {1#} after {2#}, expected ascending ones in the order of the targets",
     "kalibrierte Position {0} bei {1} nach {2}; erwartet: aufsteigende in der Reihenfolge der Zielpositionen"},
    {"found the calibrated position {0#} at {1#} from the first, its target at {2#}, expected them within {3#} of each "
     "other (a tenth of the interval)",
     "kalibrierte Position {0} bei {1} von der ersten, ihre Zielposition bei {2}; erwartet: höchstens {3} voneinander "
     "(ein Zehntel des Abstands)"},
    {"found the cycle declared unidirectional and readings from both directions, expected the standard test cycle "
     "(Figure 1)",
     "als einseitig angegebener Zyklus mit Messwerten aus beiden Richtungen; erwartet: der Normprüfzyklus (Bild 1)"},
    {"found the equal steps of the artefact (every {0#}): they do not show an error whose period is a part of them; "
     "axis.expected_period is not known",
     "gleiche Schritte des Prüfkörpers (alle {0}): sie zeigen keine Abweichung, deren Periode ein Teil von ihnen ist; "
     "axis.expected_period ist nicht bekannt"},
    {"found the highest peak at the end of the searched band, at {0#}: the error may have a period beyond it, or none "
     "(a bow of the axis looks so)",
     "höchste Spitze am Ende des durchsuchten Bereichs, bei {0}: die Abweichung kann eine Periode jenseits davon haben "
     "oder keine (eine Durchbiegung der Achse sieht so aus)"},
    {"found the pilgrim cycle, expected the standard test cycle (Figure 1)",
     "Pilgerschrittzyklus; erwartet: der Normprüfzyklus (Bild 1)"},
    {"found the readings to be positions that the machine indicated at {0#} calibrated places of the artefact; the "
     "deviations are calibrated less indicated positions",
     "die Messwerte sind Positionen, die die Maschine an {0} kalibrierten Stellen des Prüfkörpers angezeigt hat; die "
     "Abweichungen sind kalibrierte minus angezeigte Positionen"},
    {"found the same reading in every run at every target, expected some scatter; copied or coarsely rounded readings "
     "make every repeatability zero",
     "an jeder Zielposition derselbe Messwert in jedem Durchlauf; erwartet: eine gewisse Streuung; kopierte oder grob "
     "gerundete Messwerte machen jede Wiederholpräzision zu null"},
    {"found the same reading {0=} in every run at every target, expected some scatter; copied or coarsely rounded "
     "readings make {1=} zero",
     "an jeder Zielposition derselbe Messwert {0} in jedem Durchlauf; erwartet: eine gewisse Streuung; kopierte oder "
     "grob gerundete Messwerte machen {1} zu null"},
    {"found the step cycle, expected the standard test cycle (Figure 1): not for acceptance without special written "
     "agreement",
     "Stufenzyklus; erwartet: der Normprüfzyklus (Bild 1); ohne besondere schriftliche Vereinbarung nicht für die "
     "Abnahme"},
    {"found two decision rules: {0=} ({1}) takes the place of {2=} ({3})",
     "gefunden: zwei Entscheidungsregeln, {0} ({1}) tritt an die Stelle von {2} ({3})"},
    {"found two limits of {0=}: {1#} ({2}) takes the place of {3#} ({4})",
     "zwei Grenzwerte von {0}: {1} ({2}) tritt an die Stelle von {3} ({4})"},
    {"found {0#} between {1} and {2}, more than twice the mean interval of {3#}, expected targets spread evenly but "
     "for the random shift",
     "{0} zwischen {1} und {2}, mehr als das Doppelte des mittleren Abstands von {3}; erwartet: bis auf den zufälligen "
     "Versatz gleichmäßig verteilte Zielpositionen"},
    {"found {0#} calibrated positions of the artefact for {1#} targets, expected one per target",
     "{0} kalibrierte Positionen des Prüfkörpers für {1} Zielpositionen; erwartet: eine je Zielposition"},
    {"found {0#} equally spaced targets (every {1#}), expected a random shift of each where the positions can be "
     "chosen: equal steps can hide a periodic error",
     "{0} gleichabständige Zielpositionen (alle {1}); erwartet: jede zufällig versetzt, wo die Positionen gewählt "
     "werden können; gleiche Schritte können eine periodische Abweichung verbergen"},
    {"found {0#} measured of an axis travel of {1#}; the results hold for that part only",
     "{0} eines Verfahrwegs von {1} gemessen; die Ergebnisse gelten nur für diesen Teil"},
    {"found {0#} measured, more than the five revolutions that the test covers",
     "{0} gemessen, mehr als die fünf Umdrehungen, die die Prüfung umfasst"},
    {"found {0#} of {1#} targets and directions falling from run to run, by {2#} on average from the first run to the "
     "last, expected no ordered progression: a sign that the machine was not thermally stable",
     "an {0} von {1} Zielpositionen und Richtungen fallen die Messwerte von Durchlauf zu Durchlauf, im Mittel um {2} "
     "vom ersten zum letzten; erwartet: kein geordneter Gang; ein Zeichen, dass die Maschine thermisch nicht stabil "
     "war"},
    {"found {0#} of {1#} targets and directions rising from run to run, by {2#} on average from the first run to the "
     "last, expected no ordered progression: a sign that the machine was not thermally stable",
     "an {0} von {1} Zielpositionen und Richtungen steigen die Messwerte von Durchlauf zu Durchlauf, im Mittel um {2} "
     "vom ersten zum letzten; erwartet: kein geordneter Gang; ein Zeichen, dass die Maschine thermisch nicht stabil "
     "war"},
    {"found {0#} of {1#} targets on sampling points of the compensation: {2}, expected other positions for acceptance "
     "or reverification",
     "{0} von {1} Zielpositionen auf Stützpunkten der Kompensation: {2}; erwartet: andere Positionen für Abnahme oder "
     "Wiederholprüfung"},
    {"found {0#} of {1#} targets on sampling points of the compensation: {2}; not for acceptance or reverification",
     "{0} von {1} Zielpositionen auf Stützpunkten der Kompensation: {2}; nicht für Abnahme oder Wiederholprüfung"},
    {"found {0#} periods of {1#} over {2#}, expected two or more",
     "{0} Perioden von {1} über {2}; erwartet: zwei oder mehr"},
    {"found {0#} smaller than {1#}/2 at target {2#}; the corrected repeatability takes 0 there",
     "{0} kleiner als {1}/2 an der Zielposition {2}; die korrigierte Wiederholpräzision nimmt dort 0 an"},
    {"found {0#} smaller than {1#}/2 at targets {2}; the corrected repeatability takes 0 there",
     "{0} kleiner als {1}/2 an den Zielpositionen {2}; die korrigierte Wiederholpräzision nimmt dort 0 an"},
    {"found {0#} standard uncertainties, expected two, one for each direction across the line",
     "{0} Standardunsicherheiten; erwartet: zwei, eine für jede Richtung quer zur Linie"},
    {"found {0#} standard uncertainty, expected two, one for each direction across the line",
     "{0} Standardunsicherheit; erwartet: zwei, eine für jede Richtung quer zur Linie"},
    {"found {0#} target over {1#}, expected at least {2#} ({3})",
     "{0} Zielposition über {1}; erwartet: mindestens {2} ({3})"},
    {"found {0#} targets over {1#}, expected at least {2#} ({3})",
     "{0} Zielpositionen über {1}; erwartet: mindestens {2} ({3})"},
    {"found {0#} °C at {1} and no correction for differential expansion, expected one off 20 °C: the machine expands "
     "by about {2#} over {3#} at {4#} µm/(m·°C)",
     "{0}\u00a0°C ({1}) und keine Korrektur der Differenzdehnung; abseits von 20\u00a0°C wird eine erwartet: die "
     "Maschine dehnt sich über {3} um etwa {2} bei {4}\u00a0µm/(m·°C)"},
    {"found {0#} °C at {1} and no word whether differential expansion was corrected, expected nde.applied",
     "{0}\u00a0°C ({1}) und keine Angabe, ob die Differenzdehnung korrigiert wurde; erwartet: nde.applied"},
    {"found {0} at the end of the axis travel, expected room to approach it from beyond",
     "{0} am Ende des Verfahrwegs; erwartet: Raum, um sie von jenseits anzufahren"},
    {"found {0} going from {1#} °C to {2#} °C during the test; the permissible gradient is to be agreed",
     "Temperaturgang während der Prüfung: {0} von {1}\u00a0°C auf {2}\u00a0°C; der zulässige Gradient ist zu "
     "vereinbaren"},
    {"found {0} over {1#}, expected {2#} in each direction", "{0} über {1}; erwartet: {2} in jeder Richtung"},
    {"found {0} over {1#}, expected {2#} in each direction; R and A over such a travel are no parameters of the "
     "standard",
     "{0} über {1}; erwartet: {2} in jeder Richtung; R und A über einen solchen Weg sind keine Kennwerte der Norm"},
    {"it means nothing on a rotary axis", "an einer Drehachse bedeutet es nichts"},
    {"it takes a constant part and one per metre to have a sum",
     "für eine Summe braucht es einen festen Teil und einen je Meter"},
    {"its position along the line was not given (tracking.station_position)",
     "ihre Position entlang der Linie wurde nicht angegeben (tracking.station_position)"},
    {"its uncertainty was not given (tracking.station_uncertainty_mm)",
     "ihre Unsicherheit wurde nicht angegeben (tracking.station_uncertainty_mm)"},
    {"machine: {0}", "Maschine: {0}"},
    {"manufacturer", "Hersteller"},
    {"measuring device (A.1 to A.3)", "Messgerät (A.1 bis A.3)"},
    {"misalignment (A.4)", "Ausrichtfehler (A.4)"},
    {"no sensor with the role machine", "kein Sensor mit der Rolle machine"},
    {"no uncertainty is stated after Annex A: nothing was given of {0}",
     "nach Anhang A ist keine Unsicherheit angegeben; es fehlen Angaben zu: {0}"},
    {"no uncertainty is stated of {0#}", "es ist keine Unsicherheit angegeben von {0}"},
    {"not given, but expected in the report – {0}", "nicht angegeben, im Bericht aber erwartet – {0}"},
    {"of the axis", "der Achse"},
    {"of the command line", "der Befehlszeile"},
    {"of the test's file", "der Datei der Prüfung"},
    {"of the tolerance table", "der Toleranztabelle"},
    {"one coefficient for both", "ein Koeffizient für beides"},
    {"serial number", "Seriennummer"},
    {"target {0#} ({1#}) {2#} every run", "Zielposition {0} ({1}) {2} in jedem Durchlauf"},
    {"target {0#} ({1#}) {2#} run {3#}", "Zielposition {0} ({1}) {2} Durchlauf {3}"},
    {"temperature measurement of the machine tool (A.5)", "Temperaturmessung der Werkzeugmaschine (A.5)"},
    {"temperature: {0}", "Temperatur: {0}"},
    {"test: {0}", "Prüfung: {0}"},
    {"the air", "Luft"},
    {"the air sensor", "Luftsensor"},
    {"the air sensor ({0=})", "Luftsensor ({0})"},
    {"the air temperature is not known", "die Lufttemperatur ist nicht bekannt"},
    {"the archive states {0=} of {1=}, which is left out: part of what is said of its errors is stated elsewhere, and "
     "a certificate is taken as a whole",
     "das Archiv nennt {0} für {1}, was weggelassen ist: ein Teil der Angaben zu seinen Fehlern steht anderswo, und "
     "ein Schein gilt als Ganzes"},
    {"the artefact without {0}", "der Prüfkörper ohne {0}"},
    {"the axis travels {0#}: the test over its whole travel with one approach from each direction is also needed",
     "die Achse verfährt {0}: die Prüfung über den ganzen Verfahrweg mit einer Anfahrt aus jeder Richtung ist "
     "zusätzlich nötig"},
    {"the beam of a tracking interferometer follows the reflector",
     "der Strahl eines nachführenden Interferometers folgt dem Reflektor"},
    {"the calibration of the {0} is put together from two sources: {1=} ({2}) and {3=} ({4})",
     "die Kalibrierung ({0}) ist aus zwei Quellen zusammengesetzt: {1} ({2}) und {3} ({4})"},
    {"the distribution of {0=} takes its place in GUM and Monte Carlo",
     "die Verteilung von {0} tritt in GUM und Monte Carlo an die Stelle"},
    {"the equipment sensor", "Sensor des Messmittels"},
    {"the equipment sensor ({0=})", "Sensor des Messmittels ({0})"},
    {"the expansion coefficient of the {0} is not known", "der Ausdehnungskoeffizient ({0}) ist nicht bekannt"},
    {"the first target at {0#}", "die erste Zielposition bei {0}"},
    {"the index of refraction of an air that was not measured", "die Brechzahl einer Luft, die nicht gemessen wurde,"},
    {"the index of refraction of the air, about {0#} over the travel,",
     "die Brechzahl der Luft, etwa {0} über den Weg,"},
    {"the last target at {0#}", "die letzte Zielposition bei {0}"},
    {"the limit of {0#} of the test's file, {1#}, was taken away for this test",
     "der Grenzwert von {0} aus der Datei der Prüfung, {1}, wurde für diese Prüfung weggenommen"},
    {"the limits of the axis have changed since this version was evaluated, and its verdicts rest on those of its day: "
     "{0#}",
     "die Grenzwerte der Achse haben sich geändert, seit diese Version ausgewertet wurde, und ihre Entscheidungen "
     "beruhen auf denen jenes Tages: {0}"},
    {"the machine sensor", "Sensor der Maschine"},
    {"the machine sensor ({0=})", "Sensor der Maschine ({0})"},
    {"the readings reach over {0#}", "die Messwerte reichen über {0}"},
    {"the readings were corrected for expansion with {0=} µm/(m·°C), the uncertainty takes {1=} ({2})",
     "die Messwerte sind mit {0} µm/(m·°C) um die Dehnung korrigiert, die Unsicherheit verwendet {1} ({2})"},
    {"the readings were corrected for expansion with {0=} µm/(m·°C), the uncertainty takes {1=} ({2}); of ΔT = {3#} °C "
     "over L that leaves {4#} µm, which no method contains",
     "die Messwerte sind mit {0} µm/(m·°C) um die Dehnung korrigiert, die Unsicherheit verwendet {1} ({2}); bei ΔT = "
     "{3} °C bleiben über L {4} µm, die kein Verfahren enthält"},
    {"the report of {0=} is called {1=}: that of {2=} is called {3=}",
     "der Bericht zu {0} heißt {1}: der zu {2} heißt {3}"},
    {"the reversed sign of the instrument", "das umgekehrte Vorzeichen des Messgeräts"},
    {"the sensitivity K of the instrument is not given", "die Empfindlichkeit K des Messgeräts ist nicht angegeben"},
    {"the sensor of the {0=} without location", "der Sensor „{0}“ ohne Ort"},
    {"the sensor of the {0=} without temperature at the {1}", "der Sensor „{0}“ ohne Temperatur am {1}"},
    {"the sign of the instrument is said to be reversed, and its readings were taken as they are",
     "das Vorzeichen des Messgeräts ist als umgekehrt angegeben, und seine Messwerte wurden genommen, wie sie sind"},
    {"the station of the tracking interferometer ({0})", "die Station des nachführenden Interferometers ({0})"},
    {"the station of the tracking interferometer is left out of the uncertainty: {0}",
     "die Station des nachführenden Interferometers ist in der Unsicherheit weggelassen: {0}"},
    {"the temperature of the {0} is not known", "die Temperatur ({0}) ist nicht bekannt"},
    {"the test with five approaches over 2 000 mm of the normal working area is also needed (6.2)",
     "die Prüfung mit fünf Anfahrten über 2\u00a0000\u00a0mm des normalen Arbeitsbereichs ist zusätzlich nötig (6.2)"},
    {"the test with five approaches over 360° of the normal working area is also needed (6.2)",
     "die Prüfung mit fünf Anfahrten über 360° des normalen Arbeitsbereichs ist zusätzlich nötig (6.2)"},
    {"the test with five approaches over one stretch of 2 000 mm, or several as agreed, is also needed (6.2)",
     "die Prüfung mit fünf Anfahrten über ein Teilstück von 2\u00a0000\u00a0mm, oder mehrere nach Vereinbarung, ist "
     "zusätzlich nötig (6.2)"},
    {"the uncertainty is incomplete and too small: nothing was given of {0}",
     "die Unsicherheit ist unvollständig und zu klein; es fehlen Angaben zu: {0}"},
    {"the {0=} sensor", "Sensor „{0}“"},
    {"the {0=} sensor ({1=})", "Sensor „{0}“ ({1})"},
    {"thermal expansion, about {0#} over the travel,", "thermische Ausdehnung, etwa {0} über den Weg,"},
    {"thermal expansion, about {0#} over the travel, of which nobody said whether it was corrected,",
     "thermische Ausdehnung, etwa {0} über den Weg, zu der niemand sagt, ob sie korrigiert wurde,"},
    {"tracking interferometer: {0}", "nachführendes Interferometer: {0}"},
    {"tracking.station_position with tracking.station_uncertainty_mm",
     "tracking.station_position mit tracking.station_uncertainty_mm"},
    {"type", "Typ"},
    {"with one approach from each direction s, R and A (3.18 to 3.22, 3.26, 3.27) are not applicable",
     "bei einer Anfahrt aus jeder Richtung sind s, R und A (3.18 bis 3.22, 3.26, 3.27) nicht anwendbar"},
    {"without R(θ) of the {0} nothing depends on it", "ohne R(θ) ({0}) hängt nichts davon ab"},
    {"{0#} approach in each direction", "{0} Anfahrt in jeder Richtung"},
    {"{0#} approach {1#}", "{0} Anfahrt {1}"},
    {"{0#} approach ↑ and {1#} ↓", "{0} Anfahrt ↑ und {1} ↓"},
    {"{0#} approaches in each direction", "{0} Anfahrten in jeder Richtung"},
    {"{0#} approaches {1#}", "{0} Anfahrten {1}"},
    {"{0#} approaches ↑ and {1#} ↓", "{0} Anfahrten ↑ und {1} ↓"},
    {"{0#} per metre", "{0} je Meter"},
    {"{0#} per revolution", "{0} je Umdrehung"},
    {"{0=} ({1}) acts in Annex A alone: {2}", "{0} ({1}) wirkt nur in Anhang A: {2}"},
    {"{0=} ({1}) acts on the mean deviations of the targets alone: no error of single targets is stated",
     "{0} ({1}) wirkt nur auf die mittleren Abweichungen der Zielpositionen: kein Fehler einzelner Zielpositionen ist "
     "angegeben"},
    {"{0=} ({1}) cannot act: {2}", "{0} ({1}) kann nicht wirken: {2}"},
    {"{0=} ({1}) does not count: {2=} ({3}) takes its place", "{0} ({1}) zählt nicht: {2} ({3}) tritt an die Stelle"},
    {"{0=} ({1}) does not count: {2}", "{0} ({1}) zählt nicht: {2}"},
    {"{0=} takes its place", "{0} tritt an die Stelle"},
    {"{0=} without {1}", "{0} ohne {1}"},
    {"{0} and {1#} more", "{0} und {1} weitere"},
    {"{0} from {1#} only", "{0} nur aus {1}"},
    {"{0} from ↑ only", "{0} nur aus ↑"},
    {"{0} from ↓ only", "{0} nur aus ↓"},
    {"{0} is neither corrected nor in the uncertainty; {1} mends that",
     "{0} ist weder korrigiert noch in der Unsicherheit enthalten; Abhilfe: {1}"},
    {"{0} is neither corrected nor in the uncertainty; {1} mends that; no verdict on which it could matter is given",
     "{0} ist weder korrigiert noch in der Unsicherheit enthalten; Abhilfe: {1}; wo es auf eine Entscheidung ankommen "
     "kann, wird keine getroffen"},
};

}  // namespace

const std::span<const Phrase> german_findings{findings_rows};

}  // namespace axiometry::language
