// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/drawing/text_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "axiometry/report/drawing/utf8.h"
#include "axiometry/report/pdf/font_metrics.h"

namespace axiometry::report {
namespace {

// Shares of the font size of normal script.
constexpr double script_size = 0.72;
constexpr double sub_rise = -0.17;
constexpr double super_rise = 0.36;
constexpr double ascent = 0.74;
constexpr double descent = 0.21;

// Shares of the run's own font size; x-height and cap height of the face are 0.528 and 0.688.
constexpr double bar_rise_small = 0.62;
constexpr double bar_rise_capital = 0.79;
constexpr double bar_thickness = 0.065;
constexpr double italic_slant = 0.21;  // tangent of the slope of the italic face

FaceStyle face_of(const TextRun& run) {
  return run.bold ? FaceStyle::bold : run.italic ? FaceStyle::italic : FaceStyle::regular;
}

double size_of(const TextRun& run, double size) { return run.script == Script::normal ? size : script_size * size; }

double rise_of(const TextRun& run, double size) {
  return run.script == Script::sub ? sub_rise * size : run.script == Script::super ? super_rise * size : 0.0;
}

double run_width(const TextRun& run, double size) {
  const FaceStyle style = face_of(run);
  int thousandths = 0;
  for (std::size_t at = 0; at < run.text.size();) {
    const Character c = character_at(run.text, at);
    thousandths += advance_width(c.code, style);
    at += c.length;
  }
  return thousandths * size_of(run, size) / 1000.0;
}

PlacedBar bar_over(const PlacedRun& placed) {
  const std::string& letters = placed.run->text;
  const bool small = std::ranges::any_of(letters, [](char c) { return c >= 'a' && c <= 'z'; }) &&
                     std::ranges::none_of(letters, [](char c) { return c >= 'A' && c <= 'Z'; });
  const double rise = (small ? bar_rise_small : bar_rise_capital) * placed.size;
  const double lean = placed.run->italic ? italic_slant * rise : 0.0;
  const double inset = 0.06 * placed.size;
  // Half of the lean: optically the bar then stands over the letter's middle, not over its tip.
  return {.x = placed.x + inset + lean / 2.0,
          .width = std::max(placed.width - 2.0 * inset, 0.0),
          .rise = placed.rise + rise,
          .thickness = bar_thickness * placed.size};
}

}  // namespace

double text_width(const std::vector<TextRun>& runs, double size) {
  double width = 0.0;
  for (const TextRun& run : runs) width += run_width(run, size);
  return width;
}

TextLayout lay_out(const Text& text) {
  TextLayout layout;
  layout.runs.reserve(text.runs.size());
  for (const TextRun& run : text.runs) {
    const PlacedRun placed{.run = &run,
                           .x = layout.width,
                           .rise = rise_of(run, text.size),
                           .size = size_of(run, text.size),
                           .width = run_width(run, text.size)};
    layout.runs.push_back(placed);
    if (run.bar) layout.bars.push_back(bar_over(placed));
    layout.width += placed.width;
  }
  return layout;
}

double anchor_shift(Anchor anchor, double width) {
  return anchor == Anchor::start ? 0.0 : anchor == Anchor::middle ? -width / 2.0 : -width;
}

Box text_box(const Text& text) {
  const double width = text_width(text.runs, text.size);
  const double start = anchor_shift(text.anchor, width);
  const double angle = text.degrees * std::numbers::pi / 180.0;
  Box box{std::numeric_limits<double>::max(), std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest(),
          std::numeric_limits<double>::lowest()};
  for (const double along : {start, start + width}) {
    for (const double up : {ascent * text.size, -descent * text.size}) {
      const double x = text.at.x + along * std::cos(angle) - up * std::sin(angle);
      const double y = text.at.y - along * std::sin(angle) - up * std::cos(angle);
      box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x), std::max(box.bottom, y)};
    }
  }
  return box;
}

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

}  // namespace axiometry::report
