// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/drawing/dark_page.h"

#include <gtest/gtest.h>

#include <cmath>

#include "axiometry/report/figures/parts/ink.h"

namespace axiometry::report {
namespace {

/// Relative luminance of WCAG 2.
double luminance(const Colour& colour) {
  const auto linear = [](double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(colour.r) + 0.7152 * linear(colour.g) + 0.0722 * linear(colour.b);
}

double contrast(const Colour& colour) {
  const double a = luminance(colour), b = luminance(dark_page);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

Colour turned(const Colour& colour) {
  Figure figure;
  figure.operations.push_back(Disc{.fill = colour});
  return std::get<Disc>(for_dark_page(figure).operations.front()).fill;
}

TEST(DarkPage, PutsWhiteOnThePageItself) {
  const Colour white = turned({1.0, 1.0, 1.0});
  EXPECT_NEAR(white.r, dark_page.r, 0.002);
  EXPECT_NEAR(white.g, dark_page.g, 0.002);
  EXPECT_NEAR(white.b, dark_page.b, 0.002);
}

TEST(DarkPage, LetsInkBeRead) {
  using namespace plot::ink;
  for (const Colour& text : {black, grey, blue, vermilion}) EXPECT_GE(contrast(turned(text)), 4.5);
  EXPECT_LT(contrast(turned(grid_grey)), 2.0) << "a grid stays behind the curves";
}

TEST(DarkPage, KeepsHuesAndTransparency) {
  const Colour blue = turned(plot::ink::blue);
  EXPECT_GT(blue.b, blue.r);
  const Colour vermilion = turned(plot::ink::vermilion);
  EXPECT_GT(vermilion.r, vermilion.b);
  EXPECT_EQ(turned(plot::ink::none), plot::ink::none);
  EXPECT_EQ(turned(plot::ink::faint(plot::ink::blue, 0.09)).alpha, 0.09);
}

}  // namespace
}  // namespace axiometry::report
