// SPDX-License-Identifier: Apache-2.0
// To within what the positions of an axis are known that a table corrects.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase known_positions_rows[] = {
    {"Anywhere between the first target and the last: within {0#}.",
     "Überall zwischen erstem und letztem Ziel: innerhalb von {0}."},
    {"At each target about 95 % of approaches or more will end within {0#} of their position, once the zero is shifted "
     "by {1#}, if the axis stays as it is.",
     "An jedem Ziel enden etwa 95 % der Anfahrten oder mehr, sobald der Nullpunkt um {1} verschoben ist, innerhalb von "
     "{0} um ihre Position, wenn die Achse bleibt, wie sie ist."},
    {"Known to within, with the table", "Wie genau bekannt, mit der Tabelle"},
    {"Left ↑ / {0=}", "Rest ↑ / {0}"},
    {"Left ↓ / {0=}", "Rest ↓ / {0}"},
    {"Left: the mean deviation with the table as the control reads and rounds it, about the mean of all, by the "
     "readings that made the table.",
     "Rest: die mittlere Abweichung mit der Tabelle, wie die Steuerung sie liest und rundet, um den Mittelwert aller, "
     "nach den Messwerten, aus denen die Tabelle stammt."},
    {"Target / {0=}", "Ziel / {0}"},
    {"To within what positions are known nobody can say; the notes tell why.",
     "Wie genau Positionen bekannt sind, kann niemand sagen; die Bemerkungen nennen den Grund."},
    {"U: of the position that one approach ends at, for about 95 %: the uncertainty of the mean deviation (Lira & "
     "Cargill, eq. 8), and the scatter of the approach itself.",
     "U: der Position, an der eine Anfahrt endet, für etwa 95 %: die Unsicherheit der mittleren Abweichung (Lira & "
     "Cargill, Gl. 8) und die Streuung der Anfahrt selbst."},
    {"What it is between the targets nobody can say; the notes tell why.",
     "Wie es zwischen den Zielen ist, kann niemand sagen; die Bemerkungen nennen den Grund."},
    {"an error that repeats from target to target alike, as with the pitch of a screw, is not in what is stated "
     "between the targets",
     "eine Abweichung, die sich von Ziel zu Ziel gleich wiederholt, etwa mit der Steigung einer Spindel, ist in der "
     "Angabe zwischen den Zielen nicht enthalten"},
    {"temperatures and expansion of the machine are not in U: nothing is stated of their uncertainty",
     "Temperaturen und Ausdehnung der Maschine sind in U nicht enthalten: Zu ihrer Unsicherheit ist nichts angegeben"},
    {"the alignment is not in U: nothing is stated of its uncertainty",
     "die Ausrichtung ist in U nicht enthalten: Zu ihrer Unsicherheit ist nichts angegeben"},
    {"the calibration of the instrument is not in U: nothing is stated of its uncertainty",
     "die Kalibrierung des Messgeräts ist in U nicht enthalten: Zu ihrer Unsicherheit ist nichts angegeben"},
    {"to within what positions are known is not stated: it takes two approaches to every target",
     "wie genau Positionen bekannt sind, wird nicht angegeben: Dazu braucht es zwei Anfahrten jedes Ziels"},
    {"to within what positions are known is not stated: no scatter explains all of the readings",
     "wie genau Positionen bekannt sind, wird nicht angegeben: Keine Streuung erklärt alle Messwerte"},
    {"to within what positions are known is not stated: nobody knows how large such an effect is",
     "wie genau Positionen bekannt sind, wird nicht angegeben: Niemand weiß, wie groß ein solcher Einfluss ist"},
    {"what is between targets over twice as far apart as they are on average is not stated: the other gaps do not tell",
     "was zwischen Zielpositionen liegt, die mehr als doppelt so weit auseinander sind wie im Mittel, ist nicht "
     "angegeben: Die anderen Abstände sagen darüber nichts"},
    {"what is between the targets is not stated: it takes three of them",
     "was zwischen den Zielen liegt, wird nicht angegeben: Dazu braucht es drei"},
    {"what such an effect may amount to is added to the largest that is stated, not to U of a target",
     "was ein solcher Einfluss ausmachen kann, ist im größten angegebenen Wert enthalten, nicht in U eines Ziels"},
    {"{0#} of {1#} targets: the result as JSON has all.", "{0} von {1} Zielen: Das Ergebnis als JSON hat alle."},
};

}  // namespace

const std::span<const Phrase> german_known_positions{known_positions_rows};

}  // namespace axiometry::language
