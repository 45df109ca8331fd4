// SPDX-License-Identifier: Apache-2.0
// Outliers, uneven scatter, shifts and drifts of the runs.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase scatter_rows[] = {
    {"found an outlier at target {0#} run {1#}: a reading of {2#}, which lies {3#} above what the other "
     "readings of target and run let expect ({4#}); {5}, and nothing is removed",
     "ein Ausreißer an Zielposition {0}, Durchlauf {1}: ein Messwert von {2}, der {3} über dem liegt, was "
     "die übrigen Messwerte von Zielposition und Durchlauf erwarten lassen ({4}); {5}, und nichts ist "
     "entfernt"},
    {"found an outlier at target {0#} run {1#}: a reading of {2#}, which lies {3#} below what the other "
     "readings of target and run let expect ({4#}); {5}, and nothing is removed",
     "ein Ausreißer an Zielposition {0}, Durchlauf {1}: ein Messwert von {2}, der {3} unter dem liegt, "
     "was die übrigen Messwerte von Zielposition und Durchlauf erwarten lassen ({4}); {5}, und nichts ist "
     "entfernt"},
    {"found every reading ↓ equal to the one ↑ of its run and target, expected some reversal or scatter between "
     "them; copied or coarsely rounded readings make every reversal error zero",
     "jeder Messwert ↓ gleich dem ↑ seines Durchlaufs an derselben Zielposition; erwartet: etwas Umkehrspanne oder "
     "Streuung dazwischen; kopierte oder grob gerundete Messwerte machen jede Umkehrspanne zu null"},
    {"found readings in steps of {0#} that scatter by {1#} about their means, no more than half a step: rounding may "
     "have made or hidden as much, and s_i and what rests on it are those of the steps as much as of the machine",
     "Messwerte in Schritten von {0}, die um ihre Mittelwerte mit {1} streuen, nicht mehr als einem halben Schritt: "
     "Rundung kann ebenso viel erzeugt oder verdeckt haben, und s_i und was darauf beruht sind die der Schritte so "
     "sehr wie die der Maschine"},
    {"found readings that scatter by {0#} about their means, no more than half of the resolution of {1#} that is "
     "stated: rounding may have made or hidden as much, and s_i and what rests on it are those of its steps as much as "
     "of the machine",
     "Messwerte, die um ihre Mittelwerte mit {0} streuen, nicht mehr als der Hälfte der angegebenen Auflösung von {1}: "
     "Rundung kann ebenso viel erzeugt oder verdeckt haben, und s_i und was darauf beruht sind die ihrer Schritte so "
     "sehr wie die der Maschine"},
    {"found readings that scatter by {0#} and by {1#} ({2#}): R↑ is {3#} and R↓ {4#}; {5}",
     "Messwerte, die um {0} und um {1} streuen ({2}): R↑ ist {3}, R↓ {4}; {5}"},
    {"found readings that scatter by {0#} at target {1#}, where they do not scatter elsewhere ({2#}); "
     "{3}; {4}",
     "Messwerte, die an Zielposition {1} um {0} streuen, während sie sonst nicht streuen ({2}); {3}; {4}"},
    {"found readings that scatter by {0#} at target {1#}, {2#} times as much as the {3#} elsewhere "
     "({4#}); {5}; {6}",
     "Messwerte, die an Zielposition {1} um {0} streuen, das {2}-Fache der {3} an den übrigen ({4}); {5}; "
     "{6}"},
    {"found readings that scatter by {0#} at targets {1#} to {2#}, where they do not scatter elsewhere "
     "({3#}); {4}; {5}",
     "Messwerte, die an den Zielpositionen {1} bis {2} um {0} streuen, während sie sonst nicht streuen "
     "({3}); {4}; {5}"},
    {"found readings that scatter by {0#} at targets {1#} to {2#}, {3#} times as much as the {4#} "
     "elsewhere ({5#}); {6}; {7}",
     "Messwerte, die an den Zielpositionen {1} bis {2} um {0} streuen, das {3}-Fache der {4} an den "
     "übrigen ({5}); {6}; {7}"},
    {"found the readings falling from run to run, by {0#} from the first run to the last, where they "
     "scatter by {1#} about target and run ({2#}): a sign that the machine was not thermally stable; {3}, "
     "and nothing is removed",
     "die Messwerte fallen von Durchlauf zu Durchlauf, um {0} vom ersten zum letzten, wo sie um "
     "Zielposition und Durchlauf um {1} streuen ({2}): ein Zeichen, dass die Maschine thermisch nicht "
     "stabil war; {3}, und nichts ist entfernt"},
    {"found the readings of a run shifted as a whole, by {0#} from run to run (standard deviation), where "
     "they scatter by {1#} about target and run ({2#}); run {3#} lies {4#} above the mean; {5}, and "
     "nothing is removed",
     "die Messwerte eines Durchlaufs sind als Ganzes verschoben, um {0} von Durchlauf zu Durchlauf "
     "(Standardabweichung), wo sie um Zielposition und Durchlauf um {1} streuen ({2}); Durchlauf {3} "
     "liegt {4} über dem Mittel; {5}, und nichts ist entfernt"},
    {"found the readings of a run shifted as a whole, by {0#} from run to run (standard deviation), where "
     "they scatter by {1#} about target and run ({2#}); run {3#} lies {4#} below the mean; {5}, and "
     "nothing is removed",
     "die Messwerte eines Durchlaufs sind als Ganzes verschoben, um {0} von Durchlauf zu Durchlauf "
     "(Standardabweichung), wo sie um Zielposition und Durchlauf um {1} streuen ({2}); Durchlauf {3} "
     "liegt {4} unter dem Mittel; {5}, und nichts ist entfernt"},
    {"found the readings rising from run to run, by {0#} from the first run to the last, where they "
     "scatter by {1#} about target and run ({2#}): a sign that the machine was not thermally stable; {3}, "
     "and nothing is removed",
     "die Messwerte steigen von Durchlauf zu Durchlauf, um {0} vom ersten zum letzten, wo sie um "
     "Zielposition und Durchlauf um {1} streuen ({2}): ein Zeichen, dass die Maschine thermisch nicht "
     "stabil war; {3}, und nichts ist entfernt"},
    {"found {0#} of {1#} runs, each direction counted, equal to another at all {2#} targets, such as run {3#} to run "
     "{4#} with the other sign; chance hardly makes that, and what was copied was not measured",
     "{0} von {1} Durchläufen, jede Richtung gezählt, an allen {2} Zielpositionen gleich einem anderen, etwa Durchlauf "
     "{3} dem Durchlauf {4} mit umgekehrtem Vorzeichen; der Zufall macht das kaum, und was kopiert wurde, wurde nicht "
     "gemessen"},
    {"found {0#} of {1#} runs, each direction counted, equal to another at all {2#} targets, such as run {3#} to run "
     "{4#}; chance hardly makes that, and what was copied was not measured",
     "{0} von {1} Durchläufen, jede Richtung gezählt, an allen {2} Zielpositionen gleich einem anderen, etwa Durchlauf "
     "{3} dem Durchlauf {4}; der Zufall macht das kaum, und was kopiert wurde, wurde nicht gemessen"},
    {"no parameter depends on it by more than 1 %", "kein Parameter hängt um mehr als 1\u00a0% von ihm ab"},
    {"no parameter depends on these shifts by more than 1 %",
     "kein Parameter hängt um mehr als 1\u00a0% von diesen Verschiebungen ab"},
    {"no parameter depends on these targets by more than 1 %",
     "kein Parameter hängt um mehr als 1\u00a0% von diesen Zielpositionen ab"},
    {"no parameter depends on this drift by more than 1 %",
     "kein Parameter hängt um mehr als 1\u00a0% von dieser Drift ab"},
    {"no parameter depends on this target by more than 1 %",
     "kein Parameter hängt um mehr als 1\u00a0% von dieser Zielposition ab"},
    {"s_i go from {0#} to {1#}", "die s_i reichen von {0} bis {1}"},
    {"without it {0#} would be {1#} instead of {2#}", "ohne ihn wäre {0} {1} statt {2}"},
    {"without these shifts {0#} would be {1#} instead of {2#}", "ohne diese Verschiebungen wäre {0} {1} statt {2}"},
    {"without these targets {0#} would be {1#} instead of {2#}", "ohne diese Zielpositionen wäre {0} {1} statt {2}"},
    {"without this drift {0#} would be {1#} instead of {2#}", "ohne diese Drift wäre {0} {1} statt {2}"},
    {"without this target {0#} would be {1#} instead of {2#}", "ohne diese Zielposition wäre {0} {1} statt {2}"},
};

}  // namespace

const std::span<const Phrase> german_scatter{scatter_rows};

}  // namespace axiometry::language
