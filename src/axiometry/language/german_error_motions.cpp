// SPDX-License-Identifier: Apache-2.0
// Straightness, angles and squareness.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase rows[] = {
    {"Added to the error at the measured line.", "Kommt zur Abweichung an der gemessenen Geraden hinzu."},
    {"Angle of the line, θ", "Winkel der Geraden, θ"},
    {"Angles", "Winkel"},
    {"Angular errors", "Winkelabweichungen"},
    {"Angular errors {0=}", "Winkelabweichungen {0}"},
    {"At another point", "An einem anderen Punkt"},
    {"Change of the errors at an offset of {0#} mm from the measured line",
     "Änderung der Abweichungen bei einem Versatz von {0} mm von der gemessenen Geraden"},
    {"Course", "Verlauf"},
    {"Error", "Abweichung"},
    {"Error of the optical square", "Abweichung des optischen Winkels"},
    {"First line", "Erste Gerade"},
    {"Formulas not checked against the text of ISO 230-1", "Formeln nicht am Text von ISO 230-1 geprüft"},
    {"Largest change, µm", "Größte Änderung, µm"},
    {"Largest reversal, ↑ less ↓", "Größte Umkehrspanne, ↑ minus ↓"},
    {"Line at position 0", "Gerade an Position 0"},
    {"Mean reversal", "Mittlere Umkehrspanne"},
    {"Means at {0#} positions.", "Mittelwerte an {0} Positionen."},
    {"Means over the runs at each position; the mean of both directions where there are two.",
     "Mittelwerte der Durchläufe an jeder Position; das Mittel beider Richtungen, wo es zwei gibt."},
    {"No line is removed from angles: their slope is a bend or a twist of the way.",
     "Von Winkeln wird keine Gerade abgezogen: Ihre Steigung ist eine Biegung oder Verdrehung der Führung."},
    {"No uncertainty of the change is stated.", "Eine Unsicherheit der Änderung ist nicht angegeben."},
    {"Not known without", "Nicht bekannt ohne"},
    {"Nothing tells an uncertainty.", "Über die Unsicherheit ist nichts bekannt."},
    {"Of the moving part, in axes of the machine; where it carries the workpiece, the tool sees the opposite sign.",
     "Des bewegten Teils, in Achsen der Maschine; trägt es das Werkstück, so sieht das Werkzeug das umgekehrte "
     "Vorzeichen."},
    {"Position, mm", "Position, mm"},
    {"Positions", "Positionen"},
    {"Positions {0=}", "Positionen {0}"},
    {"Range of the angle", "Spannweite des Winkels"},
    {"Range of the change, µm", "Spannweite der Änderung, µm"},
    {"Range over both directions", "Spannweite über beide Richtungen"},
    {"Range over both directions, about one line", "Spannweite über beide Richtungen, um eine Gerade"},
    {"Reading", "Messwert"},
    {"Readings less the line", "Messwerte ohne die Gerade"},
    {"Readings less the line: {0=}", "Messwerte ohne die Gerade: {0}"},
    {"Readings over the position", "Messwerte über der Position"},
    {"Readings over the position: {0=}", "Messwerte über der Position: {0}"},
    {"Reference line", "Bezugsgerade"},
    {"Repeatability, largest", "Wiederholpräzision, größte"},
    {"Second line", "Zweite Gerade"},
    {"Slope of the first line, θ₁", "Steigung der ersten Geraden, θ₁"},
    {"Slope of the line", "Steigung der Geraden"},
    {"Slope of the second line, θ₂", "Steigung der zweiten Geraden, θ₂"},
    {"Squareness of two axes", "Rechtwinkligkeit zweier Achsen"},
    {"Squareness of two axes {0=}", "Rechtwinkligkeit zweier Achsen {0}"},
    {"Squareness over one metre", "Rechtwinkligkeit über einen Meter"},
    {"Squareness, θ₂ − θ₁ + error of the square", "Rechtwinkligkeit, θ₂ − θ₁ + Abweichung des Winkels"},
    {"Straightness", "Geradheit"},
    {"Straightness {0=}", "Geradheit {0}"},
    {"Straightness, range of the residuals", "Geradheit, Spannweite der Residuen"},
    {"The position of the highest and the lowest residual is taken as known.",
     "Wo das höchste und das tiefste Residuum liegen, gilt als bekannt."},
    {"To be known with these figures", "Zu diesen Werten gehört"},
    {"U for about 95 %, from both lines, whose tables say what theirs holds, and the optical square.",
     "U für etwa 95\u00a0%, aus beiden Geraden, deren Tabellen sagen, was ihre enthält, und dem optischen Winkel."},
    {"U for about 95 %, from both lines, whose tables say what theirs holds.",
     "U für etwa 95\u00a0%, aus beiden Geraden; deren Tabellen sagen, was ihre enthält."},
    {"U for about 95 %, from the instrument alone.", "U für etwa 95\u00a0%, allein aus dem Messgerät."},
    {"U for about 95 %, from the scatter of the runs alone.",
     "U für etwa 95\u00a0%, allein aus der Streuung der Durchläufe."},
    {"U for about 95 %, from the scatter of the runs and the instrument.",
     "U für etwa 95\u00a0%, aus der Streuung der Durchläufe und dem Messgerät."},
    {"U for about 95 %, of a line from its residuals alone; a range has none.",
     "U für etwa 95\u00a0%, einer Geraden allein aus ihren Residuen; eine Spannweite hat keine."},
    {"U for about 95 %, of a line from its residuals and the instrument, of a range from the instrument alone.",
     "U für etwa 95\u00a0%, einer Geraden aus ihren Residuen und dem Messgerät, einer Spannweite allein aus dem "
     "Messgerät."},
    {"U of a slope and of a range is from the same figure of each run, as a mean of independent runs, or from the "
     "noise within the runs where that is larger; the instrument’s part holds for every correlation between positions "
     "and falls neither with positions nor with runs.",
     "U einer Steigung und einer Spannweite folgt aus derselben Größe jedes Durchlaufs, als Mittel unabhängiger "
     "Durchläufe, oder aus dem Rauschen innerhalb der Durchläufe, wo das größer ist; der Anteil des Messgeräts gilt "
     "für jede Korrelation zwischen den Positionen und sinkt weder mit Positionen noch mit Durchläufen."},
    {"end points", "Endpunkte"},
    {"least squares", "kleinste Quadrate"},
    {"mean in {0#}", "Mittel in {0}"},
    {"mean less its line", "Mittel ohne seine Gerade"},
    {"no column direction: all readings are taken as positive approaches",
     "keine Spalte für die Richtung: Alle Messwerte gelten als positive Anfahrten"},
    {"no error of the optical square is stated: it counts as 0, and the squareness holds it",
     "keine Abweichung des optischen Winkels ist angegeben: Sie gilt als 0 und steckt in der Rechtwinkligkeit"},
    {"no uncertainty of the instrument is stated: U does not hold it",
     "keine Unsicherheit des Messgeräts ist angegeben: U enthält sie nicht"},
    {"no uncertainty of the optical square is stated: U does not hold it",
     "keine Unsicherheit des optischen Winkels ist angegeben: U enthält sie nicht"},
    {"one run: what does not repeat cannot be told from the shape, and there is no repeatability",
     "ein Durchlauf: Was sich nicht wiederholt, ist von der Form nicht zu unterscheiden, und es gibt keine "
     "Wiederholpräzision"},
    {"the files do not both name their error: whether they are of one plane was not checked",
     "nicht beide Dateien nennen ihre Abweichung: Ob sie in einer Ebene liegen, wurde nicht geprüft"},
    {"{0#} less its line", "{0} ohne seine Gerade"},
};

}  // namespace

const std::span<const Phrase> german_error_motions{rows};

}  // namespace axiometry::language
