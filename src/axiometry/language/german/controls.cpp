// SPDX-License-Identifier: Apache-2.0
// Controls that correct an axis by a table: what they are, their signs, how a table is loaded, what of it is verified.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase controls_rows[] = {
    {"24 bits of an entry.", "24 Bit eines Eintrags."},
    {"A number is added to the command (forward, then reverse): a positive one moves the axis in the positive "
     "direction.",
     "Eine Zahl wird zum Sollwert addiert (vorwärts, dann rückwärts): Eine positive bewegt die Achse in positiver "
     "Richtung."},
    {"A number is the position that must be commanded for the axis to be at the point: one above the point moves the "
     "axis in the positive direction.",
     "Eine Zahl ist die Position, die befohlen werden muss, damit die Achse am Stützpunkt steht: Eine über dem "
     "Stützpunkt bewegt die Achse in positiver Richtung."},
    {"A number is where the axis really was (forward, then reverse) when the nominal position was commanded, without "
     "the table: one above the nominal moves the axis in the negative direction.",
     "Eine Zahl ist die Stelle, an der die Achse ohne Tabelle wirklich stand (vorwärts, dann rückwärts), als die "
     "Sollposition befohlen war: Eine über der Sollposition bewegt die Achse in negativer Richtung."},
    {"A positive factor moves the first axis in the negative direction where the second stands above 0, by the factor "
     "times that position.",
     "Ein positiver Faktor bewegt die erste Achse in negativer Richtung, wo die zweite über 0 steht, um den Faktor mal "
     "diese Position."},
    {"A positive number moves the axis in the negative direction: it is actual less set position.",
     "Eine positive Zahl bewegt die Achse in negativer Richtung: Sie ist Istposition minus Sollposition."},
    {"A positive number moves the axis in the negative direction: it is taken off (turned against what was inferred).",
     "Eine positive Zahl bewegt die Achse in negativer Richtung: Sie wird abgezogen (gegen das Erschlossene gedreht)."},
    {"A positive number moves the axis in the negative direction: it is taken off (turned against what was inferred); "
     "with NEGCOR in the positive.",
     "Eine positive Zahl bewegt die Achse in negativer Richtung: Sie wird abgezogen (gegen das Erschlossene gedreht); "
     "mit NEGCOR in positiver."},
    {"A positive number moves the axis in the negative direction: it is the actual less the expected position (turned "
     "against what was inferred).",
     "Eine positive Zahl bewegt die Achse in negativer Richtung: Sie ist tatsächliche minus erwartete Position "
     "(gegen das Erschlossene gedreht)."},
    {"A positive number moves the axis in the negative direction: it is the error, what is too far (inferred).",
     "Eine positive Zahl bewegt die Achse in negativer Richtung: Sie ist der Fehler, um den die Achse zu weit steht "
     "(erschlossen)."},
    {"A positive number moves the axis in the negative direction: it is the error, what is too far.",
     "Eine positive Zahl bewegt die Achse in negativer Richtung: Sie ist der Fehler, um den die Achse zu weit steht."},
    {"A positive number moves the axis in the negative direction: it is what is too far (inferred of these tables).",
     "Eine positive Zahl bewegt die Achse in negativer Richtung: Sie ist, um was die Achse zu weit steht (bei diesen "
     "Tabellen erschlossen)."},
    {"A positive number moves the axis in the negative direction: it is what is too far (inferred).",
     "Eine positive Zahl bewegt die Achse in negativer Richtung: Sie ist, um was die Achse zu weit steht "
     "(erschlossen)."},
    {"A positive number moves the axis in the negative direction: it is what is too far.",
     "Eine positive Zahl bewegt die Achse in negativer Richtung: Sie ist, um was die Achse zu weit steht."},
    {"A positive number moves the axis in the positive direction, on its way from the point before to its own, by "
     "half of so many output units.",
     "Eine positive Zahl bewegt die Achse in positiver Richtung, auf dem Weg vom vorigen Stützpunkt zu dem ihren, um "
     "halb so viele Ausgabeeinheiten."},
    {"A positive number moves the axis in the positive direction, on its way from the point before to its own.",
     "Eine positive Zahl bewegt die Achse in positiver Richtung, auf dem Weg vom vorigen Stützpunkt zu dem ihren."},
    {"A positive number moves the axis in the positive direction: it is added (inferred).",
     "Eine positive Zahl bewegt die Achse in positiver Richtung: Sie wird addiert (erschlossen)."},
    {"A positive number moves the axis in the positive direction: it is added (inferred); with NEGCOR in the negative.",
     "Eine positive Zahl bewegt die Achse in positiver Richtung: Sie wird addiert (erschlossen); mit NEGCOR in "
     "negativer."},
    {"A positive number moves the axis in the positive direction: it is added.",
     "Eine positive Zahl bewegt die Achse in positiver Richtung: Sie wird addiert."},
    {"A positive number moves the axis in the positive direction: it is the expected less the actual position "
     "(inferred).",
     "Eine positive Zahl bewegt die Achse in positiver Richtung: Sie ist erwartete minus tatsächliche Position "
     "(erschlossen)."},
    {"A positive number moves the axis in the positive direction: it is what is too short (turned against what was "
     "inferred).",
     "Eine positive Zahl bewegt die Achse in positiver Richtung: Sie ist, was zu kurz ist (gegen das Erschlossene "
     "gedreht)."},
    {"A positive number of COMP moves the axis in the positive direction; one of BLCOMP in the negative, and only "
     "while it moves in the negative direction.",
     "Eine positive Zahl von COMP bewegt die Achse in positiver Richtung; eine von BLCOMP in negativer, und nur "
     "während sie sich in negativer Richtung bewegt."},
    {"ACS SPiiPlus, MAP in the command of the motor", "ACS SPiiPlus, MAP im Sollwert des Motors"},
    {"Aerotech Automation1, axis calibration", "Aerotech Automation1, Achskalibrierung"},
    {"As for one curve. That points of the negative direction count from 3626 in the same order and sign, and that "
     "3627 is what is added at the reference point in the negative direction, in detection units without the "
     "magnification.",
     "Wie bei einer Kurve. Dass die Stützpunkte der negativen Richtung ab 3626 in derselben Reihenfolge und mit "
     "demselben Vorzeichen zählen, und dass 3627 ist, was am Referenzpunkt in negativer Richtung addiert wird, in "
     "Erfassungseinheiten ohne den Vergrößerungsfaktor."},
    {"Beckhoff TwinCAT CNC and ISG kernels, axis compensation (achskw)",
     "Beckhoff TwinCAT CNC und ISG-Kerne, Achskompensation (achskw)"},
    {"Beckhoff TwinCAT PTP, table of position compensation", "Beckhoff TwinCAT PTP, Tabelle der Positionskompensation"},
    {"Copy the values into a .COM table of the control, name it in the axis' column of config.cma (.CMA), mark that "
     "line active, and switch the nonlinear compensation of the axis on (MP730 of older controls). Positions are from "
     "the machine datum. Older controls want spacings of a power of two times 0.0001 mm and steps between neighbours "
     "of at most a 64th of the spacing.",
     "Die Werte in eine Tabelle .COM der Steuerung übertragen, diese in der Spalte der Achse von config.cma (.CMA) "
     "nennen, diese Zeile als aktiv kennzeichnen und die nichtlineare Achsfehlerkompensation der Achse einschalten "
     "(MP730 älterer Steuerungen). Die Positionen zählen vom Maschinen-Nullpunkt. Ältere Steuerungen verlangen "
     "Abstände von einer Zweierpotenz mal 0,0001\u00a0mm und Sprünge zwischen Nachbarn von höchstens einem "
     "Vierundsechzigstel des Abstands."},
    {"Delete the buffers that are in the way (TBUF, ROTARY, GATHER, tables of lower motors), send the lines, motors "
     "with the highest number first, SAVE. I51=1 switches all tables on; they are active once the motor is homed. "
     "--number is the motor, --resolution one count. With BLCOMP, Ix86 holds the reversal at home and is among the "
     "lines; with Ix85 at 0 none of it acts. A cross table moves the motor of --output-axis by the position of "
     "--number, both of one --resolution; it belongs to the motor that it moves, and where that has a table already "
     "to one without.",
     "Die Puffer löschen, die im Weg sind (TBUF, ROTARY, GATHER, Tabellen niedrigerer Motoren), die Zeilen senden, "
     "die Motoren mit der höchsten Nummer zuerst, SAVE. I51=1 schaltet alle Tabellen ein; sie wirken, sobald der "
     "Motor referenziert ist. --number ist der Motor, --resolution ein Inkrement. Mit BLCOMP enthält Ix86 die "
     "Umkehrspanne am Referenzpunkt und steht unter den Zeilen; ist Ix85 0, wirkt nichts davon. Eine Kreuztabelle "
     "bewegt den Motor von --output-axis nach der Position von --number, beide mit derselben --resolution; sie gehört "
     "dem Motor, den sie bewegt, und wo der schon eine Tabelle hat, einem ohne."},
    {"Delta Tau PMAC, COMP and BLCOMP", "Delta Tau PMAC, COMP und BLCOMP"},
    {"Enter start, length, number of points and the numbers in the dialog of screw mapping, for each direction (since "
     "build 4780; before it there is one map: ask for --curves both-ways), in the motor's units, and enable the map.",
     "Anfang, Länge, Zahl der Stützpunkte und die Zahlen im Dialog der Spindelkorrektur eingeben, für jede Richtung "
     "(seit Build 4780; davor gibt es eine Kurve: --curves both-ways verlangen), in den Einheiten des Motors, und die "
     "Korrektur einschalten."},
    {"Enter the numbers in the parameters for axis compensation, incremental system, and switch the control off and "
     "on. --resolution is the output unit; --number is #4003, so that no other axis is overwritten.",
     "Die Zahlen in die Parameter der Achskompensation, inkrementelles System, eingeben und die Steuerung aus- und "
     "einschalten. --resolution ist die Ausgabeeinheit; --number ist #4003, damit keine andere Achse überschrieben "
     "wird."},
    {"Enter the numbers on the page of the axis' leadscrew compensation, which the maker's settings unlock, and home "
     "the axis. --resolution is one encoder step, of which an entry holds at most 127.",
     "Die Zahlen auf der Seite der Spindelsteigungsfehler-Kompensation der Achse eingeben, die die Einstellungen des "
     "Herstellers freischalten, und die Achse referenzieren. --resolution ist ein Geberinkrement, von denen ein "
     "Eintrag höchstens 127 fasst."},
    {"Fagor 8055, leadscrew compensation", "Fagor 8055, Spindelsteigungsfehler-Kompensation"},
    {"Fanuc, stored pitch errors of each direction", "Fanuc, gespeicherte Steigungsfehler je Richtung"},
    {"Fanuc, stored pitch errors, both directions alike",
     "Fanuc, gespeicherte Steigungsfehler, beide Richtungen gleich"},
    {"HEIDENHAIN, table of axis errors (COM)", "HEIDENHAIN, Korrekturwert-Tabelle der Achsfehler (COM)"},
    {"Haas (1999), leadscrew compensation", "Haas (1999), Spindelsteigungsfehler-Kompensation"},
    {"Half an inch between entries, 0.0001 inch, the first entry at machine zero and the others in the negative "
     "direction, 127 encoder steps, 256 entries inside: the manual of 1999.",
     "Ein halber Zoll zwischen den Einträgen, 0,0001 Zoll, der erste Eintrag am Maschinennullpunkt und die anderen in "
     "negativer Richtung, 127 Geberinkremente, 256 Einträge intern: das Handbuch von 1999."},
    {"KFLOP with KMotionCNC, screw mapping", "KFLOP mit KMotionCNC, Spindelkorrektur (Screw Mapping)"},
    {"Layout, names, and that two tables with opposite directions give a position-dependent backlash: manuals of "
     "802D, 828D and 840D.",
     "Aufbau, Namen, und dass zwei Tabellen mit entgegengesetzten Richtungen eine positionsabhängige Losekompensation "
     "ergeben: Handbücher der 802D, 828D und 840D."},
    {"Layout, names, sign, that the ends hold and that one curve serves both directions: function manuals of 840D, "
     "828D and 808D. That MD32450 is positive where the encoder leads the machine, which is lost motion, and may be "
     "negative: parameter manual of 808D.",
     "Aufbau, Namen, Vorzeichen, dass jenseits der Enden der letzte Wert gehalten wird und eine Kurve für beide "
     "Richtungen gilt: Funktionshandbücher der 840D, 828D und 808D. Dass MD32450 positiv ist, wo der Geber der "
     "Maschine vorauseilt, also bei Umkehrspiel, und negativ sein darf: Parameterhandbuch der 808D."},
    {"Layout, sign, limits and rule: the sources of LinuxCNC (usrmotintf.cc, command.c, control.c), and its motion "
     "controller run in a test.",
     "Aufbau, Vorzeichen, Grenzen und Regel: die Quellen von LinuxCNC (usrmotintf.cc, command.c, control.c) und seine "
     "Bewegungssteuerung, in einer Prüfung gefahren."},
    {"Layout, sign, limits and rule: the sources of LinuxCNC (usrmotintf.cc, command.c, control.c), and its motion "
     "controller run in a test. The sign that its documentation tells for this type is not what the program does.",
     "Aufbau, Vorzeichen, Grenzen und Regel: die Quellen von LinuxCNC (usrmotintf.cc, command.c, control.c) und seine "
     "Bewegungssteuerung, in einer Prüfung gefahren. Das Vorzeichen, das seine Dokumentation für diesen Typ nennt, "
     "ist nicht das des Programms."},
    {"LinuxCNC, COMP_FILE_TYPE 0", "LinuxCNC, COMP_FILE_TYPE 0"},
    {"LinuxCNC, COMP_FILE_TYPE 1", "LinuxCNC, COMP_FILE_TYPE 1"},
    {"Load it into a buffer and run that once the axis is homed, as part of the start. --number is the axis of the "
     "controller; the table is in its user units, mm (or inch) and degrees.",
     "In einen Puffer laden und diesen nach dem Referenzieren der Achse als Teil des Anlaufs ausführen. --number ist "
     "die Achse der Steuerung; die Tabelle hat deren Anwendereinheiten, mm (oder Zoll) und Grad."},
    {"M425 with a backlash in mm for each axis and F as the share of it: the change that brought the command.",
     "M425 mit einem Umkehrspiel in mm für jede Achse und F als dessen Anteil: die Änderung, die den Befehl "
     "einführte."},
    {"MD18342[t] must be at least the number of points (828D: 8 tables of at most 200). Switch the tables off "
     "(MD32710 of the axis, SD41300[t]), load the file as a part program of initialisation, switch both on, reference "
     "the axis. MD32720 limits what the tables add. The axis is named as the machine axis, AX1.",
     "MD18342[t] muss mindestens die Zahl der Stützpunkte sein (828D: 8 Tabellen mit höchstens 200). Die Tabellen "
     "ausschalten (MD32710 der Achse, SD41300[t]), die Datei als Initialisierungsprogramm einlesen, beides "
     "einschalten, die Achse referenzieren. MD32720 begrenzt, was die Tabellen addieren. Die Achse heißt wie die "
     "Maschinenachse, AX1."},
    {"MD38000 must be at least the number of points (808D: at most 200), and changing it clears the memory. Set "
     "MD32700 of the axis to 0, load the file as a part program of initialisation, set MD32700 to 1, reference the "
     "axis. The unit is that of MD10240. With --curves with-backlash the head of the file says what is to be added to "
     "MD32450 (BACKLASH). All points of an old table are replaced only where the new one has as many.",
     "MD38000 muss mindestens die Zahl der Stützpunkte sein (808D: höchstens 200), und seine Änderung löscht den "
     "Speicher. MD32700 der Achse auf 0 setzen, die Datei als Initialisierungsprogramm einlesen, MD32700 auf 1 "
     "setzen, die Achse referenzieren. Die Einheit ist die von MD10240. Mit --curves with-backlash sagt der Kopf der "
     "Datei, was zu MD32450 (BACKLASH) kommt. Alle Stützpunkte einer alten Tabelle werden "
     "nur ersetzt, wenn die neue ebenso viele hat."},
    {"Mach4, screw mapping", "Mach4, Spindelkorrektur (Screw Mapping)"},
    {"Marlin, M92 and M425", "Marlin, M92 und M425"},
    {"Marlin, squareness (M852)", "Marlin, Rechtwinkligkeit (M852)"},
    {"Mitsubishi MELDAS C64, E68, incremental pitch errors",
     "Mitsubishi MELDAS C64, E68, inkrementelle Steigungsfehler"},
    {"More steps per unit move the axis further. A positive backlash is driven more at each reversal: after one into "
     "the negative direction the axis stands further in the negative direction.",
     "Mehr Schritte je Einheit bewegen die Achse weiter. Ein positives Umkehrspiel wird bei jeder Umkehr zusätzlich "
     "gefahren: Nach einer Umkehr in die negative Richtung steht die Achse weiter in negativer Richtung."},
    {"Name it COMP_FILE in the joint's section of the INI file, with COMP_FILE_TYPE, and start LinuxCNC anew. The "
     "joint's BACKLASH does nothing then. A reversal is driven with half of the joint's limits of velocity and "
     "acceleration: leave it room in STEPGEN_MAXVEL and STEPGEN_MAXACCEL or the like. After homing nothing is added "
     "until the joint has passed a position of the table (seen on 2.9): drive it once over the whole of it.",
     "Die Datei im Abschnitt des Gelenks der INI-Datei als COMP_FILE nennen, mit COMP_FILE_TYPE, und LinuxCNC neu "
     "starten. BACKLASH des Gelenks tut dann nichts. Eine Umkehr wird mit der Hälfte der Grenzen des Gelenks für "
     "Geschwindigkeit und Beschleunigung gefahren: dafür Raum in STEPGEN_MAXVEL und STEPGEN_MAXACCEL oder dergleichen "
     "lassen. Nach dem Referenzieren wird nichts addiert, bis das Gelenk eine Position der Tabelle überfahren hat (an "
     "2.9 gesehen): einmal über die ganze Tabelle fahren."},
    {"Name it among the calibration files of the controller, switch the calibration of the axis on, reset the "
     "controller, and home the axis: calibration is active once it is homed.",
     "Unter den Kalibrierdateien der Steuerung eintragen, die Kalibrierung der Achse einschalten, die Steuerung "
     "zurücksetzen und die Achse referenzieren: Die Kalibrierung wirkt, sobald sie referenziert ist."},
    {"Name the file in the settings of KMotionCNC's motion planner for this axis, in the units of the table, and "
     "initialise anew. One curve serves both directions.",
     "Die Datei in den Einstellungen der Bahnplanung von KMotionCNC für diese Achse nennen, in den Einheiten der "
     "Tabelle, und neu initialisieren. Eine Kurve gilt für beide Richtungen."},
    {"Name the list as the axis compensation of this axis among the start-up lists, switch the spindle error "
     "compensation (ssfk) of the axis on, start the control anew, and home the axis. The name of the axis is "
     "kopf.log_achs_name, --number its kopf.achs_nr.",
     "Die Liste unter den Hochlauflisten als Achskompensation dieser Achse eintragen, die "
     "Spindelsteigungsfehlerkompensation (ssfk) der Achse einschalten, die Steuerung neu starten und die Achse "
     "referenzieren. Der Name der Achse ist kopf.log_achs_name, --number ihre kopf.achs_nr."},
    {"Names, units of 0.1 um and 0.0001 degrees, at most 1500 positions, both directions, that the ends hold, and the "
     "sign by a worked example: the manual of the kernel.",
     "Namen, Einheiten von 0,1\u00a0µm und 0,0001 Grad, höchstens 1500 Positionen, beide Richtungen, dass jenseits "
     "der Enden der letzte Wert gehalten wird, und das Vorzeichen an einem gerechneten Beispiel: das Handbuch des "
     "Kerns."},
    {"NcStudio (Weihong), axeserr.dat", "NcStudio (Weihong), axeserr.dat"},
    {"Numbers 3605, 3620 to 3627 of the parameters, that the data are increments in detection units times the "
     "magnification, that one is a signed byte, that a switch off and on is needed: reports and manuals of the 0i and "
     "15i, the header of FOCAS.",
     "Die Nummern 3605, 3620 bis 3627 der Parameter, dass die Daten Inkremente in Erfassungseinheiten mal dem "
     "Vergrößerungsfaktor sind, dass eines ein Byte mit Vorzeichen ist, dass aus- und eingeschaltet werden muss: "
     "Berichte und Handbücher der 0i und 15i, die Header-Datei von FOCAS."},
    {"P15, P16, at most 1000 points, one error for each direction, that zeros in the negative direction mean the same "
     "as in the positive one, that 0 and 360 degrees are equal: the manual.",
     "P15, P16, höchstens 1000 Stützpunkte, ein Fehler je Richtung, dass Nullen in der negativen Richtung dasselbe "
     "wie in der positiven bedeuten, dass 0 und 360 Grad gleich sind: das Handbuch."},
    {"Put the array among the variables of the PLC and hand it to the function block of position compensation, with "
     "the axis in the units of the table (mm or inch as it is scaled; degrees), then enable the block.",
     "Das Feld unter die Variablen der SPS setzen und dem Funktionsbaustein der Positionskompensation übergeben, mit "
     "der Achse in den Einheiten der Tabelle (mm oder Zoll, wie sie skaliert ist; Grad), dann den Baustein freigeben."},
    {"Put the lines in the file config in place of those that are there, and reset the control. Backlash is there "
     "only when the firmware is built with BACKLASH=1. --steps-per-unit is what the file says now.",
     "Die Zeilen in der Datei config an die Stelle der vorhandenen setzen und die Steuerung zurücksetzen. Ein "
     "Umkehrspiel gibt es nur, wenn die Firmware mit BACKLASH=1 übersetzt ist. --steps-per-unit ist, was die Datei "
     "jetzt sagt."},
    {"Put the section of the axis in axeserr.dat in the control's folder, beside those of the other axes, switch the "
     "compensation of lead screw errors on, and start the control anew.",
     "Den Abschnitt der Achse in axeserr.dat im Ordner der Steuerung eintragen, neben die der anderen Achsen, die "
     "Kompensation der Spindelsteigungsfehler einschalten und die Steuerung neu starten."},
    {"Read the part between the percent signs in as pitch error data (PWE on, EDIT), set the parameters that are "
     "listed behind it by hand, switch the control off and on, and return to the reference point. The points of "
     "several axes share one row of numbers: --number is that of the reference point, so that no other axis is "
     "overwritten. --resolution is the detection unit.",
     "Den Teil zwischen den Prozentzeichen als Steigungsfehlerdaten einlesen (PWE ein, EDIT), die dahinter "
     "aufgeführten Parameter von Hand setzen, die Steuerung aus- und einschalten und den Referenzpunkt anfahren. Die "
     "Stützpunkte mehrerer Achsen teilen sich eine Folge von Nummern: --number ist die des Referenzpunkts, damit "
     "keine andere Achse überschrieben wird. --resolution ist die Erfassungseinheit."},
    {"SINUMERIK 840D, 828D, 802D, a table for each direction (CEC)",
     "SINUMERIK 840D, 828D, 802D, Durchhangkompensation mit einer Tabelle je Richtung (CEC)"},
    {"SINUMERIK 840D, 828D, 808D, leadscrew errors (EEC)",
     "SINUMERIK 840D, 828D, 808D, Spindelsteigungsfehler (SSFK, EEC)"},
    {"Send the lines in mm (G21); M500 keeps them. M425 is there only when the firmware is built with "
     "BACKLASH_COMPENSATION and BACKLASH_GCODE. --steps-per-unit is what M92 says now.",
     "Die Zeilen in mm (G21) senden; M500 behält sie. M425 gibt es nur, wenn die Firmware mit BACKLASH_COMPENSATION "
     "und BACKLASH_GCODE übersetzt ist. --steps-per-unit ist, was M92 jetzt sagt."},
    {"Send the lines in mm (G21); M500 keeps them. M852 is there only when the firmware is built with SKEW_CORRECTION "
     "and SKEW_CORRECTION_GCODE. I is X over Y, J is X over Z, K is Y over Z: J and K only with SKEW_CORRECTION_FOR_Z. "
     "The factor replaces the one that M852 says now: set that to 0 before the machine is measured.",
     "Die Zeilen in mm (G21) senden; M500 behält sie. M852 gibt es nur, wenn die Firmware mit SKEW_CORRECTION und "
     "SKEW_CORRECTION_GCODE gebaut ist. I ist X über Y, J ist X über Z, K ist Y über Z: J und K nur mit "
     "SKEW_CORRECTION_FOR_Z. Der Faktor ersetzt den, den M852 jetzt nennt: diesen auf 0 setzen, bevor die Maschine "
     "gemessen wird."},
    {"Send the lines to the control, or enter them in the sender's settings; home the axis. Backlash is there only "
     "when the firmware is built with it. --steps-per-unit is what the setting 100 and on says now. grbl itself has "
     "no backlash: take the steps alone.",
     "Die Zeilen an die Steuerung senden oder in den Einstellungen des Sendeprogramms eingeben; die Achse "
     "referenzieren. Ein Umkehrspiel gibt es nur, wenn die Firmware damit übersetzt ist. --steps-per-unit ist, was "
     "die Einstellung ab 100 jetzt sagt. grbl selbst kennt kein Umkehrspiel: nur die Schritte übernehmen."},
    {"Set P15 (LSCRWCOM) of the axis to ON and P16 (NPOINTS) to the number of points, enter the points in the table "
     "of leadscrew errors, and reset the control. Positions are from machine zero.",
     "P15 (LSCRWCOM) der Achse auf ON und P16 (NPOINTS) auf die Zahl der Stützpunkte setzen, die Stützpunkte in die "
     "Tabelle der Spindelsteigungsfehler eingeben und die Steuerung zurücksetzen. Die Positionen zählen vom "
     "Maschinennullpunkt."},
    {"Smoothieware, steps per mm and backlash", "Smoothieware, Schritte je mm und Umkehrspiel"},
    {"Start, length, number of points, points at one spacing, one map before build 4780 and two since: the maker's "
     "words.",
     "Anfang, Länge, Zahl der Stützpunkte, Stützpunkte in gleichem Abstand, eine Kurve vor Build 4780 und zwei "
     "seither: die Worte des Herstellers."},
    {"That a backlash is made up for in whole steps, which is left out of what is predicted.",
     "Dass ein Umkehrspiel in ganzen Schritten ausgeglichen wird, was in der Vorhersage weggelassen ist."},
    {"That comments behind ; are taken in the file. That MD32450 is driven in full at each reversal into the negative "
     "direction, as it is predicted.",
     "Dass Kommentare hinter ; in der Datei angenommen werden. Dass MD32450 bei jeder Umkehr in die negative Richtung "
     "ganz gefahren wird, wie es vorhergesagt ist."},
    {"That positions count from where the firmware has 0. What I times K does to J is left out: it is of second order. "
     "How it is loaded.",
     "Dass Positionen von dort zählen, wo die Firmware 0 hat. Was I mal K an J ändert, ist weggelassen: Es ist von "
     "zweiter Ordnung. Wie es geladen wird."},
    {"That tables are text in UTF-8, add to the axis, are linear between points, hold their ends, and serve both "
     "directions alike: the control's help.",
     "Dass die Tabellen Text in UTF-8 sind, zur Achse addieren, zwischen den Stützpunkten linear sind, jenseits ihrer "
     "Enden den letzten Wert halten und in beiden Richtungen gleich wirken: die Hilfe der Steuerung."},
    {"That the data are written as N10000 and the point's number, that a point's number is used from the point before "
     "to it, that older controls take -7 to 7 (--largest 127 for those that take more), and the units of the "
     "parameters.",
     "Dass die Daten als N10000 und Nummer des Stützpunkts geschrieben werden, dass die Zahl eines Stützpunkts vom "
     "vorigen bis zu ihm gilt, dass ältere Steuerungen -7 bis 7 annehmen (--largest 127 für die, die mehr annehmen), "
     "und die Einheiten der Parameter."},
    {"That the ends hold beyond the table.", "Dass jenseits der Tabelle die Werte ihrer Enden gehalten werden."},
    {"That the ends hold; four decimals. How it is loaded.",
     "Dass jenseits der Enden der letzte Wert gehalten wird; vier Nachkommastellen. Wie geladen wird."},
    {"That the error is actual less commanded, as the manual's word for it says. It is a list to enter by hand; the "
     "layout of a file was not seen. How it is loaded.",
     "Dass der Fehler Istposition minus Sollposition ist, wie das Wort des Handbuchs sagt. Eine Liste zum Eingeben "
     "von Hand; der Aufbau einer Datei wurde nicht gesehen. Wie geladen wird."},
    {"That the offset is the position of the first point, and that the ends hold. How it is loaded.",
     "Dass der Versatz die Position des ersten Stützpunkts ist, und dass jenseits der Enden der letzte Wert gehalten "
     "wird. Wie geladen wird."},
    {"That the table is an array of Position and Compensation, LREAL, and that the compensation is added: the manual "
     "of the function block.",
     "Dass die Tabelle ein Feld aus Position und Compensation ist, LREAL, und dass die Kompensation addiert wird: das "
     "Handbuch des Funktionsbausteins."},
    {"The columns AXISPOS, BACKLASH (values of the negative direction) and one of the axis' name, config.cma, that a "
     "rotary axis has 0 to 360: pages of technical manuals.",
     "Die Spalten AXISPOS, BACKLASH (Werte der negativen Richtung) und eine mit dem Namen der Achse, config.cma, dass "
     "eine Drehachse 0 bis 360 hat: Seiten technischer Handbücher."},
    {"The commands, 1/16 count, the first entry one spacing from home, the rollover, that COMP is added in both "
     "directions and BLCOMP and Ix86 taken off in the negative one, that BLCOMP is 0 at home, source and target of a "
     "table: reference and user's manuals. Not tried on a control.",
     "Die Befehle, 1/16 Inkrement, der erste Eintrag einen Abstand vom Referenzpunkt, der Überlauf am Tabellenende, "
     "dass COMP in beiden Richtungen addiert und BLCOMP und Ix86 in der negativen abgezogen werden, dass BLCOMP am "
     "Referenzpunkt 0 ist, Quelle und Ziel einer Tabelle: Referenz- und Benutzerhandbuch. An keiner Steuerung "
     "erprobt."},
    {"The commands, and that the table is added to the command of the motor: a script in use that writes them.",
     "Die Befehle, und dass die Tabelle zum Sollwert des Motors addiert wird: ein verwendetes Skript, das sie "
     "schreibt."},
    {"The formulas of both sides, twice the difference in output units, -128 to 127: manuals of C64 and E68.",
     "Die Formeln beider Seiten, das Doppelte des Unterschieds in Ausgabeeinheiten, -128 bis 127: Handbücher der C64 "
     "und E68."},
    {"The keywords, what OFFSET counts from, and the sign: a program that is in use writes the deviation itself, "
     "which would be the opposite. A re-test after loading tells it; NEGCOR in the head turns it round. How it is "
     "loaded.",
     "Die Schlüsselwörter, von wo OFFSET zählt, und das Vorzeichen: Ein verwendetes Programm schreibt die Abweichung "
     "selbst, was das Gegenteil wäre. Eine Nachprüfung nach dem Laden zeigt es; NEGCOR im Kopf kehrt es um. Wie "
     "geladen wird."},
    {"The letters of M852, factors from -1 to 1, that a factor times the second position is taken off the first, and "
     "that J is used less I times K: source of the firmware.",
     "Die Buchstaben von M852, Faktoren von -1 bis 1, dass ein Faktor mal die zweite Position von der ersten abgezogen "
     "wird, und dass J um I mal K vermindert wirkt: Quelltext der Firmware."},
    {"The lines: number of points, spacing, offset, then index and command; that it is the command that is needed, in "
     "one direction: the maker's wiki and forum.",
     "Die Zeilen: Zahl der Stützpunkte, Abstand, Versatz, dann Index und Sollwert; dass es der nötige Sollwert ist, "
     "in einer Richtung: Wiki und Forum des Herstellers."},
    {"The name of the structure's type. That positions beyond the ends hold the end's value. How it is loaded.",
     "Der Name des Strukturtyps. Dass jenseits der Enden der Wert des Endes gehalten wird. Wie geladen wird."},
    {"The numbers of the parameters, that a point's number is used from the point before to it, and that #4006 "
     "multiplies. It is a list to enter by hand; the layout of a parameter file was not seen. How it is loaded.",
     "Die Nummern der Parameter, dass die Zahl eines Stützpunkts vom vorigen bis zu ihm gilt, und dass #4006 "
     "multipliziert. Eine Liste zum Eingeben von Hand; der Aufbau einer Parameterdatei wurde nicht gesehen. Wie "
     "geladen wird."},
    {"The numbers of the settings, that there is no table, and that the backlash is an option of the build: sources.",
     "Die Nummern der Einstellungen, dass es keine Tabelle gibt und dass das Umkehrspiel beim Übersetzen wählbar ist: "
     "Quellen."},
    {"The settings of the backlash, and that it is an option of the build: the change that brings it (pull request "
     "1543, open).",
     "Die Einstellungen des Umkehrspiels, und dass es beim Übersetzen wählbar ist: die Änderung, die es einführt "
     "(Pull-Request 1543, offen)."},
    {"The sign. A re-test after entering it tells it. It is a list to enter by hand. How it is loaded.",
     "Das Vorzeichen. Eine Nachprüfung nach dem Eingeben zeigt es. Eine Liste zum Eingeben von Hand. Wie geladen "
     "wird."},
    {"The sign: taken as that of the leadscrew errors of the same control. A re-test after loading tells it. That "
     "comments behind ; are taken in the file. How the tables are switched off and on.",
     "Das Vorzeichen: angenommen wie das der Spindelsteigungsfehler derselben Steuerung. Eine Nachprüfung nach dem "
     "Laden zeigt es. Dass Kommentare hinter ; in der Datei angenommen werden. Wie die Tabellen aus- und "
     "eingeschaltet werden."},
    {"The sign: the difference between the expected and the actual is taken in that order. A re-test tells it. It is "
     "a list to enter by hand; no file of it was seen. How it is loaded.",
     "Das Vorzeichen: Der Unterschied zwischen erwarteter und tatsächlicher Position ist in dieser Reihenfolge "
     "gebildet. Eine Nachprüfung zeigt es. Eine Liste zum Eingeben von Hand; eine Datei davon wurde nicht gesehen. "
     "Wie geladen wird."},
    {"The sign; that BACKLASH holds the whole value of the negative direction and not the difference; the lines of "
     "the head and the widths of the columns. A re-test after loading tells sign and BACKLASH. How it is loaded.",
     "Das Vorzeichen; dass BACKLASH den ganzen Wert der negativen Richtung enthält und nicht den Unterschied; die "
     "Zeilen des Kopfes und die Breiten der Spalten. Eine Nachprüfung nach dem Laden zeigt Vorzeichen und BACKLASH. "
     "Wie geladen wird."},
    {"The unit, the sections, the order of the columns, positions that ascend, the sign, that the last column is of "
     "the decreasing direction: a description of the file.",
     "Die Einheit, die Abschnitte, die Reihenfolge der Spalten, aufsteigende Positionen, das Vorzeichen, dass die "
     "letzte Spalte zur fallenden Richtung gehört: eine Beschreibung der Datei."},
    {"Which unit kw.ssfk.unit 1 stands for, that modulo 1 is a whole turn, that # begins a comment. How it is loaded.",
     "Für welche Einheit kw.ssfk.unit 1 steht, dass modulo 1 eine ganze Umdrehung ist, dass # einen Kommentar "
     "beginnt. Wie geladen wird."},
    {"grblHAL, steps per unit and backlash", "grblHAL, Schritte je Einheit und Umkehrspiel"},
};

}  // namespace

const std::span<const Phrase> german_controls = controls_rows;

}  // namespace axiometry::language
