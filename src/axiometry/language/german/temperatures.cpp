// SPDX-License-Identifier: Apache-2.0
// What a log of temperatures tells of a test, and what of it is refused.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase temperatures_rows[] = {
    {"What is not known", "Was nicht bekannt ist"},
    {"an agreed limit was exceeded, and nobody can say whether that was during the test",
     "ein vereinbarter Grenzwert wurde überschritten, und niemand kann sagen, ob das während der Prüfung war"},
    {"change per hour, during the test", "Änderung je Stunde, während der Prüfung"},
    {"change per hour, in the twelve hours before", "Änderung je Stunde, in den zwölf Stunden davor"},
    {"column {0=} of the temperature log does not say that it is a temperature and is passed over",
     "Spalte {0} der Temperaturaufzeichnung sagt nicht, dass sie eine Temperatur ist, und wird übergangen"},
    {"column {0=} of the temperature log is by its name no temperature of the machine, the equipment or the air and is "
     "left out",
     "Spalte {0} der Temperaturaufzeichnung ist nach ihrem Namen keine Temperatur der Maschine, der Ausrüstung oder "
     "der Luft und wird weggelassen"},
    {"column {0=} of the temperature log is taken to be in {1=} by its last letter",
     "Spalte {0} der Temperaturaufzeichnung gilt nach ihrem letzten Buchstaben als in {1}"},
    {"column {0=} of the temperature log tells no unit, which others do, and is taken to be in °C",
     "Spalte {0} der Temperaturaufzeichnung nennt anders als andere keine Einheit und gilt als in °C"},
    {"found a file of many tests, expected one test with --temperatures",
     "eine Datei mit vielen Prüfungen; erwartet: eine einzelne Prüfung bei --temperatures"},
    {"found a line of {0#} bytes in a temperature log, expected at most {1#}",
     "Zeile von {0} Byte in einer Temperaturaufzeichnung; erwartet: höchstens {1}"},
    {"found a lowest temperature of the air of {0#} °C above the highest of {1#} °C, expected it below",
     "niedrigste Lufttemperatur von {0} °C über der höchsten von {1} °C; erwartet: darunter"},
    {"found a temperature log without dates, expected dates to know when the test was",
     "Temperaturaufzeichnung ohne Datum; erwartet: ein Datum, um zu wissen, wann die Prüfung war"},
    {"found a test dated {0=}, expected the day of its temperatures, {1=}: nobody knows whose these are",
     "eine Prüfung vom {0}; erwartet: der Tag ihrer Temperaturen, {1}. Niemand weiß, wessen Temperaturen dies sind"},
    {"found a test that ended {0=}, expected an end after its beginning {1=}",
     "Prüfung, die {0} endete; erwartet: ein Ende nach ihrem Beginn {1}"},
    {"found a time before that of the line before, expected the order of time",
     "Zeit vor jener der vorigen Zeile; erwartet: die Reihenfolge der Zeit"},
    {"found agreed limits of which nobody can say whether they were kept, since not all of the time is known: {0}",
     "vereinbarte Grenzwerte, von denen niemand sagen kann, ob sie eingehalten wurden, denn nicht die ganze Zeit ist "
     "bekannt: {0}"},
    {"found air of {0#} °C stated at the start or the end of the test above its highest temperature stated, "
     "{1#} °C, expected figures of one test",
     "für Anfang oder Ende der Prüfung sind {0} °C der Luft angegeben, über ihrer angegebenen höchsten "
     "Temperatur von {1} °C; erwartet: Werte einer einzigen Prüfung"},
    {"found air of {0#} °C stated at the start or the end of the test below its lowest temperature stated, "
     "{1#} °C, expected figures of one test",
     "für Anfang oder Ende der Prüfung sind {0} °C der Luft angegeben, unter ihrer angegebenen niedrigsten "
     "Temperatur von {1} °C; erwartet: Werte einer einzigen Prüfung"},
    {"found an agreed lowest temperature of {0#} °C above the highest of {1#} °C",
     "vereinbarte niedrigste Temperatur von {0} °C über der höchsten von {1} °C"},
    {"found flags about a log of temperatures, expected the log too, with --temperatures",
     "Angaben zu einer Temperaturaufzeichnung; erwartet: auch die Aufzeichnung, mit --temperatures"},
    {"found no file {0=} in the archive, expected the temperature log among the documents of the test: attach it first",
     "keine Datei {0} im Archiv; erwartet: die Temperaturaufzeichnung unter den Dokumenten der Prüfung; erst anhängen"},
    {"found no line of a time and a temperature, expected a temperature log such as 'time;air [°C]' with lines below "
     "it",
     "keine Zeile mit Zeit und Temperatur; erwartet: eine Temperaturaufzeichnung wie 'time;air [°C]' mit Zeilen "
     "darunter"},
    {"found no measurement of {0}, expected one: {1} is agreed between the parties",
     "keine Messung: {0}; erwartet: eine, denn zwischen den Parteien ist vereinbart: {1}"},
    {"found no sensor of the machine, the equipment or the air in the temperature log, expected one of {0=} to be "
     "stated as such",
     "kein Sensor der Maschine, der Ausrüstung oder der Luft in der Temperaturaufzeichnung; erwartet: Angabe, dass "
     "{0} einer ist"},
    {"found no sensor {0=} in the temperature log, expected one of {1=}",
     "kein Sensor {0} in der Temperaturaufzeichnung; erwartet: einer von {1}"},
    {"found no temperature in the temperature log, expected some",
     "keine Temperatur in der Temperaturaufzeichnung; erwartet: welche"},
    {"found several inputs, expected one test with --temperatures",
     "mehrere Eingaben; erwartet: eine einzelne Prüfung bei --temperatures"},
    {"found the column {0=} beside others without a unit, expected units such as [°C] or [°F]: nobody knows whether "
     "the last letter is one",
     "Spalte {0} neben anderen ohne Einheit; erwartet: Einheiten wie [°C] oder [°F]. Niemand weiß, ob der letzte "
     "Buchstabe eine ist"},
    {"found the date {0=}, expected 2026-03-02 or 02.03.2026: of slashes nobody knows which is the month",
     "Datum {0}; erwartet: 2026-03-02 oder 02.03.2026, denn bei Schrägstrichen weiß niemand, was der Monat ist"},
    {"found the end of the test without its beginning, expected both",
     "Ende der Prüfung ohne ihren Beginn; erwartet: beides"},
    {"found the role {0=} of a sensor, expected machine, equipment, air or none",
     "Rolle {0} eines Sensors; erwartet: machine, equipment, air oder none"},
    {"found the time {0=}, expected hours from 0 to 23: AM and PM are not read",
     "Zeit {0}; erwartet: Stunden von 0 bis 23. AM und PM werden nicht gelesen"},
    {"found times with a time zone in the temperature log, expected moments of the test with one",
     "Zeiten mit Zeitzone in der Temperaturaufzeichnung; erwartet: Zeitpunkte der Prüfung mit einer"},
    {"found times without a time zone in the temperature log, expected moments of the test without one",
     "Zeiten ohne Zeitzone in der Temperaturaufzeichnung; erwartet: Zeitpunkte der Prüfung ohne eine"},
    {"found {0#} MiB of temperatures, expected at most {1#}", "{0} MiB Temperaturen; erwartet: höchstens {1}"},
    {"found {0#} sensors in a temperature log, expected at most {1#}",
     "{0} Sensoren in einer Temperaturaufzeichnung; erwartet: höchstens {1}"},
    {"found {0#} sensors, expected at most {1#}", "{0} Sensoren; erwartet: höchstens {1}"},
    {"found {0#} °C stated of the {1} at the beginning of the test, expected what the temperature log has then, {2#} "
     "to {3#} °C",
     "als Temperatur zu Beginn der Prüfung sind {0} °C angegeben ({1}); erwartet: was die Temperaturaufzeichnung dann "
     "hat, {2} bis {3} °C"},
    {"found {0#} °C stated of the {1} at the end of the test, expected what the temperature log has then, {2#} to {3#} "
     "°C",
     "als Temperatur am Ende der Prüfung sind {0} °C angegeben ({1}); erwartet: was die Temperaturaufzeichnung dann "
     "hat, {2} bis {3} °C"},
    {"found {0=} as the SHA-256 of a temperature log, expected 64 hexadecimal digits",
     "{0} als SHA-256 einer Temperaturaufzeichnung; erwartet: 64 hexadezimale Ziffern"},
    {"found {0=} as the beginning of the test, expected a moment such as 2026-03-02T09:00",
     "{0} als Beginn der Prüfung; erwartet: ein Zeitpunkt wie 2026-03-02T09:00"},
    {"found {0=} as the end of the test, expected a moment such as 2026-03-02T09:00",
     "{0} als Ende der Prüfung; erwartet: ein Zeitpunkt wie 2026-03-02T09:00"},
    {"found {0=} as what a sensor is of, expected machine, equipment, air or none",
     "{0} als Ort eines Sensors; erwartet: machine, equipment, air oder none"},
    {"found {0=} behind the time in {1=}, expected nothing, or a time zone such as Z or +01:00",
     "{0} hinter der Zeit in {1}; erwartet: nichts oder eine Zeitzone wie Z oder +01:00"},
    {"found {0=} beside the time in a temperature log, expected a column that says that it is a temperature, by its "
     "name or by a unit such as [°C]",
     "{0} neben der Zeit in einer Temperaturaufzeichnung; erwartet: eine Spalte, die durch ihren Namen oder eine "
     "Einheit wie [°C] sagt, dass sie eine Temperatur ist"},
    {"found {0=}, expected a temperature", "{0}; erwartet: eine Temperatur"},
    {"found {0=}, expected a time and temperatures as in the lines before",
     "{0}; erwartet: eine Zeit und Temperaturen wie in den Zeilen davor"},
    {"found {0}: {1#} {2=} stated, expected what the temperature log has, {3#} {4=}, which counts unless what "
     "is stated exceeds what was agreed",
     "angegeben ist {0}: {1} {2}; erwartet: was die Temperaturaufzeichnung hat, {3} {4}; dies zählt, solange "
     "das Angegebene das Vereinbarte nicht überschreitet"},
    {"found {0}: {1#}, and no limit that the parties agreed on",
     "{0}: {1}, und kein Grenzwert, den die Parteien vereinbart haben"},
    {"found {0}: {1#}, expected {2} as agreed between the parties",
     "{0}: {1}; erwartet: {2}, wie zwischen den Parteien vereinbart"},
    {"found {0}: {1#}, expected {2} as agreed between the parties; nobody can say whether that was during the test",
     "{0}: {1}; erwartet: {2}, wie zwischen den Parteien vereinbart; niemand kann sagen, ob das während der Prüfung "
     "war"},
    {"gradient over the machine", "Temperaturunterschied über die Maschine"},
    {"highest temperature of the air", "höchste Lufttemperatur"},
    {"lowest temperature of the air", "niedrigste Lufttemperatur"},
    {"of the temperature log: {0}", "zur Temperaturaufzeichnung: {0}"},
    {"temperature sensor {0=} recorded {1#} h of the twelve hours before the test, of which clause 4.1 asks for all",
     "Temperatursensor {0} hat {1} h der zwölf Stunden vor der Prüfung aufgezeichnet, die Abschnitt 4.1 alle verlangt"},
    {"temperature sensor {0=} recorded {1#} h of the {2#} h of the test; what it was there in the rest is not known",
     "Temperatursensor {0} hat {1} h der {2} h der Prüfung aufgezeichnet; wie warm es dort im Rest war, ist nicht "
     "bekannt"},
    {"the gradient over the machine is known in {0#} h of the {1#} h of the test",
     "der Temperaturunterschied über die Maschine ist in {0} h der {1} h der Prüfung bekannt"},
    {"{0=} (by the times of the readings)", "{0} (nach den Zeiten der Messwerte)"},
};

}  // namespace

const std::span<const Phrase> german_temperatures{temperatures_rows};

}  // namespace axiometry::language
