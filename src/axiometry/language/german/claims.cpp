// SPDX-License-Identifier: Apache-2.0
// What a result may be called, and what speaks against it.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase claims_rows[] = {
    {"1 point not stated", "1 Punkt nicht angegeben"},
    {"1 point of clauses 4 and 5 was not stated or not kept; see Claims.",
     "1 Punkt der Abschnitte 4 und 5 war nicht angegeben oder nicht eingehalten; siehe Aussagen."},
    {"All lines tested in accordance with {0}", "Alle Linien geprüft in Übereinstimmung mit {0}"},
    {"Claim", "Aussage"},
    {"Claims", "Aussagen"},
    {"Clauses that speak against the test", "Abschnitte, die gegen die Prüfung sprechen"},
    {"Computed after clause 3", "Berechnet nach Abschnitt 3"},
    {"Computed after clause 3 of {0}", "Berechnet nach Abschnitt 3 von {0}"},
    {"Computed after clause 3 of {0}; not a test in accordance with it",
     "Berechnet nach Abschnitt 3 von {0}; keine Prüfung in Übereinstimmung damit"},
    {"Computed after clause 3 of {0}; not a test in accordance with it (departs from {1=})",
     "Berechnet nach Abschnitt 3 von {0}; keine Prüfung in Übereinstimmung damit (weicht ab von {1})"},
    {"Computed after clause 3 of {0}; not a test in accordance with it · {1}",
     "Berechnet nach Abschnitt 3 von {0}; keine Prüfung in Übereinstimmung damit · {1}"},
    {"Formulas of {0} only", "Nur Formeln von {0}"},
    {"Formulas of {0} only (departs from {1=})", "Nur Formeln von {0} (weicht ab von {1})"},
    {"Formulas of {0} only · {1}", "Nur Formeln von {0} · {1}"},
    {"Holds", "Gilt"},
    {"No", "Nein"},
    {"None: no rule has anything to say. What may be claimed stands in Claims.",
     "Keine: Keine Regel hat etwas zu sagen. Was ausgesagt werden darf, steht unter Aussagen."},
    {"Not every line may be called tested in accordance with its standard, see Claims",
     "Nicht jede Linie darf geprüft in Übereinstimmung mit ihrer Norm heißen, siehe Aussagen"},
    {"Not everything that the report shall state was given; see Claims.",
     "Nicht alles, was der Bericht angeben muss, war gegeben; siehe Aussagen."},
    {"On the word of who tested for what no item states (4.1, 4.2, 5.1); see Claims.",
     "Auf das Wort dessen, der geprüft hat, für das, was keine Angabe sagt (4.1, 4.2, 5.1); siehe Aussagen."},
    {"Report complete", "Bericht vollständig"},
    {"Report complete after clause 8 of {0}", "Bericht vollständig nach Abschnitt 8 von {0}"},
    {"Smaller of R↑ and R↓", "Kleinerer Wert von R↑ und R↓"},
    {"Tested after it", "Danach geprüft"},
    {"Tested in accordance", "Geprüft in Übereinstimmung"},
    {"Tested in accordance with the standard: {0=}.", "Geprüft in Übereinstimmung mit der Norm: {0}."},
    {"Tested in accordance with {0}", "Geprüft in Übereinstimmung mit {0}"},
    {"Tested in accordance with {0} · {1}", "Geprüft in Übereinstimmung mit {0} · {1}"},
    {"What speaks against it", "Was dagegen spricht"},
    {"What was not stated speaks against a claim as what departs from the standard does: absent is never "
     "the same as fine.",
     "Was nicht angegeben ist, spricht gegen eine Aussage wie das, was von der Norm abweicht: Fehlendes "
     "gilt nie als in Ordnung."},
    {"Yes", "Ja"},
    {"contradicted by 1 point", "1 Punkt widerspricht"},
    {"contradicted by {0#} points", "{0} Punkte widersprechen"},
    {"found a test dated {0=}, which names no day that can be read: nobody can check that its temperatures, of {1=}, "
     "are of that day",
     "eine Prüfung mit dem Datum {0}, das keinen lesbaren Tag nennt: Niemand kann nachprüfen, ob ihre "
     "Temperaturen, vom {1}, von diesem Tag sind"},
    {"found dates of calibration that name no day or month, so that nobody can tell whether it held on the day of the "
     "test: {0=}",
     "Kalibrierdaten, die keinen Tag oder Monat nennen, sodass niemand sagen kann, ob die Kalibrierung am Tag der "
     "Prüfung galt: {0}"},
    {"found several axes moving at once, which is no test of a single axis; the text of ISO 230-6 was not "
     "at hand",
     "mehrere Achsen bewegen sich zugleich, was keine Prüfung einer einzelnen Achse ist; der Text von ISO "
     "230-6 lag nicht vor"},
    {"found targets without s_i or B_i where others have it: 0 stands for them, and R and A are lower "
     "bounds",
     "Zielpositionen ohne s_i oder B_i, wo andere sie haben: 0 steht für sie, und R und A sind untere "
     "Grenzen"},
    {"found the step cycle, whose results may not be published with reference to the standard",
     "der Stufenzyklus, dessen Ergebnisse nicht mit Bezug auf die Norm veröffentlicht werden dürfen"},
    {"found {0=} for the date of the test, expected a day such as {1=}: nothing that depends on the day could be "
     "looked at",
     "{0} als Prüfdatum; erwartet: ein Tag wie {1}. Nichts, was vom Tag abhängt, konnte angesehen werden"},
    {"found {0} outside the axis travel, expected all targets within it",
     "{0} außerhalb des Verfahrwegs; erwartet: alle Zielpositionen innerhalb"},
    {"found {0} outside the axis travel, expected all targets within it: do both count from one zero?",
     "{0} außerhalb des Verfahrwegs; erwartet: alle Zielpositionen innerhalb. Zählen beide von einem Nullpunkt aus?"},
    {"kept", "eingehalten"},
    {"no value of the listed parameters {0#}", "kein Wert der aufgeführten Kennwerte {0}"},
    {"not all stated", "nicht alles angegeben"},
    {"on the word of who tested, since no item of a test states it: the standard test cycle was run where no "
     "other is given, machine and instrument were soaked (4.1), the machine complete, levelled and without "
     "load (4.2), and at rest when it was read (5.1); the gradient over the machine is stated, within what was "
     "agreed (4.1)",
     "auf das Wort des Prüfers hin, da keine Angabe einer Prüfung es sagt: gefahren wurde der Normprüfzyklus, "
     "wo kein anderer angegeben ist, Maschine und Messmittel waren durchtemperiert (4.1), die Maschine "
     "vollständig, ausgerichtet und ohne Last (4.2) und beim Ablesen in Ruhe (5.1); der Temperaturgradient "
     "über die Maschine ist angegeben, im vereinbarten Rahmen (4.1)"},
    {"on the word of who tested, since no item of a test states it: the standard test cycle was run where no other is "
     "given, machine and instrument were soaked (4.1), the machine complete, levelled and without load (4.2), and at "
     "rest when it was read (5.1); the log of temperatures shows their gradient over the machine within what was "
     "agreed (4.1)",
     "auf das Wort des Prüfers hin, da keine Angabe einer Prüfung es sagt: gefahren wurde der Normprüfzyklus, wo kein "
     "anderer angegeben ist, Maschine und Messmittel waren durchtemperiert (4.1), die Maschine vollständig, "
     "ausgerichtet und ohne Last (4.2) und beim Ablesen in Ruhe (5.1); die Temperaturaufzeichnung zeigt den "
     "Temperaturgradienten über die Maschine im vereinbarten Rahmen (4.1)"},
    {"on the word of who tested, since no item of a test states it: the standard test cycle was run where "
     "no other is given, machine and instrument were soaked and the gradient of the temperature within "
     "what was agreed (4.1), the machine complete, levelled and without load (4.2), and at rest when it "
     "was read (5.1)",
     "auf das Wort des Prüfers hin, da keine Angabe einer Prüfung es sagt: gefahren wurde der "
     "Normprüfzyklus, wo kein anderer angegeben ist, Maschine und Messmittel waren durchtemperiert und "
     "der Temperaturgradient im vereinbarten Rahmen (4.1), die Maschine vollständig, ausgerichtet und "
     "ohne Last (4.2) und beim Ablesen in Ruhe (5.1)"},
    {"on the word of who tested, since no item of a test states it: the standard test cycle was run where no "
     "other is given, the gradient of the temperature was within what was agreed (4.1), the machine complete, "
     "levelled and without load (4.2), and at rest when it was read (5.1); how long machine and instrument "
     "were soaked is stated (4.1)",
     "auf das Wort des Prüfers hin, da keine Angabe einer Prüfung es sagt: gefahren wurde der Normprüfzyklus, "
     "wo kein anderer angegeben ist, der Temperaturgradient war im vereinbarten Rahmen (4.1), die Maschine "
     "vollständig, ausgerichtet und ohne Last (4.2) und beim Ablesen in Ruhe (5.1); wie lange Maschine und "
     "Messmittel durchtemperiert wurden, ist angegeben (4.1)"},
    {"on the word of who tested, since no item of a test states it: the standard test cycle was run where no "
     "other is given, the machine complete, levelled and without load (4.2), and at rest when it was read "
     "(5.1); the gradient over the machine, within what was agreed, and how long machine and instrument were "
     "soaked are stated (4.1)",
     "auf das Wort des Prüfers hin, da keine Angabe einer Prüfung es sagt: gefahren wurde der Normprüfzyklus, "
     "wo kein anderer angegeben ist, die Maschine war vollständig, ausgerichtet und ohne Last (4.2) und beim "
     "Ablesen in Ruhe (5.1); der Temperaturgradient über die Maschine, im vereinbarten Rahmen, und wie lange "
     "Maschine und Messmittel durchtemperiert wurden, sind angegeben (4.1)"},
    {"on the word of who tested, since no item of a test states it: the standard test cycle was run where no "
     "other is given, the machine complete, levelled and without load (4.2), and at rest when it was read "
     "(5.1); the log of temperatures shows their gradient over the machine within what was agreed, and how "
     "long machine and instrument were soaked is stated (4.1)",
     "auf das Wort des Prüfers hin, da keine Angabe einer Prüfung es sagt: gefahren wurde der Normprüfzyklus, "
     "wo kein anderer angegeben ist, die Maschine war vollständig, ausgerichtet und ohne Last (4.2) und beim "
     "Ablesen in Ruhe (5.1); die Temperaturaufzeichnung zeigt den Temperaturgradienten über die Maschine im "
     "vereinbarten Rahmen, und wie lange Maschine und Messmittel durchtemperiert wurden, ist angegeben (4.1)"},
    {"sampling points of the compensation are not stated, so that nobody can tell whether targets lie on "
     "them",
     "Stützstellen der Kompensation sind nicht angegeben, sodass niemand sagen kann, ob Zielpositionen "
     "auf ihnen liegen"},
    {"temperatures at the start and the end of the test are in the log alone, expected them stated too where nobody "
     "says that differential expansion was corrected: its size is judged by them",
     "Temperaturen am Anfang und am Ende der Prüfung stehen allein in der Temperaturaufzeichnung; erwartet: auch "
     "angegeben, wo niemand sagt, dass die Differenzdehnung korrigiert wurde: Ihre Größe wird danach beurteilt"},
    {"temperatures at the start and the end of the test are not stated",
     "Temperaturen am Anfang und am Ende der Prüfung sind nicht angegeben"},
    {"the date of the test is given as {0=}, expected a day from 1950 to now",
     "das Prüfdatum ist als {0} angegeben, erwartet ein Tag von 1950 bis jetzt"},
    {"the date of the test is given as {0=}, which is no day", "das Prüfdatum ist als {0} angegeben, was kein Tag ist"},
    {"the method of record, {0}, finds an uncertainty of 0 of {1#}, which is none",
     "das maßgebliche Verfahren, {0}, findet eine Unsicherheit von 0 für {1}, und das ist keine"},
    {"the smaller of R↑ and R↓, called unidirectional positioning repeatability in lists of export "
     "control; for information only: no parameter of the standard, and not judged",
     "der kleinere Wert von R↑ und R↓, in Listen der Ausfuhrkontrolle einseitige "
     "Positionierwiederholbarkeit genannt; nur zur Information: kein Kennwert der Norm und nicht beurteilt"},
    {"the uncertainty takes as 0 what nobody knows without doubt: {0}",
     "die Unsicherheit setzt mit 0 an, was niemand ohne Zweifel kennt: {0}"},
    {"whether differential expansion was corrected is not stated",
     "ob die Differenzdehnung korrigiert wurde, ist nicht angegeben"},
    {"{0#} points not stated", "{0} Punkte nicht angegeben"},
    {"{0#} points of clauses 4 and 5 were not stated or not kept; see Claims.",
     "{0} Punkte der Abschnitte 4 und 5 waren nicht angegeben oder nicht eingehalten; siehe Aussagen."},
    {"{0} is not stated", "{0} ist nicht angegeben"},
};

}  // namespace

const std::span<const Phrase> german_claims{claims_rows};

}  // namespace axiometry::language
