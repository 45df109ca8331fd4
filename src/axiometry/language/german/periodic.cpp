// SPDX-License-Identifier: Apache-2.0
// Reports of a periodic positioning error.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase periodic_rows[] = {
    {"Amplitude", "Amplitude"},
    {"Amplitude over period of the deviations at {0#} target positions, with the chosen period marked.",
     "Amplitude der Abweichungen an {0} Zielpositionen über der Periode, die gewählte Periode markiert."},
    {"An investigation, not an acceptance test: the parameters of clause 3 are not stated.",
     "Eine Untersuchung, keine Abnahmeprüfung: Die Kennwerte nach Abschnitt 3 sind nicht angegeben."},
    {"Chance by white noise", "Wahrscheinlichkeit durch weißes Rauschen"},
    {"Chance of the peak by white noise", "Wahrscheinlichkeit der Spitze durch weißes Rauschen"},
    {"Chance of this size by white noise", "Wahrscheinlichkeit dieser Größe durch weißes Rauschen"},
    {"Degrees of freedom", "Freiheitsgrade"},
    {"Deviation less line", "Abweichung ohne Gerade"},
    {"Deviations and the straight line that is removed", "Abweichungen und die Gerade, die abgezogen wird"},
    {"Deviations at {0#} target positions after the straight line was removed, and the fitted curve.",
     "Abweichungen an {0} Zielpositionen nach Abzug der Geraden und die angepasste Kurve."},
    {"Deviations at {0#} target positions folded into one period, and the fitted curve.",
     "Auf eine Periode gefaltete Abweichungen an {0} Zielpositionen und die angepasste Kurve."},
    {"Deviations less the line, with the periodic curve", "Abweichungen ohne die Gerade, mit der periodischen Kurve"},
    {"Each harmonic is {0=}.", "Jede Harmonische ist {0}."},
    {"Figure {0#}. Deviations and the straight line that is removed",
     "Bild {0}. Abweichungen und die Gerade, die abgezogen wird"},
    {"Harmonics above the first belong to the curve where white noise alone would make them as large in less than 1 % "
     "of tests.",
     "Höhere Harmonische gehören zur Kurve, wenn sie durch weißes Rauschen allein in weniger als 1\u00a0% der "
     "Prüfungen so groß würden."},
    {"Harmonics of the period", "Harmonische der Periode"},
    {"No significant periodic error was found", "Keine signifikante periodische Abweichung gefunden"},
    {"No significant periodic error {0#} was found", "Keine signifikante periodische Abweichung {0} gefunden"},
    {"None: nothing departs from Annex C.", "Keine: Nichts weicht von Anhang C ab."},
    {"One period: all targets folded into it, with the curve",
     "Eine Periode: alle Zielpositionen darauf gefaltet, mit der Kurve"},
    {"Part of the curve", "Teil der Kurve"},
    {"Peak to valley of the curve", "Spitze-Tal-Wert der Kurve"},
    {"Period", "Periode"},
    {"Period {0#}: {1#} peak to valley", "Periode {0}: Spitze-Tal-Wert {1}"},
    {"Period ↑ {0#}: {1#} peak to valley", "Periode ↑ {0}: Spitze-Tal-Wert {1}"},
    {"Period ↓ {0#}: {1#} peak to valley", "Periode ↓ {0}: Spitze-Tal-Wert {1}"},
    {"Period, as given", "Periode, wie vorgegeben"},
    {"Period, found", "Periode, gefunden"},
    {"Period, mm", "Periode, mm"},
    {"Period, °", "Periode, °"},
    {"Periodic positioning error (Annex C)", "Periodische Positionsabweichung (Anhang C)"},
    {"Periodic positioning error of {0}", "Periodische Positionsabweichung, {0}"},
    {"Periodic positioning error, from a test that departs from Annex C; see Findings",
     "Periodische Positionsabweichung, aus einer Prüfung, die von Anhang C abweicht; siehe Feststellungen"},
    {"Periods covered", "Überdeckte Perioden"},
    {"Phase at position 0", "Phase an Position 0"},
    {"Phase at the first target", "Phase an der ersten Zielposition"},
    {"Position within the period, from the first target", "Position innerhalb der Periode, ab der ersten Zielposition"},
    {"Positioning deviations at {0#} target positions and the straight line through them.",
     "Positionsabweichungen an {0} Zielpositionen und die Gerade durch sie."},
    {"Range of the deviations less the line", "Spannweite der Abweichungen ohne die Gerade"},
    {"Range of the residuals", "Spannweite der Residuen"},
    {"Removed line at the first target", "Abgezogene Gerade an der ersten Zielposition"},
    {"Results", "Ergebnisse"},
    {"Results, negative approaches (↓)", "Ergebnisse, negative Anfahrrichtung (↓)"},
    {"Results, positive approaches (↑)", "Ergebnisse, positive Anfahrrichtung (↑)"},
    {"Scatter of the means, from the runs", "Streuung der Mittelwerte, aus den Durchläufen"},
    {"Slope of the removed line", "Steigung der abgezogenen Geraden"},
    {"Spectrum: amplitude of a sinusoid of each period beside a line",
     "Spektrum: Amplitude einer Sinuskurve jeder Periode neben einer Geraden"},
    {"Standard deviation of the residuals", "Standardabweichung der Residuen"},
    {"Targets per period", "Zielpositionen je Periode"},
    {"The deviations of a direction, averaged over its runs, are fitted by a straight line and a periodic curve at "
     "once, by least squares.",
     "Den über die Durchläufe gemittelten Abweichungen einer Richtung werden eine Gerade und eine periodische Kurve "
     "gemeinsam nach kleinsten Quadraten angepasst."},
    {"The line is removed in this report only; the readings stay as they were measured.",
     "Die Gerade ist nur in diesem Bericht abgezogen; die Messwerte bleiben, wie sie gemessen wurden."},
    {"The peak to valley is that of the fitted curve; the range of the deviations also holds their noise, and grows "
     "with the number of targets.",
     "Der Spitze-Tal-Wert ist der der angepassten Kurve; die Spannweite der Abweichungen enthält auch ihr Rauschen und "
     "wächst mit der Anzahl der Zielpositionen."},
    {"The period is that of the highest peak of the least-squares spectrum with a line (generalised Lomb–Scargle), "
     "refined by the fit.",
     "Die Periode ist die der höchsten Spitze des Ausgleichsspektrums mit Gerade (verallgemeinertes "
     "Lomb-Scargle-Periodogramm), verfeinert durch die Anpassung."},
    {"The period was given.", "Die Periode war vorgegeben."},
    {"U = k u with {0#} for about 95 % (Student’s t).", "U = k u mit {0} für etwa 95\u00a0% (Student-t)."},
    {"always", "immer"},
    {"amplitude", "Amplitude"},
    {"curve, harmonics {0#}", "Kurve, Harmonische {0}"},
    {"departs from {0#}, Annex C", "weicht ab von {0}, Anhang C"},
    {"departs from {0#}, Annex C · {1}", "weicht ab von {0}, Anhang C · {1}"},
    {"exceeded somewhere by noise alone in 1 % of tests",
     "durch Rauschen allein in 1\u00a0% der Prüfungen irgendwo überschritten"},
    {"found no significant error of the period {0#}: noise alone gives an amplitude of {1#} or more in up to {2#} % of "
     "such tests",
     "keine signifikante Abweichung der Periode {0}: Rauschen allein ergibt in bis zu {2}\u00a0% solcher Prüfungen "
     "eine Amplitude von {1} oder mehr"},
    {"found no significant periodic error: noise alone gives a peak as high as that at {0#} in up to {1#} % of such "
     "tests",
     "keine signifikante periodische Abweichung: Rauschen allein ergibt in bis zu {1}\u00a0% solcher Prüfungen eine so "
     "hohe Spitze wie die bei {0}"},
    {"found residuals that go on from target to target (correlation {0#}): U of the curve was enlarged {1#} times and "
     "U of the line {2#} times, and chances of white noise are too small",
     "Residuen, die von Zielposition zu Zielposition zusammenhängen (Korrelation {0}): U der Kurve wurde auf das "
     "{1}-Fache und U der Geraden auf das {2}-Fache vergrößert, und Wahrscheinlichkeiten durch weißes Rauschen sind zu "
     "klein"},
    {"found residuals that go on from target to target (correlation {0#}): U of the line was enlarged {1#} times, that "
     "of so short a period not, and chances of white noise are too small",
     "Residuen, die von Zielposition zu Zielposition zusammenhängen (Korrelation {0}): U der Geraden wurde auf das "
     "{1}-Fache vergrößert, die einer so kurzen Periode nicht, und Wahrscheinlichkeiten durch weißes Rauschen sind zu "
     "klein"},
    {"mean of {0#} runs", "Mittelwert aus {0} Durchläufen"},
    {"no, not significant", "nein, nicht signifikant"},
    {"period as given", "vorgegebene Periode"},
    {"period found", "gefundene Periode"},
    {"reading", "Messwert"},
    {"sinusoid", "Sinuskurve"},
    {"straight line", "Gerade"},
    {"{0#} = {1#} with {2#} = {3#} for a probability of about 95 %, from the residuals of the fit alone: nothing of "
     "the instrument is in it.",
     "{0} = {1} mit {2} = {3} für eine Wahrscheinlichkeit von etwa 95\u00a0%, aus den Residuen der Anpassung allein: "
     "Vom Messgerät ist nichts darin enthalten."},
    {"{0#}, Annex C", "{0}, Anhang C"},
};

}  // namespace

const std::span<const Phrase> german_periodic{periodic_rows};

}  // namespace axiometry::language
