// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/pdf/cairo_painter.h"

#include <cairo.h>
#include <gtest/gtest.h>

#include "axiometry/report/figures/figures_test_support.h"

namespace axiometry::report {
namespace {

struct Ink {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

Ink ink_of(const Figure& figure) {
  cairo_surface_t* surface = cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, nullptr);
  cairo_t* cairo = cairo_create(surface);
  paint(figure, cairo);
  EXPECT_EQ(cairo_status(cairo), CAIRO_STATUS_SUCCESS);
  double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
  cairo_recording_surface_ink_extents(surface, &x, &y, &width, &height);
  cairo_destroy(cairo);
  cairo_surface_destroy(surface);
  return {x, y, x + width, y + height};
}

TEST(CairoPainter, KeepsEveryFigureWithinItsBox) {
  for (const auto& c : testing::crowded_cases()) {
    for (const Figure& figure : c.drawn.draw()) {
      const Ink ink = ink_of(figure);
      EXPECT_GE(ink.left, -0.5) << c.name;
      EXPECT_GE(ink.top, -0.5) << c.name;
      EXPECT_LE(ink.right, figure.width + 0.5) << c.name;
      EXPECT_LE(ink.bottom, figure.height + 0.5) << c.name;
    }
  }
}

TEST(CairoPainter, FitsTextToTheMetricsWhateverTheFace) {
  const std::string letters(40, 'm');
  const Figure figure{.width = 500, .height = 20, .operations = {Text{.runs = {{.text = letters}}, .at = {0, 10}}}};
  const Ink ink = ink_of(figure);
  EXPECT_NEAR(ink.right, text_width({{.text = letters}}, 8.0), 0.03 * ink.right);
}

TEST(CairoPainter, BearsTextsThatAreNotUtf8) {
  const Figure figure{.width = 50, .height = 20, .operations = {Text{.runs = {{.text = "a\xff\x01"}}, .at = {5, 10}}}};
  EXPECT_GT(ink_of(figure).right, 5.0);
}

}  // namespace
}  // namespace axiometry::report
