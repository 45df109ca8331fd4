// SPDX-License-Identifier: Apache-2.0
// Captures of lengths from the workbench: parts of plans, what the simulator plays, refusals.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase length_captures_rows[] = {
    {"Nothing goes wrong", "Nichts geht schief"},
    {"One dead path for all lengths, each within the noise",
     "Eine Totstrecke für alle Längen, jede innerhalb des Rauschens"},
    {"Samples are missing, and the lengths from there on have another dead path",
     "Abtastwerte fehlen, und die Längen von da an haben eine andere Totstrecke"},
    {"The beam is broken once on the way", "Der Strahl wird unterwegs einmal unterbrochen"},
    {"all {0#} lines", "alle {0} Linien"},
    {"found a part among the options, expected it beside the plan of the lengths",
     "ein Teil unter den Optionen; erwartet: neben dem Plan der Längen"},
    {"found a plan beside lengths, expected one of them", "ein Plan neben Längen; erwartet: eines von beiden"},
    {"found capture {0=} not at its end, expected one that has ended",
     "Messung {0} ist nicht am Ende; erwartet: eine, die geendet hat"},
    {"found capture {0=} of a test, expected one of lengths", "Messung {0} einer Prüfung; erwartet: eine von Längen"},
    {"found capture {0=} of another plan, expected captures of one plan",
     "Messung {0} zu einem anderen Plan; erwartet: Messungen eines Plans"},
    {"found capture {0=} running, expected one that has ended", "Messung {0} läuft; erwartet: eine, die geendet hat"},
    {"found line {0#} asked for, expected 1 to {1#}, or 0 for all lines",
     "Linie {0} verlangt; erwartet: 1 bis {1}, oder 0 für alle Linien"},
    {"found no captures, expected the numbers of 1 to {0#}",
     "keine Messungen; erwartet: die Nummern von 1 bis {0} Messungen"},
    {"found no file {0=} of capture {1=}", "keine Datei {0} zu Messung {1}"},
    {"found the kind {0=}, expected lines or volume", "Art {0}; erwartet: lines oder volume"},
    {"found the unknown member {0=}, expected kind, plan and part",
     "unbekannter Eintrag {0}; erwartet: kind, plan und part"},
    {"lengths: found {0}, expected an object", "lengths: {0}; erwartet: ein Objekt"},
    {"measuring line {0=}", "Messlinie {0}"},
    {"no line", "keine Linie"},
    {"part {0#}", "Teil {0}"},
};

}  // namespace

const std::span<const Phrase> german_length_captures = length_captures_rows;

}  // namespace axiometry::language
