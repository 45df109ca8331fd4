// SPDX-License-Identifier: Apache-2.0
// Faults of the simulated axis, and how they show.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase simulation_rows[] = {
    {"A few µm of everything; curves without a pattern", "Von allem wenige µm; Kurven ohne Muster"},
    {"A jagged curve that ↑ and ↓ share; its period shows only at targets closer than it",
     "Eine gezackte Kurve, die ↑ und ↓ teilen; ihre Periode zeigt sich nur an dichteren Zielpositionen"},
    {"A straight slope that no screw has; E grows with the travel, R stays small",
     "Eine gerade Steigung, die keine Spindel hat; E wächst mit dem Verfahrweg, R bleibt klein"},
    {"B grows in one part of the travel", "B wächst in einem Teil des Verfahrwegs"},
    {"Bands that widen with the distance from the zero point",
     "Bänder, die mit dem Abstand vom Nullpunkt breiter werden"},
    {"Each run lies above the one before, most at the far end; R grows along the travel",
     "Jeder Durchlauf liegt über dem vorigen, am fernen Ende am meisten; R wächst entlang des Verfahrwegs"},
    {"Look for one fault after the other, largest first", "Einen Fehler nach dem anderen suchen, den größten zuerst"},
    {"One wide band among narrow ones", "Ein breites Band unter schmalen"},
    {"Runs lie apart by the same amount at every target",
     "Durchläufe liegen an jeder Zielposition um denselben Betrag auseinander"},
    {"R↑ larger than R↓, ↑ below ↓ on average", "R↑ größer als R↓, ↑ im Mittel unter ↓"},
    {"The curves ↑ and ↓ are parallel, B as large at every target",
     "Die Kurven ↑ und ↓ sind parallel, B ist an jeder Zielposition gleich groß"},
    {"The curves ↑ and ↓ part slowly behind each end of the travel",
     "Die Kurven ↑ und ↓ trennen sich hinter jedem Ende des Verfahrwegs langsam"},
    {"Whole runs, or parts of them, lie apart at every target",
     "Ganze Durchläufe oder Teile davon liegen an jeder Zielposition auseinander"},
    {"Wide bands of the same size at every target, both directions",
     "Breite Bänder gleicher Größe an jeder Zielposition, in beiden Richtungen"},
    {"Wide bands without outliers; the recording swings at rest",
     "Breite Bänder ohne Ausreißer; die Aufzeichnung schwingt in Ruhe"},
    {"a bit of everything, as machines have it", "von allem etwas, wie Maschinen es haben"},
    {"a control loop that does not come to rest", "ein Regelkreis, der nicht zur Ruhe kommt"},
    {"a mirror that shifts now and then", "ein Spiegel, der sich ab und zu verschiebt"},
    {"a restless instrument or table", "ein unruhiges Messgerät oder ein unruhiger Tisch"},
    {"an error that repeats with every turn of the screw",
     "ein Fehler, der sich mit jeder Spindelumdrehung wiederholt"},
    {"elastic wind-up that needs a way to turn round", "elastische Verdrehung, die zum Umkehren einen Weg braucht"},
    {"friction lets the axis stop short, more ↑ than ↓", "Reibung lässt die Achse vor dem Ziel halten, ↑ mehr als ↓"},
    {"nothing: an axis in good order", "keiner: eine Achse in Ordnung"},
    {"pitch errors of screw or scale", "Steigungsfehler von Spindel oder Maßstab"},
    {"play and pitch error where the screw is used most", "Spiel und Steigungsfehler, wo die Spindel am meisten läuft"},
    {"play in the drive", "Spiel im Antrieb"},
    {"single readings far away", "einzelne Messwerte weit daneben"},
    {"the instrument corrects a warm machine with another material's expansion",
     "das Messgerät korrigiert eine warme Maschine mit der Ausdehnung eines anderen Werkstoffs"},
    {"the screw grows while the test runs", "die Spindel wächst, während die Prüfung läuft"},
    {"the zero of the instrument wanders", "der Nullpunkt des Messgeräts wandert"},
    {"turbulent or drifting air in the beam", "unruhige oder ziehende Luft im Strahl"},
    {"↑ and ↓ follow one slanted or bent curve; E and M large, B and R small",
     "↑ und ↓ folgen einer geneigten oder gebogenen Kurve; E und M groß, B und R klein"},
};

}  // namespace

const std::span<const Phrase> german_simulation{simulation_rows};

}  // namespace axiometry::language
