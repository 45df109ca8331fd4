// SPDX-License-Identifier: Apache-2.0
// What reports of volumetric calibrations draw, predict and export.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase rows[] = {
    {"Displacement", "Verlagerung"},
    {"Error motions of {0=}", "Bewegungsabweichungen von {0}"},
    {"Error motions over the travel", "Bewegungsabweichungen über dem Verfahrweg"},
    {"Reading, in the order of measurement", "Messwert in der Reihenfolge der Messung"},
    {"Residuals", "Residuen"},
    {"Residuals of the lengths", "Residuen der Längen"},
    {"Rotation", "Verdrehung"},
    {"Station and tool", "Standort und Werkzeug"},
    {"The three displacements and the three rotations of the axis over its position, with the bands in which they lie.",
     "Die drei Verlagerungen und die drei Verdrehungen der Achse über ihrer Position, mit den Bändern, in denen sie "
     "liegen."},
    {"What is left of each length, in the order of measurement, over the positions of the axes and by station.",
     "Was von jeder Länge übrig bleibt: in der Reihenfolge der Messung, über den Positionen der Achsen und nach "
     "Standort."},
    {"error", "Abweichung"},
    {"mean of both directions", "Mittel beider Richtungen"},
    {"moving down", "Bewegung abwärts"},
    {"moving up", "Bewegung aufwärts"},
    {"not told", "nicht bestimmt"},
    {"pitch", "Nicken"},
    {"positioning", "Positionieren"},
    {"roll", "Rollen"},
    {"root mean square of a station", "quadratisches Mittel eines Standorts"},
    {"set aside, at the edge where beyond it", "ausgesondert, außerhalb liegende am Rand"},
    {"straightness", "Geradheit"},
    {"yaw", "Gieren"},
};

}  // namespace

const std::span<const Phrase> german_volume_report = rows;

}  // namespace axiometry::language
