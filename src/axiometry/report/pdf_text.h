// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "axiometry/report/document.h"

typedef struct _cairo cairo_t;
typedef struct _PangoContext PangoContext;
typedef struct _PangoLayout PangoLayout;

/// Text set by Pango, so that any script shows for which the machine has a face. Lengths in points.
namespace axiometry::report::pdf {

struct TextStyle {
  double size = 9.0;
  bool bold = false;
  Colour colour{};
};

struct Line {
  double top = 0.0;       ///< from the top of the block
  double baseline = 0.0;  ///< likewise
  double bottom = 0.0;
};

/// Lines of text, set and measured, ready to be drawn in parts.
class TextBlock {
 public:
  const std::vector<Line>& lines() const { return lines_; }
  double width() const { return width_; }  ///< of the widest line
  double height() const { return lines_.back().bottom; }

  /// Draws lines first … last − 1, the first base line at (x, y).
  void draw(cairo_t* cairo, Point first_baseline, std::size_t first, std::size_t last) const;

 private:
  friend class Typesetter;
  /// A line above a letter, as in x̄.
  struct Bar {
    std::size_t line = 0;
    double left = 0.0;
    double right = 0.0;
    double above_baseline = 0.0;
    double thickness = 0.0;
  };

  void measure_lines();
  void add_bar(const TextRun& run, std::size_t start, double size);

  std::shared_ptr<PangoLayout> layout_;
  std::vector<Line> lines_;
  std::vector<Bar> bars_;
  Colour colour_;
  double width_ = 0.0;
};

class Typesetter {
 public:
  Typesetter();

  /// Without a width, one line per line of the text; with it, wrapped at words, long words anywhere.
  TextBlock set(const RichText& text, const TextStyle& style, std::optional<double> width = std::nullopt) const;

 private:
  std::shared_ptr<PangoContext> context_;
};

}  // namespace axiometry::report::pdf
