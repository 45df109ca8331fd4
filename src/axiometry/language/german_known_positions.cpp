// SPDX-License-Identifier: Apache-2.0
// To within what the positions of an axis are known that a table corrects.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase rows[] = {
    {"Anywhere between the first target and the last: within {0#}.",
     "Überall zwischen erstem und letztem Ziel: innerhalb von {0}."},
    {"At each target about 95 % of approaches or more will end within {0#} of their position, a new zero apart, if the "
     "axis stays as it is.",
     "An jedem Ziel enden etwa 95 % der Anfahrten oder mehr, von einem neuen Nullpunkt abgesehen, innerhalb von {0} um "
     "ihre Position, wenn die Achse bleibt, wie sie ist."},
    {"Known to within, with the table", "Wie genau bekannt, mit der Tabelle"},
    {"Left ↑ / {0=}", "Rest ↑ / {0}"},
    {"Left ↓ / {0=}", "Rest ↓ / {0}"},
    {"Left: the mean deviation with the table as the control reads and rounds it, about the mean of all, by the "
     "readings that made the table.",
     "Rest: die mittlere Abweichung mit der Tabelle, wie die Steuerung sie liest und rundet, um den Mittelwert aller, "
     "nach den Messwerten, aus denen die Tabelle stammt."},
    {"Target / {0=}", "Ziel / {0}"},
    {"To within what positions are known nobody can say: it takes two approaches to every target.",
     "Wie genau Positionen bekannt sind, kann niemand sagen: Dazu braucht es zwei Anfahrten jedes Ziels."},
    {"U: of the position that one approach ends at, for about 95 %: the uncertainty of the mean deviation (Lira & "
     "Cargill, eq. 8), and the scatter of the approach itself.",
     "U: der Position, an der eine Anfahrt endet, für etwa 95 %: die Unsicherheit der mittleren Abweichung (Lira & "
     "Cargill, Gl. 8) und die Streuung der Anfahrt selbst."},
    {"What it is between the targets nobody can say: it takes three of them.",
     "Wie es zwischen den Zielen ist, kann niemand sagen: Dazu braucht es drei."},
    {"nothing is stated of the uncertainty of instrument, temperatures and alignment: only the scatter of the "
     "approaches counts",
     "zur Unsicherheit von Messgerät, Temperaturen und Ausrichtung ist nichts angegeben: Nur die Streuung der "
     "Anfahrten zählt"},
    {"{0#} of {1#} targets: the result as JSON has all.", "{0} von {1} Zielen: Das Ergebnis als JSON hat alle."},
};

}  // namespace

const std::span<const Phrase> german_known_positions{rows};

}  // namespace axiometry::language
