// SPDX-License-Identifier: Apache-2.0
// Straightness, angles and squareness.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase error_motions_rows[] = {
    {"A line for each of {0#} stretch.", "Eine Linie für {0} Strecke."},
    {"A line for each of {0#} stretches.", "Je eine Linie für {0} Strecken."},
    {"Acceleration", "Beschleunigung"},
    {"Acceleration at {0#} samples.", "Beschleunigung an {0} Abtastwerten."},
    {"Acceleration over time", "Beschleunigung über der Zeit"},
    {"Added to the error at the measured line.", "Kommt zur Abweichung an der gemessenen Geraden hinzu."},
    {"Amplitude / µm", "Amplitude / µm"},
    {"Amplitude / ″", "Amplitude / ″"},
    {"Amplitudes at {0#} frequencies.", "Amplituden bei {0} Frequenzen."},
    {"Amplitudes by frequency", "Amplituden nach der Frequenz"},
    {"Angle of the line, θ", "Winkel der Geraden, θ"},
    {"Angles", "Winkel"},
    {"Angular errors", "Winkelabweichungen"},
    {"Angular errors {0=}", "Winkelabweichungen {0}"},
    {"At / s", "Bei / s"},
    {"At / °", "Bei / °"},
    {"At another point", "An einem anderen Punkt"},
    {"C0Y turns Y about Z, B0Z turns Z about Y, A0Z turns Z about X, positive by the right-hand rule.",
     "C0Y dreht Y um Z, B0Z dreht Z um Y, A0Z dreht Z um X, positiv nach der Rechte-Hand-Regel."},
    {"Change of the errors at an offset of {0#} mm from the measured line",
     "Änderung der Abweichungen bei einem Versatz von {0} mm von der gemessenen Geraden"},
    {"Course", "Verlauf"},
    {"Duration", "Dauer"},
    {"Error", "Abweichung"},
    {"Error of the optical square", "Abweichung des optischen Winkels"},
    {"Even motion, without standstills", "Gleichmäßige Bewegung, ohne Stillstände"},
    {"Feed / mm/min", "Vorschub / mm/min"},
    {"Feed / °/min", "Vorschub / °/min"},
    {"Feed asked for", "Verlangter Vorschub"},
    {"First line", "Erste Gerade"},
    {"Formulas not checked against the text of ISO 230-1", "Formeln nicht am Text von ISO 230-1 geprüft"},
    {"Frequency", "Frequenz"},
    {"Frequency / Hz", "Frequenz / Hz"},
    {"From / s", "Von / s"},
    {"From / °", "Von / °"},
    {"Highest acceleration", "Höchste Beschleunigung"},
    {"Highest velocity", "Höchste Geschwindigkeit"},
    {"In axes of the machine: squareness is by how much the angle between the positive directions of both axes is "
     "larger than 90°.",
     "In Achsen der Maschine: Die Rechtwinkligkeit ist, um wie viel der Winkel zwischen den positiven Richtungen "
     "beider Achsen größer ist als 90°."},
    {"Largest change, µm", "Größte Änderung, µm"},
    {"Largest reversal, ↑ less ↓", "Größte Umkehrspanne, ↑ minus ↓"},
    {"Line at position 0", "Gerade an Position 0"},
    {"Location error {0=}", "Lageabweichung {0}"},
    {"Lowest acceleration", "Niedrigste Beschleunigung"},
    {"Lowest velocity", "Niedrigste Geschwindigkeit"},
    {"Mean reversal", "Mittlere Umkehrspanne"},
    {"Means at {0#} positions.", "Mittelwerte an {0} Positionen."},
    {"Means over the runs at each position; the mean of both directions where there are two.",
     "Mittelwerte der Durchläufe an jeder Position; das Mittel beider Richtungen, wo es zwei gibt."},
    {"Motion of an axis, evaluated without standstills", "Bewegung einer Achse, ausgewertet ohne Stillstände"},
    {"Motion, no test of ISO 230-2", "Bewegung, keine Prüfung nach ISO 230-2"},
    {"No line is removed from angles: their slope is a bend or a twist of the way.",
     "Von Winkeln wird keine Gerade abgezogen: Ihre Steigung ist eine Biegung oder Verdrehung der Führung."},
    {"No stretch of even motion was found.", "Keine Strecke gleichmäßiger Bewegung wurde gefunden."},
    {"No test of ISO 230-2", "Keine Prüfung nach ISO 230-2"},
    {"No uncertainty of the change is stated.", "Eine Unsicherheit der Änderung ist nicht angegeben."},
    {"No vibration stands out of the noise and of what a drift leaves.",
     "Keine Schwingung hebt sich vom Rauschen und von dem ab, was eine Drift hinterlässt."},
    {"Noise", "Rauschen"},
    {"Not known without", "Nicht bekannt ohne"},
    {"Not shown: {0#} lower peak.", "Nicht gezeigt: {0} niedrigere Spitze."},
    {"Not shown: {0#} lower peaks.", "Nicht gezeigt: {0} niedrigere Spitzen."},
    {"Nothing tells an uncertainty.", "Über die Unsicherheit ist nichts bekannt."},
    {"Of each movement the longest part whose velocity stays within {0#} % of its median, from where it first reaches "
     "that to where it last has it; it strays from the straight line of position over time by least squares.",
     "Von jeder Bewegung der längste Teil, dessen Geschwindigkeit höchstens {0}\u00a0% von ihrem Median abweicht, vom "
     "ersten bis zum letzten Erreichen des Medians; die Abweichung ist die von der Ausgleichsgeraden der Position über "
     "der Zeit."},
    {"Of parabolas through {0#} samples ({1#} s): what is faster than that is averaged. Noise: the standard deviation "
     "that the noise of the positions, {2#}, makes of each value.",
     "Aus Parabeln durch {0} Abtastwerte ({1}\u00a0s): Was schneller ist, ist gemittelt. Rauschen: die "
     "Standardabweichung, die das Rauschen der Positionen, {2}, an jedem Wert bewirkt."},
    {"Of the longest stretch of even motion less its line, from {0#} to {1#} s, with Hann's window; frequencies nearer "
     "than {2#} Hz cannot be told apart.",
     "Von der längsten Strecke gleichmäßiger Bewegung ohne ihre Gerade, von {0} bis {1}\u00a0s, mit dem Fenster von "
     "Hann; Frequenzen mit weniger als {2}\u00a0Hz Abstand sind nicht zu trennen."},
    {"Of the moving part, in axes of the machine; where it carries the workpiece, the tool sees the opposite sign.",
     "Des bewegten Teils, in Achsen der Maschine; trägt es das Werkstück, so sieht das Werkzeug das umgekehrte "
     "Vorzeichen."},
    {"Of the whole recording less a straight line, from {0#} to {1#} s, with Hann's window; frequencies nearer than "
     "{2#} Hz cannot be told apart.",
     "Von der ganzen Aufzeichnung ohne eine Gerade, von {0} bis {1}\u00a0s, mit dem Fenster von Hann; Frequenzen mit "
     "weniger als {2}\u00a0Hz Abstand sind nicht zu trennen."},
    {"Period along the axis / mm", "Periode entlang der Achse / mm"},
    {"Period along the axis / °", "Periode entlang der Achse / °"},
    {"Position at {0#} samples.", "Position an {0} Abtastwerten."},
    {"Position over time; stretches of even motion are shaded",
     "Position über der Zeit; Strecken gleichmäßiger Bewegung sind hinterlegt"},
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
    {"Recording", "Aufzeichnung"},
    {"Reference line", "Bezugsgerade"},
    {"Repeatability, largest", "Wiederholpräzision, größte"},
    {"Samples", "Abtastwerte"},
    {"Samples per second", "Abtastwerte je Sekunde"},
    {"Second line", "Zweite Gerade"},
    {"Shown is what stands above {0#}, as white noise alone would do in one recording of a hundred, and above what a "
     "drift and higher peaks may leave beside themselves.",
     "Gezeigt ist, was über {0} steht, wie weißes Rauschen allein in einer von hundert Aufzeichnungen, und über dem, "
     "was eine Drift und höhere Spitzen neben sich hinterlassen können."},
    {"Slope of the first line, θ₁", "Steigung der ersten Geraden, θ₁"},
    {"Slope of the line", "Steigung der Geraden"},
    {"Slope of the second line, θ₂", "Steigung der zweiten Geraden, θ₂"},
    {"Squareness of two axes", "Rechtwinkligkeit zweier Achsen"},
    {"Squareness of two axes {0=}", "Rechtwinkligkeit zweier Achsen {0}"},
    {"Squareness over one metre", "Rechtwinkligkeit über einen Meter"},
    {"Squareness, θ₂ − θ₁ + error of the square", "Rechtwinkligkeit, θ₂ − θ₁ + Abweichung des Winkels"},
    {"Squareness, −θ₂ − θ₁ + error of the square", "Rechtwinkligkeit, −θ₂ − θ₁ + Abweichung des Winkels"},
    {"Standstills at targets are not looked for, and nobody knows when the control wanted a moving axis where. What is "
     "told is how far it strays from an even motion: errors of position, control and feed alike, as the instrument saw "
     "them. An error of scale, a lag and a reversal error cannot be told, nor A, E, R, B and M.",
     "Stillstände an Zielpositionen werden nicht gesucht, und niemand weiß, wann die Steuerung eine bewegte Achse wo "
     "wollte. Angegeben ist, wie weit sie von einer gleichmäßigen Bewegung abweicht: Abweichungen von Position, "
     "Regelung und Vorschub gleichermaßen, wie das Messgerät sie sah. Eine Maßstabsabweichung, ein Nachlauf und eine "
     "Umkehrspanne sind nicht zu erkennen, und auch A, E, R, B und M nicht."},
    {"Straightness", "Geradheit"},
    {"Straightness {0=}", "Geradheit {0}"},
    {"Straightness, range of the residuals", "Geradheit, Spannweite der Residuen"},
    {"Strays", "Abweichung"},
    {"Strays, range / µm", "Abweichung, Spannweite / µm"},
    {"Strays, range / ″", "Abweichung, Spannweite / ″"},
    {"The position of the highest and the lowest residual is taken as known.",
     "Wo das höchste und das tiefste Residuum liegen, gilt als bekannt."},
    {"To / s", "Bis / s"},
    {"To / °", "Bis / °"},
    {"To be known with these figures", "Zu diesen Werten gehört"},
    {"U for about 95 %, from both lines, whose tables say what theirs holds, and the optical square.",
     "U für etwa 95\u00a0%, aus beiden Geraden, deren Tabellen sagen, was ihre enthält, und dem optischen Winkel."},
    {"U for about 95 %, from both lines, whose tables say what theirs holds.",
     "U für etwa 95\u00a0%, aus beiden Geraden; deren Tabellen sagen, was ihre enthält."},
    {"U for about 95 %, from runs and instrument; of a range without the bias noise gives it.",
     "U für etwa 95\u00a0%, aus Durchläufen und Messgerät; einer Spannweite ohne ihren Versatz durch "
     "Rauschen."},
    {"U for about 95 %, from runs and instrument; of ranges and the largest reversal without the bias that noise "
     "gives them.",
     "U für etwa 95\u00a0%, aus Durchläufen und Messgerät; von Spannweiten und größter Umkehrspanne ohne den "
     "Versatz, den ihnen Rauschen gibt."},
    {"U for about 95 %, from the instrument alone.", "U für etwa 95\u00a0%, allein aus dem Messgerät."},
    {"U for about 95 %, from the runs alone; of a range without the bias that noise gives it.",
     "U für etwa 95\u00a0%, aus den Durchläufen allein; einer Spannweite ohne ihren Versatz durch "
     "Rauschen."},
    {"U for about 95 %, from the runs alone; of ranges and the largest reversal without the bias that noise gives "
     "them.",
     "U für etwa 95\u00a0%, aus den Durchläufen allein; von Spannweiten und größter Umkehrspanne ohne den Versatz, "
     "den ihnen Rauschen gibt."},
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
    {"Velocity", "Geschwindigkeit"},
    {"Velocity and acceleration", "Geschwindigkeit und Beschleunigung"},
    {"Velocity at {0#} samples.", "Geschwindigkeit an {0} Abtastwerten."},
    {"Velocity over time", "Geschwindigkeit über der Zeit"},
    {"Vibrations", "Schwingungen"},
    {"What strays from even motion over the position", "Abweichung von der gleichmäßigen Bewegung über der Position"},
    {"end points", "Endpunkte"},
    {"its range / %", "ihre Spannweite / %"},
    {"least squares", "kleinste Quadrate"},
    {"less that asked for / %", "gegenüber dem verlangten / %"},
    {"mean in {0#}", "Mittel in {0}"},
    {"mean less its line", "Mittel ohne seine Gerade"},
    {"no column direction, and the positions fall from row to row: all readings are taken as positive approaches "
     "all the same",
     "keine Spalte für die Richtung, und die Positionen fallen von Zeile zu Zeile: Alle Messwerte gelten trotzdem "
     "als positive Anfahrten"},
    {"no column direction: all readings are taken as positive approaches",
     "keine Spalte für die Richtung: Alle Messwerte gelten als positive Anfahrten"},
    {"no error of the optical square is stated: it counts as 0, and the squareness holds it",
     "keine Abweichung des optischen Winkels ist angegeben: Sie gilt als 0 und steckt in der Rechtwinkligkeit"},
    {"no reading was taken at {0#} mm: the figures are those of the other positions",
     "bei {0} mm steht kein Messwert: Die Werte sind die der übrigen Positionen"},
    {"no stretch of even motion was found: the vibrations are those of the whole recording about a straight line, into "
     "which every acceleration enters",
     "keine Strecke gleichmäßiger Bewegung wurde gefunden: Die Schwingungen sind die der ganzen Aufzeichnung um eine "
     "Gerade, in die jede Beschleunigung eingeht"},
    {"no uncertainty of the instrument is stated: U does not hold it",
     "keine Unsicherheit des Messgeräts ist angegeben: U enthält sie nicht"},
    {"no uncertainty of the optical square is stated: U does not hold it",
     "keine Unsicherheit des optischen Winkels ist angegeben: U enthält sie nicht"},
    {"nothing states which way the readings of both lines are positive (--positive, or # positive: +Y in each file): "
     "θ₂ − θ₁ is their squareness where the optical square turned that way with the beam; where both are positive "
     "along the axes of the machine it is −θ₂ − θ₁",
     "nichts sagt, in welcher Richtung die Messwerte beider Geraden positiv sind (--positive, oder # positive: +Y in "
     "jeder Datei): θ₂ − θ₁ ist ihre Rechtwinkligkeit, wo der optische Winkel diese Richtung mit dem Strahl gedreht "
     "hat; sind beide längs der Achsen der Maschine positiv, so ist es −θ₂ − θ₁"},
    {"one run: what does not repeat cannot be told from the shape, and there is no repeatability",
     "ein Durchlauf: Was sich nicht wiederholt, ist von der Form nicht zu unterscheiden, und es gibt keine "
     "Wiederholpräzision"},
    {"rms / ″", "Effektivwert / ″"},
    {"s of velocity / %", "s der Geschwindigkeit / %"},
    {"standstills at targets are not looked for: nothing here is a parameter of ISO 230-2, and neither an error of "
     "scale nor a reversal error can be told",
     "Stillstände an Zielpositionen werden nicht gesucht: Nichts hier ist eine Kenngröße nach ISO 230-2, und weder "
     "eine Maßstabsabweichung noch eine Umkehrspanne ist zu erkennen"},
    {"the feed that was asked for is not stated (--feed): how far the axis is from it is not known",
     "der verlangte Vorschub ist nicht angegeben (--feed): Wie weit die Achse davon entfernt ist, ist nicht bekannt"},
    {"the files do not both name their error: whether they are of one plane was not checked",
     "nicht beide Dateien nennen ihre Abweichung: Ob sie in einer Ebene liegen, wurde nicht geprüft"},
    {"the plan names no error: it was made for positions",
     "der Plan nennt keine Abweichung: Er ist für Positionen gemacht"},
    {"the readings are positive towards {0=}: their signs are turned",
     "die Messwerte sind positiv in Richtung {0}: ihre Vorzeichen sind umgekehrt"},
    {"the runs agree to the last digit: they tell nothing of how far they are from the truth",
     "die Durchläufe stimmen bis zur letzten Ziffer überein: Sie sagen nichts darüber, wie weit sie von der Wahrheit "
     "entfernt sind"},
    {"the uncertainty of the instrument is stated as 0, which no instrument has: it counts as not stated, and U does "
     "not hold it",
     "die Unsicherheit des Messgeräts ist mit 0 angegeben, was kein Messgerät hat: Sie gilt als nicht angegeben, und U "
     "enthält sie nicht"},
    {"the uncertainty of the optical square is stated as 0, which no square has: U does not hold it",
     "die Unsicherheit des optischen Winkels ist mit 0 angegeben, was kein Winkel hat: U enthält sie nicht"},
    {"{0#} less its line", "{0} ohne seine Gerade"},
};

}  // namespace

const std::span<const Phrase> german_error_motions{error_motions_rows};

}  // namespace axiometry::language
