// SPDX-License-Identifier: Apache-2.0
// What the noise of the environment was, and which of its kinds an interval holds for; temperatures about a test.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase noise_rows[] = {
    {"(stated): on the word of who tested, by no log of temperatures.",
     "(angegeben): auf das Wort dessen, der geprüft hat, nach keiner Temperaturaufzeichnung."},
    {"Agreed", "Vereinbart"},
    {"An agreed limit is exceeded", "Ein vereinbarter Grenzwert ist überschritten"},
    {"Change per hour, during the test", "Änderung je Stunde, während der Prüfung"},
    {"Change per hour, in the twelve hours before", "Änderung je Stunde, in den zwölf Stunden davor"},
    {"Change per hour: the greatest within any hour; where less than an hour was recorded in one piece, the range of "
     "that piece divided by its length. Readings more than half an hour apart tell nothing of the time between them.",
     "Änderung je Stunde: die größte innerhalb irgendeiner Stunde; wo weniger als eine Stunde am Stück aufgezeichnet "
     "wurde, die Spanne dieses Stücks geteilt durch seine Länge. Messwerte, die mehr als eine halbe Stunde "
     "auseinanderliegen, sagen nichts über die Zeit dazwischen."},
    {"E_VE = {0#} as noise from reading to reading would scatter them by {1#} within runs, where they scatter by {2#} "
     "({3#}): it cannot be the white noise that it is stated to be, and counts as a slow drift or a random walk",
     "E_VE = {0} als Rauschen von Messwert zu Messwert würde sie innerhalb der Durchläufe um {1} streuen lassen, wo "
     "sie um {2} streuen ({3}): sie kann nicht das weiße Rauschen sein, als das sie angegeben ist, und zählt als "
     "langsame Drift oder Irrfahrt"},
    {"E_VE = {0#} as noise from reading to reading would scatter them by {1#} within runs, where they scatter by {2#} "
     "({3#}): it is a slow variation, or much overstated",
     "E_VE = {0} als Rauschen von Messwert zu Messwert würde sie innerhalb der Durchläufe um {1} streuen lassen, wo "
     "sie um {2} streuen ({3}): sie ist eine langsame Schwankung oder viel zu groß angegeben"},
    {"E_VE = {0#} {1#} is the largest range of the recording at standstill over {2#} s, all of it",
     "E_VE = {0} {1} ist die größte Spanne der Aufzeichnung im Stillstand über {2}\u00a0s, die ganze Aufzeichnung"},
    {"E_VE = {0#} {1#} is the largest range of the recording at standstill over {2#} s, the length of the test",
     "E_VE = {0} {1} ist die größte Spanne der Aufzeichnung im Stillstand über {2}\u00a0s, die Dauer der Prüfung"},
    {"E_VE counts as a random walk over the test", "E_VE gilt als Irrfahrt während der Prüfung"},
    {"E_VE counts as a slow drift over the test", "E_VE gilt als langsame Drift während der Prüfung"},
    {"E_VE counts as the recording at standstill shows it: how its values go together, and white noise beside it",
     "E_VE zählt so, wie die Aufzeichnung bei Stillstand es zeigt: wie deren Werte zusammenhängen, und weißes Rauschen "
     "daneben"},
    {"E_VE is stated as white noise, which the readings refute ({0#}): {1}; every other kind is considered in its "
     "place",
     "E_VE ist als weißes Rauschen angegeben, was die Messwerte widerlegen ({0}): {1}; an seiner Stelle wird jede "
     "andere Art betrachtet"},
    {"E_VE may be a slow drift or a random walk, since the readings refute white noise: the largest u counts",
     "E_VE kann eine langsame Drift oder eine Irrfahrt sein, da die Messwerte weißes Rauschen widerlegen: das größte u "
     "zählt"},
    {"E_VE may be white noise, a slow drift or a random walk: the largest u counts",
     "E_VE kann weißes Rauschen, eine langsame Drift oder eine Irrfahrt sein: das größte u zählt"},
    {"Gradient over the machine", "Temperaturunterschied über die Maschine"},
    {"Highest temperature of the air", "Höchste Lufttemperatur"},
    {"Highest, °C", "Höchster, °C"},
    {"How the log was read", "Wie die Aufzeichnung gelesen wurde"},
    {"ISO 230-2:2014, 4.1 and 7", "ISO 230-2:2014, 4.1 und 7"},
    {"Log begins", "Beginn der Aufzeichnung"},
    {"Lowest temperature of the air", "Niedrigste Lufttemperatur"},
    {"Lowest, °C", "Niedrigster, °C"},
    {"Measured", "Gemessen"},
    {"No environmental variation was stated, and none counts",
     "Keine Umgebungsschwankung wurde angegeben, und keine zählt"},
    {"No environmental variation was stated, and none counts.",
     "Keine Umgebungsschwankung wurde angegeben, und keine zählt."},
    {"No interval is stated, since no input of the uncertainty acts on any parameter",
     "Kein Intervall wird angegeben, da keine Eingangsgröße der Unsicherheit auf einen Kennwert wirkt"},
    {"No interval is stated, since no normal scatter explains a reading: {0}",
     "Kein Intervall wird angegeben, da keine normale Streuung einen Messwert erklärt: {0}"},
    {"No limits were agreed", "Es wurden keine Grenzwerte vereinbart"},
    {"Noise makes the parameters, which are extremes, larger on average: none was stated, and the interval knows "
     "nothing of it.",
     "Rauschen macht die Kennwerte, die Extremwerte sind, im Mittel größer: Es wurde keines angegeben, und das "
     "Intervall weiß nichts davon."},
    {"Noise makes the parameters, which are extremes, larger on average: the measured value is not corrected for that "
     "and stands in its interval, which reaches below it as far as the readings may hold such noise.",
     "Rauschen macht die Kennwerte, die Extremwerte sind, im Mittel größer: Der Messwert ist dafür nicht korrigiert "
     "und liegt in seinem Intervall, das so weit darunter reicht, wie die Messwerte solches Rauschen enthalten "
     "können."},
    {"Noise of the instrument and of the environment is part of the scatter.",
     "Rauschen des Messgeräts und der Umgebung ist Teil der Streuung."},
    {"Noise refuted by the readings ({0#}): {1}; {2}", "Von den Messwerten widerlegtes Rauschen ({0}): {1}; {2}"},
    {"Not known whether every agreed limit was kept",
     "Nicht bekannt, ob jeder vereinbarte Grenzwert eingehalten wurde"},
    {"Of", "Von"},
    {"Recording at standstill (A.2.5): over time, and the sinusoids that it is made of",
     "Aufzeichnung bei Stillstand (A.2.5): über der Zeit, und die Sinusschwingungen, aus denen sie besteht"},
    {"Recording at standstill: {0=} (SHA-256 {1=}), {2#} values {3#} s apart",
     "Aufzeichnung bei Stillstand: {0} (SHA-256 {1}), {2} Werte im Abstand von {3} s"},
    {"Standing", "Stand"},
    {"Temperature", "Temperatur"},
    {"Temperatures about a test", "Temperaturen zu einer Prüfung"},
    {"Temperatures before and during the test", "Temperaturen vor und während der Prüfung"},
    {"Test began", "Beginn der Prüfung"},
    {"Test ended", "Ende der Prüfung"},
    {"That noise makes the parameters, which are extremes, larger on average is neither corrected nor part of {0#}.",
     "Dass Rauschen die Kennwerte, die Extremwerte sind, im Mittel größer macht, ist weder korrigiert noch Teil von "
     "{0}."},
    {"That noise makes the parameters, which are extremes, larger on average is neither corrected nor part of {0#}; "
     "the Monte Carlo method tells of it.",
     "Dass Rauschen die Kennwerte, die Extremwerte sind, im Mittel größer macht, ist weder korrigiert noch Teil von "
     "{0}; die Monte-Carlo-Methode sagt mehr dazu."},
    {"The agreed limits were kept", "Die vereinbarten Grenzwerte wurden eingehalten"},
    {"The environmental variation counts as a random walk", "Die Umgebungsschwankung zählt als Irrfahrt"},
    {"The environmental variation counts as a slow drift", "Die Umgebungsschwankung zählt als langsame Drift"},
    {"The environmental variation counts as independent from reading to reading",
     "Die Umgebungsschwankung zählt als unabhängig von Messwert zu Messwert"},
    {"The environmental variation counts as it was recorded at standstill",
     "Die Umgebungsschwankung zählt so, wie sie im Stillstand aufgezeichnet wurde"},
    {"The environmental variation counts as one slow swing over the test where the annex takes repeatability from "
     "noise of single readings.",
     "Die Umgebungsschwankung zählt als eine langsame Schwingung über die Prüfung, wo der Anhang die "
     "Wiederholpräzision aus dem Rauschen einzelner Messwerte nimmt."},
    {"The environmental variation is stated to be slow: A.11 and A.14 take {0#} and {1#}, for one swing over the test, "
     "in place of 2.0 and 2.2, which are for noise of single readings",
     "Die Umgebungsschwankung ist als langsam angegeben: A.11 und A.14 nehmen {0} und {1}, für eine Schwingung über "
     "die Prüfung, statt 2,0 und 2,2, die für Rauschen einzelner Messwerte gelten"},
    {"The environmental variation was stated as independent from reading to reading, which the readings refute: none, "
     "a slow drift and a random walk are held possible in its place",
     "Die Umgebungsschwankung wurde als unabhängig von Messwert zu Messwert angegeben, was die Messwerte widerlegen: "
     "Keine, eine langsame Drift und eine Irrfahrt werden statt dessen für möglich gehalten"},
    {"The factors of U_EVE in A.11 to A.18 take it for noise of single readings; a slow drift moves neighbouring "
     "readings alike, see the Monte Carlo method",
     "Die Faktoren von U_EVE in A.11 bis A.18 nehmen es als Rauschen einzelner Messwerte; eine langsame Drift "
     "verschiebt benachbarte Messwerte gleich, siehe Monte-Carlo-Methode"},
    {"The factors of the annex take the environmental variation for noise from reading to reading, which nobody has "
     "said it is.",
     "Die Faktoren des Anhangs nehmen die Umgebungsschwankung für Rauschen von Messwert zu Messwert, obwohl niemand "
     "gesagt hat, dass sie das ist."},
    {"The factors of the annex take the environmental variation for noise from reading to reading.",
     "Die Faktoren des Anhangs nehmen die Umgebungsschwankung für Rauschen von Messwert zu Messwert."},
    {"The interval holds for: {0}", "Das Intervall gilt für: {0}"},
    {"The interval holds for: {0}; {1}", "Das Intervall gilt für: {0}; {1}"},
    {"The interval is a Bayesian one: given the readings and what is known of the inputs, {0} lies in it with a "
     "probability of {1#} or more, whichever kind of noise that is held possible there was.",
     "Das Intervall ist ein Bayes’sches: Bei diesen Messwerten und dem, was über die Eingangsgrößen bekannt ist, liegt "
     "{0} mit einer Wahrscheinlichkeit von {1} oder mehr darin, welche Art von Rauschen es von den für möglich "
     "gehaltenen auch war."},
    {"The interval is a Bayesian one: given the readings and what is known of the inputs, {0} lies in it with a "
     "probability of {1#}.",
     "Das Intervall ist ein Bayes’sches: Bei diesen Messwerten und dem, was über die Eingangsgrößen bekannt ist, liegt "
     "{0} mit einer Wahrscheinlichkeit von {1} darin."},
    {"The interval is {0}, made to hold {1} in {2#} of tests: in simulated tests it held A, B, R, R↑ and R↓ less "
     "often, R↑ and R↓ in fewer than half of them.",
     "Das Intervall ist {0}, gemacht für {2} der Prüfungen, in denen darin liegen soll: {1}. In simulierten Prüfungen "
     "lagen A, B, R, R↑ und R↓ seltener darin, R↑ und R↓ bei weniger als der Hälfte."},
    {"The kind of E_VE is open: the interval assumes that white noise is at most five times what E_VE says",
     "Die Art von E_VE ist offen: das Intervall setzt voraus, dass weißes Rauschen höchstens fünfmal so groß ist, "
     "wie E_VE besagt"},
    {"The kind of E_VE is open: the interval assumes that white noise, and a trend that shifts of the runs hide, "
     "are at most five times what E_VE says, and that nothing in the environment repeats with every run",
     "Die Art von E_VE ist offen: das Intervall setzt voraus, dass weißes Rauschen und ein Trend, den "
     "Verschiebungen der Durchläufe verbergen, höchstens fünfmal so groß sind, wie E_VE besagt, und dass sich "
     "nichts in der Umgebung mit jedem Durchlauf wiederholt"},
    {"The kind of the environmental variation is not known: none, noise from reading to reading, slow drift and a "
     "random walk are held possible as far as the readings do not refute them",
     "Die Art der Umgebungsschwankung ist nicht bekannt: Keine, Rauschen von Messwert zu Messwert, langsame Drift und "
     "Irrfahrt werden für möglich gehalten, soweit die Messwerte sie nicht widerlegen"},
    {"The parameters are extremes, of which neither way sees that few approaches make them larger on average.",
     "Die Kennwerte sind Extremwerte, bei denen keiner dieser Wege sieht, dass wenige Anfahrten sie im Mittel größer "
     "machen."},
    {"The readings have no times: the test is taken to be as long as the recording at standstill",
     "Die Messwerte haben keine Zeiten: die Prüfung gilt als so lang wie die Aufzeichnung im Stillstand"},
    {"The recording at standstill does not count: {0#} is stated over it",
     "Die Aufzeichnung bei Stillstand zählt nicht: {0} ist darüber angegeben"},
    {"The recording at standstill is shorter than the test: what is slower than it is not known",
     "Die Aufzeichnung im Stillstand ist kürzer als die Prüfung: was langsamer ist als sie, ist nicht bekannt"},
    {"The recording at standstill says nothing and does not count: expected at least {0#} values that are not all the "
     "same, and uncertainty.drift_interval_s",
     "Die Aufzeichnung bei Stillstand sagt nichts und zählt nicht: erwartet werden mindestens {0} Werte, die nicht "
     "alle gleich sind, und uncertainty.drift_interval_s"},
    {"The stated noise of a reading, u = {0#} {1#}, contradicts the readings: within runs they scatter by s = {2#} "
     "{3#} alone ({4#}); no more than that is taken for noise",
     "Das angegebene Rauschen eines Messwerts, u = {0} {1}, widerspricht den Messwerten: innerhalb der Durchläufe "
     "streuen sie nur mit s = {2} {3} ({4}); nicht mehr als das gilt als Rauschen"},
    {"The uncertainty is that of this machine: by how much the parameters of this test may differ from those that the "
     "axis has in the long run. Besides instruments and temperature it counts that {0#} approach per direction is only "
     "a sample. What the findings tell as not corrected is not in it: without a correction it does not hold.",
     "Die Unsicherheit ist die dieser Maschine: um wie viel die Kennwerte dieser Prüfung von denen abweichen können, "
     "die die Achse auf lange Sicht hat. Neben Messgeräten und Temperatur zählt, dass {0} Anfahrt je Richtung nur eine "
     "Stichprobe ist. Was laut Feststellungen nicht korrigiert ist, ist nicht darin: Ohne eine Korrektur gilt sie "
     "nicht."},
    {"The uncertainty is that of this machine: by how much the parameters of this test may differ from those that the "
     "axis has in the long run. Besides instruments and temperature it counts that {0#} approaches per direction are "
     "only a sample. What the findings tell as not corrected is not in it: without a correction it does not hold.",
     "Die Unsicherheit ist die dieser Maschine: um wie viel die Kennwerte dieser Prüfung von denen abweichen können, "
     "die die Achse auf lange Sicht hat. Neben Messgeräten und Temperatur zählt, dass {0} Anfahrten je Richtung nur "
     "eine Stichprobe sind. Was laut Feststellungen nicht korrigiert ist, ist nicht darin: Ohne eine Korrektur gilt "
     "sie nicht."},
    {"The uncertainty is that of this test: by how much the parameters may differ from those that the same approaches "
     "would have given with perfect instruments at 20 °C. The scatter of the machine itself is part of the result and "
     "not of its uncertainty. What the findings tell as not corrected is not in it: without a correction it does not "
     "hold.",
     "Die Unsicherheit ist die dieser Prüfung: um wie viel die Kennwerte von denen abweichen können, die dieselben "
     "Anfahrten mit vollkommenen Messgeräten bei 20 °C ergeben hätten. Die Streuung der Maschine selbst ist Teil des "
     "Ergebnisses und nicht seiner Unsicherheit. Was laut Feststellungen nicht korrigiert ist, ist nicht darin: Ohne "
     "eine Korrektur gilt sie nicht."},
    {"Time", "Zeit"},
    {"Time from the beginning of the log", "Zeit seit Beginn der Aufzeichnung"},
    {"Time from the beginning of the test", "Zeit seit Beginn der Prüfung"},
    {"What the findings tell as not corrected is not in it: without a correction it does not hold.",
     "Was laut Feststellungen nicht korrigiert ist, ist nicht darin: Ohne eine Korrektur gilt sie nicht."},
    {"What was measured and what was agreed", "Was gemessen und was vereinbart wurde"},
    {"a bootstrap one, of runs drawn again from those that were measured",
     "ein Bootstrap-Intervall aus Durchläufen, die aus den gemessenen neu gezogen wurden"},
    {"a trend that shifts of the runs hide", "ein Trend, den Verschiebungen der Durchläufe verbergen"},
    {"agreed limit", "vereinbarter Grenzwert"},
    {"an interval of --type-a {0=} held the true value less often in simulated tests than it states; --type-a {1=} "
     "mends that",
     "ein Intervall mit --type-a {0} enthielt den wahren Wert in simulierten Prüfungen seltener, als es angibt; "
     "Abhilfe: --type-a {1}"},
    {"as the recording at standstill", "wie die Aufzeichnung im Stillstand"},
    {"at least {0#} {1}", "mindestens {0} {1}"},
    {"at most {0#} {1}", "höchstens {0} {1}"},
    {"errors of single readings", "Fehler einzelner Messwerte"},
    {"exceeded", "überschritten"},
    {"found a column {0=} of sensors' names, expected a column for each sensor",
     "Spalte {0} mit Namen von Sensoren; erwartet: eine Spalte für jeden Sensor"},
    {"found a temperature log that begins {0=} and lasts {1#} h, expected one of the test or of the twelve hours "
     "before it",
     "Temperaturaufzeichnung, die {0} beginnt und {1} h dauert; erwartet: eine der Prüfung oder der zwölf Stunden "
     "davor"},
    {"found two roles of the sensor {0=}, expected one", "Zwei Rollen des Sensors {0}; erwartet: eine"},
    {"how its values go together over the length of the test, and white noise of u = {0#} {1#} beside it; the readings "
     "show about {2#} of what is stated",
     "wie ihre Werte über die Dauer der Prüfung zusammenhängen, und weißes Rauschen von u = {0} {1} daneben; die "
     "Messwerte zeigen etwa das {2}-fache der angegebenen Größe"},
    {"its size is taken from the readings; the readings show about {0#} of what is stated",
     "ihre Größe folgt aus den Messwerten; die Messwerte zeigen etwa das {0}-fache der angegebenen"},
    {"known in part only", "nur teilweise bekannt"},
    {"no environmental variation is stated", "es ist keine Umgebungsschwankung angegeben"},
    {"no interval is stated: {0}", "es wird kein Intervall angegeben: {0}"},
    {"no limit agreed", "kein Grenzwert vereinbart"},
    {"no noise in the readings", "kein Rauschen in den Messwerten"},
    {"nobody said when the test ended, and the log ends no later than the test began",
     "niemand hat gesagt, wann die Prüfung endete, und die Aufzeichnung endet nicht später, als die Prüfung begann"},
    {"nobody said when the test ended: the end of the log is taken for it",
     "niemand hat gesagt, wann die Prüfung endete: dafür gilt das Ende der Aufzeichnung"},
    {"nobody said when the test was: all of the log counts as the test, and nothing is known of the twelve hours "
     "before it",
     "niemand hat gesagt, wann die Prüfung war: die ganze Aufzeichnung zählt als Prüfung, und von den zwölf Stunden "
     "davor ist nichts bekannt"},
    {"noise as it is stated", "Rauschen wie angegeben"},
    {"not measured", "nicht gemessen"},
    {"of about the size that is stated, as far as the means of the runs leave room",
     "von etwa der Größe, die angegeben ist, soweit die Mittelwerte der Durchläufe Raum lassen"},
    {"of up to five times of what is stated, as far as the means of the runs leave room",
     "bis zum Fünffachen dessen, was angegeben ist, soweit die Mittelwerte der Durchläufe Raum lassen"},
    {"one of Student’s t and χ² for every target and direction by itself (JCGM 101, 6.4.9.2)",
     "eines nach Students t und χ² für jede Zielposition und Richtung für sich (JCGM 101, 6.4.9.2)"},
    {"random walk", "Irrfahrt"},
    {"readings at standstill", "Messwerte bei Stillstand"},
    {"readings that depart from the others of their targets by up to {0#} times the standard deviation of such a "
     "departure: {1#}",
     "Messwerte, die von den anderen ihrer Sollpositionen um bis zum {0}-fachen der Standardabweichung einer "
     "solchen Abweichung abweichen: {1}"},
    {"recording at standstill, file", "Aufzeichnung bei Stillstand, Datei"},
    {"recording at standstill, flag", "Aufzeichnung bei Stillstand, Aufruf"},
    {"slow drift", "langsame Drift"},
    {"temperature sensor {0=} does not say what it is of and is taken for one of the air",
     "Temperatursensor {0} sagt nicht, wovon er ist, und gilt als einer der Luft"},
    {"temperature sensor {0=} has no reading at all", "Temperatursensor {0} hat gar keinen Messwert"},
    {"temperature sensor {0=} is taken for one of the air by its name",
     "Temperatursensor {0} gilt nach seinem Namen als einer der Luft"},
    {"temperature sensor {0=} is taken for one of the equipment by its name",
     "Temperatursensor {0} gilt nach seinem Namen als einer des Messmittels"},
    {"temperature sensor {0=} is taken for one of the machine by its name",
     "Temperatursensor {0} gilt nach seinem Namen als einer der Maschine"},
    {"temperature sensor {0=}: {1#} of {2#} readings have no value and are left out",
     "Temperatursensor {0}: {1} von {2} Messwerten sind leer und bleiben weg"},
    {"temperature sensor {0=}: {1#} of {2#} readings lie outside −60 … 100 °C and are left out",
     "Temperatursensor {0}: {1} von {2} Messwerten liegen außerhalb von −60 … 100 °C und bleiben weg"},
    {"temperature sensors {0=} are taken for ones of the air by their names",
     "Temperatursensoren {0} gelten nach ihren Namen als solche der Luft"},
    {"temperature sensors {0=} are taken for ones of the equipment by their names",
     "Temperatursensoren {0} gelten nach ihren Namen als solche des Messmittels"},
    {"temperature sensors {0=} are taken for ones of the machine by their names",
     "Temperatursensoren {0} gelten nach ihren Namen als solche der Maschine"},
    {"the method of record, {0}, states no uncertainty of {1#}",
     "das maßgebliche Verfahren, {0}, gibt keine Unsicherheit von {1} an"},
    {"the parameter that the axis has in the long run", "der Kennwert, den die Achse auf lange Sicht hat,"},
    {"the parameter that the same approaches would have given with perfect instruments at 20 °C",
     "der Kennwert, den dieselben Anfahrten mit vollkommenen Messgeräten bei 20 °C ergeben hätten,"},
    {"the parameter that the same approaches would have given with perfect instruments at 20 °C, but for what the "
     "findings tell as not corrected",
     "der Kennwert, den dieselben Anfahrten mit vollkommenen Messgeräten bei 20 °C ergeben hätten, abgesehen von dem, "
     "was laut Feststellungen nicht korrigiert ist,"},
    {"the recording at standstill tells it", "die Aufzeichnung bei Stillstand sagt es"},
    {"the rows of the table begin with the newest reading and were turned round",
     "die Zeilen der Tabelle beginnen mit dem neuesten Messwert und wurden umgedreht"},
    {"the scatter within runs leaves room for it", "die Streuung innerhalb der Durchläufe lässt Raum dafür"},
    {"the temperature log begins with the newest reading and was turned round",
     "die Temperaturaufzeichnung beginnt mit dem neuesten Messwert und wurde umgedreht"},
    {"the temperature log tells no unit of its temperatures, which are taken to be in °C",
     "die Temperaturaufzeichnung nennt keine Einheit ihrer Temperaturen; sie gelten als °C"},
    {"the temperature of the air was recorded in {0#} h of the twelve hours before the test, of which clause 4.1 asks "
     "for all",
     "die Lufttemperatur ist in {0} h der zwölf Stunden vor der Prüfung aufgezeichnet, die Abschnitt 4.1 alle "
     "verlangt"},
    {"the temperature of the air was recorded in {0#} h of the {1#} h of the test; what it was in the rest is not "
     "known",
     "die Lufttemperatur ist in {0} h der {1} h der Prüfung aufgezeichnet; wie sie im Rest war, ist nicht bekannt"},
    {"time of a test", "Dauer einer Prüfung"},
    {"time of the test", "Zeit der Prüfung"},
    {"times of the temperature log are taken to count from 1970-01-01 UTC",
     "Zeiten der Temperaturaufzeichnung gelten als seit 1970-01-01 UTC gezählt"},
    {"uncertainty.measurand = this-machine does not reach Annex A, whose U is that of the value of this test; GUM and "
     "Monte Carlo know it",
     "uncertainty.measurand = this-machine erreicht Anhang A nicht, dessen U für den Wert dieser Prüfung gilt; GUM und "
     "Monte Carlo kennen es"},
    {"white noise from reading to reading", "weißes Rauschen von Messwert zu Messwert"},
    {"white noise of u = {0#} {1#} and nothing beside it", "weißes Rauschen von u = {0} {1} und nichts daneben"},
    {"widest over the time of a test:", "größte Spanne über die Dauer einer Prüfung:"},
    {"within runs the readings scatter by s = {0#} {1#}, where white noise of this size alone would give {2#} {3#}",
     "innerhalb der Durchläufe streuen die Messwerte mit s = {0} {1}, wo weißes Rauschen dieser Größe allein {2} {3} "
     "ergäbe"},
    {"{0#} (k = 2) is that of Annex A: the contributors that were given, independent of each other, for the value of "
     "this test at 20 °C, but for what the findings tell as not corrected.",
     "{0} (k = 2) ist die nach Anhang A: die angegebenen Beiträge, voneinander unabhängig, für den Wert dieser Prüfung "
     "bei 20 °C, abgesehen von dem, was laut Feststellungen nicht korrigiert ist."},
    {"{0#} (k = 2) is that of Annex A: the contributors that were given, independent of each other, for the value of "
     "this test at 20 °C.",
     "{0} (k = 2) ist die nach Anhang A: die angegebenen Beiträge, voneinander unabhängig, für den Wert dieser Prüfung "
     "bei 20 °C."},
    {"{0#} cannot act: there is no recording at standstill",
     "{0} kann nicht wirken: es gibt keine Aufzeichnung bei Stillstand"},
    {"{0#} does not count: the recording at standstill takes its place",
     "{0} zählt nicht: die Aufzeichnung bei Stillstand tritt an seine Stelle"},
    {"{0#} is for about 95 %, by the law of propagation, as far as that is linear and its bias is not counted: how far "
     "{1} may be from the measured value.",
     "{0} gilt für rund 95 %, nach dem Fortpflanzungsgesetz, soweit dieses linear ist und seine systematische "
     "Abweichung nicht zählt: wie weit {1} vom Messwert entfernt sein kann."},
    {"{0#} more sensor is not named here", "{0} weiterer Sensor ist hier nicht genannt"},
    {"{0#} more sensors are not named here", "{0} weitere Sensoren sind hier nicht genannt"},
    {"{0#} of run {1#} at {2#} {3#} departs by {4#} {5#} from the other approaches, {6#} times the standard deviation "
     "of such a departure",
     "{0} von Durchlauf {1} bei {2} {3} weicht um {4} {5} von den anderen Anfahrten ab, das {6}-fache der "
     "Standardabweichung einer solchen Abweichung"},
    {"{0#} of run {1#} at {2#} {3#} departs by {4#} {5#} from the other approaches, {6#} times the standard deviation "
     "of such a departure; such readings: {7#}",
     "{0} von Durchlauf {1} bei {2} {3} weicht um {4} {5} von den anderen Anfahrten ab, das {6}-fache der "
     "Standardabweichung einer solchen Abweichung; solche Messwerte: {7}"},
    {"{0#} readings of temperature sensors, from {1#} to {2#} °C.",
     "{0} Messwerte von Temperatursensoren, von {1} bis {2} °C."},
    {"{0#} trials, of which none states an interval", "{0} Versuche, von denen keiner ein Intervall angibt"},
    {"{0#} values over {1#} s; over {2#} s, as long as is looked at for a test, they range over {3#} {4#} at most.",
     "{0} Werte über {1} s; über {2} s, so lange, wie für eine Prüfung betrachtet wird, liegen sie höchstens {3} {4} "
     "auseinander."},
    {"{0=} (stated)", "{0} (angegeben)"},
    {"{0}, and runs that shift of their own", "{0}, und Durchläufe, die sich von selbst verschieben"},
    {"{0}; all inputs count to first order.", "{0}; alle Eingangsgrößen zählen in erster Ordnung."},
    {"{0}; before the readings every size of the machine’s own scatter was equally likely in every octave.",
     "{0}; vor den Messwerten war jede Größe der Streuung der Maschine in jeder Oktave gleich wahrscheinlich."},
};

}  // namespace

const std::span<const Phrase> german_noise{noise_rows};

}  // namespace axiometry::language
