// SPDX-License-Identifier: Apache-2.0
// Labels, titles and descriptions of figures.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase rows[] = {
    {"All runs {0#}", "Alle Läufe {0}"},
    {"Annex A, ± {0#}", "Anhang A, ± {0}"},
    {"Approach ↑ and reading", "Anfahrt ↑ und Messwert"},
    {"Approach ↓ and reading", "Anfahrt ↓ und Messwert"},
    {"Conformity of {0} to its tolerances. Rule: {1}", "Konformität mit den Grenzwerten, {0}. Regel: {1}"},
    {"Contributions of the inputs to the standard uncertainty, and their parts of the variance",
     "Beiträge der Eingangsgrößen zur Standardunsicherheit und ihre Anteile an der Varianz"},
    {"Deviation", "Abweichung"},
    {"Distributions of the parameters of {0} by the Monte Carlo method ({1})",
     "Verteilungen der Kennwerte nach der Monte-Carlo-Methode, {0} ({1})"},
    {"Each parameter against its tolerance: {0}.", "Jeder Kennwert gegen seinen Grenzwert: {0}."},
    {"Figure 2. Bidirectional positioning errors and repeatability of {0}",
     "Bild 2. Beidseitige Positionsabweichungen und Wiederholpräzision, {0}"},
    {"Figure {0=}. Unidirectional positioning errors and repeatability of {1}, {2}",
     "Bild {0}. Einseitige Positionsabweichungen und Wiederholpräzision, {1}, {2}"},
    {"GUM, ± {0#}", "GUM, ± {0}"},
    {"Histograms of the parameters: {0}.", "Histogramme der Kennwerte: {0}."},
    {"Largest contribution to {0#}: {1}.", "Größter Beitrag zu {0}: {1}."},
    {"Magnitude / % of the tolerance {0#}", "Betrag / % des Grenzwerts {0}"},
    {"Mean positioning deviations of {0} with their repeatability bands at {1#} target positions, {2}.",
     "Mittlere Positionsabweichungen ({0}) mit ihren Wiederholbändern an {1} Zielpositionen, {2}."},
    {"Mean positioning deviations of {0} with their repeatability bands at {1#} target positions, {2}: {3}.",
     "Mittlere Positionsabweichungen ({0}) mit ihren Wiederholbändern an {1} Zielpositionen, {2}: {3}."},
    {"Overrun", "Überlauf"},
    {"Position", "Position"},
    {"Position along the diagonal", "Position entlang der Diagonale"},
    {"Run {0#}", "Durchlauf {0}"},
    {"Scales", "Skalen"},
    {"Target {0#}", "Zielpos. {0}"},
    {"Test programme, pilgrim cycle: the way of the axis over the time",
     "Prüfprogramm, Pilgerschrittzyklus: Weg der Achse über der Zeit"},
    {"Test programme, standard cycle: the way of the axis over the time",
     "Prüfprogramm, Normzyklus: Weg der Achse über der Zeit"},
    {"Test programme, step cycle: the way of the axis over the time",
     "Prüfprogramm, Stufenzyklus: Weg der Achse über der Zeit"},
    {"Test programme, unidirectional cycle: the way of the axis over the time",
     "Prüfprogramm, einseitiger Zyklus: Weg der Achse über der Zeit"},
    {"Test programme, user-defined cycle: the way of the axis over the time",
     "Prüfprogramm, benutzerdefinierter Zyklus: Weg der Achse über der Zeit"},
    {"Time / {0#}", "Zeit / {0}"},
    {"Warm-up", "Warmlauf"},
    {"Way without reading", "Weg ohne Messwert"},
    {"approached from both directions", "aus beiden Richtungen angefahren"},
    {"does not vary", "ändert sich nicht"},
    {"limit", "Grenzwert"},
    {"limit {0#}", "Grenzwert {0}"},
    {"mean of the distribution", "Mittelwert der Verteilung"},
    {"measured", "gemessen"},
    {"negative approaches (↓)", "negative Anfahrrichtung (↓)"},
    {"positive approaches (↑)", "positive Anfahrrichtung (↑)"},
    {"readings", "Messwerte"},
    {"this machine", "diese Maschine"},
    {"this test", "diese Prüfung"},
    {"tolerance", "Grenzwert"},
    {"tolerance {0#}", "Grenzwert {0}"},
    {"value", "Wert"},
    {"value ± {0#} ({1#} = 2)", "Wert ± {0} ({1} = 2)"},
    {"{0#} = {1#} of {2#}, {3}", "{0} = {1} von {2}, {3}"},
    {"{0#} interval", "{0}-Intervall"},
    {"{0#} measured {1#}, mean {2#}, interval {3#} to {4#}", "{0} gemessen {1}, Mittelwert {2}, Intervall {3} bis {4}"},
    {"{0#} moves: too many to draw", "{0} Bewegungen: zu viele zum Zeichnen"},
    {"{0#} others together", "{0} weitere zusammen"},
    {"{0#} targets, {1#} run, {2#} readings.", "{0} Zielpositionen, {1} Durchlauf, {2} Messwerte."},
    {"{0#} targets, {1#} runs, {2#} readings.", "{0} Zielpositionen, {1} Durchläufe, {2} Messwerte."},
};

}  // namespace

const std::span<const Phrase> german_figures{rows};

}  // namespace axiometry::language
