// SPDX-License-Identifier: Apache-2.0
// OKLab: Björn Ottosson, "A perceptual color space for image processing" (2020).
#include "axiometry/report/drawing/dark_page.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace axiometry::report {
namespace {

struct Lab {
  double L = 0.0, a = 0.0, b = 0.0;
};

double linear(double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); }

double companded(double x) {
  const double s = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
  return std::clamp(s, 0.0, 1.0);
}

Lab lab_of(const Colour& colour) {
  const double r = linear(colour.r), g = linear(colour.g), b = linear(colour.b);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Colour colour_of(const Lab& lab, double alpha) {
  const double l = std::pow(lab.L + 0.3963377774 * lab.a + 0.2158037573 * lab.b, 3.0);
  const double m = std::pow(lab.L - 0.1055613458 * lab.a - 0.0638541728 * lab.b, 3.0);
  const double s = std::pow(lab.L - 0.0894841775 * lab.a - 1.2914855480 * lab.b, 3.0);
  return {companded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          companded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          companded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s), alpha};
}

/// White (L = 1) falls on the page, and the darkest ink on nearly white.
Colour turned(const Colour& colour) {
  static const Lab page = lab_of(dark_page);
  constexpr double brightest = 0.96;
  const Lab lab = lab_of(colour);
  const double share = 1.0 - std::clamp(lab.L, 0.0, 1.0);
  // Coloured inks lie in the middle, where a dark page needs more light than white needs darkness.
  const double lifted = std::pow(share, 0.7);
  const Lab dark{page.L + (brightest - page.L) * std::min(1.0, lifted * 1.12), lab.a + page.a * (1.0 - share),
                 lab.b + page.b * (1.0 - share)};
  return colour_of(dark, colour.alpha);
}

void turn(Colour& colour) {
  if (colour.alpha > 0.0) colour = turned(colour);
}

struct Turn {
  void operator()(Path& path) const {
    turn(path.stroke.colour);
    turn(path.fill);
  }
  void operator()(Disc& disc) const {
    turn(disc.fill);
    turn(disc.stroke.colour);
  }
  void operator()(Text& text) const { turn(text.colour); }
};

}  // namespace

Figure for_dark_page(Figure figure) {
  for (Operation& operation : figure.operations) std::visit(Turn{}, operation);
  return figure;
}

}  // namespace axiometry::report
