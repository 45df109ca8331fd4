// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
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
  double top = 0.0;       ///< distance from the top of the block
  double baseline = 0.0;  ///< distance of its baseline from the top of the block
  double bottom = 0.0;
};

/// What is alike in all blocks of one text in one style: lines, and how Pango draws them.
struct SetText;

/// Lines of text, set and measured, ready to be drawn in parts. Copies share them.
class TextBlock {
 public:
  const std::vector<Line>& lines() const;
  double width() const;  ///< width of the widest line
  double height() const { return lines().back().bottom; }

  /// Draws lines first … last − 1, the first base line at (x, y).
  void draw(cairo_t* cairo, Point first_baseline, std::size_t first, std::size_t last) const;

 private:
  friend class Typesetter;
  TextBlock(std::shared_ptr<const SetText> set, Colour colour) : set_(std::move(set)), colour_(colour) {}

  std::shared_ptr<const SetText> set_;
  Colour colour_;
};

/// Sets each text once for each size, weight and width: tables of thousands of readings hold few different numbers. For
/// one thread.
class Typesetter {
 public:
  Typesetter();

  /// Without a width, one line per line of the text; with it, wrapped at words, long words anywhere.
  TextBlock set(const RichText& text, const TextStyle& style, std::optional<double> width = std::nullopt) const;

  /// set(text, style).width(), without keeping how it is drawn.
  double width(const RichText& text, const TextStyle& style) const;

 private:
  std::shared_ptr<PangoContext> context_;
  mutable std::unordered_map<std::string, std::shared_ptr<const SetText>> known_;
  mutable std::unordered_map<std::string, double> known_widths_;
};

}  // namespace axiometry::report::pdf
