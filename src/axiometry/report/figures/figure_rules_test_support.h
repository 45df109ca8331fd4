// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/drawing/svg.h"
#include "axiometry/report/drawing/text_layout.h"

/// What every figure must keep to: its box, no text over another, and its golden picture.
namespace axiometry::report::testing {

inline std::string words(const Text& text) {
  std::string result;
  for (const TextRun& run : text.runs) result += run.text;
  return result;
}

inline std::vector<Text> texts(const Figure& figure) {
  std::vector<Text> result;
  for (const Operation& operation : figure.operations) {
    if (const Text* text = std::get_if<Text>(&operation)) result.push_back(*text);
  }
  return result;
}

inline std::vector<std::string> all_words(const Figure& figure) {
  std::vector<std::string> result;
  for (const Text& text : texts(figure)) result.push_back(words(text));
  return result;
}

inline Box box_of(const Operation& operation) {
  if (const Text* text = std::get_if<Text>(&operation)) return text_box(*text);
  if (const Disc* disc = std::get_if<Disc>(&operation)) {
    const double reach = disc->radius + disc->stroke.width / 2.0;
    return {disc->centre.x - reach, disc->centre.y - reach, disc->centre.x + reach, disc->centre.y + reach};
  }
  const Path& path = std::get<Path>(operation);
  Box box{path.points.front().x, path.points.front().y, path.points.front().x, path.points.front().y};
  for (const Point& p : path.points) {
    box = {std::min(box.left, p.x), std::min(box.top, p.y), std::max(box.right, p.x), std::max(box.bottom, p.y)};
  }
  return box;
}

/// Empty when the figure keeps its rules, else what breaks them.
inline std::string fault_of(const Figure& figure) {
  for (const Operation& operation : figure.operations) {
    const Box box = box_of(operation);
    const bool inside = box.left >= 0.0 && box.top >= 0.0 && box.right <= figure.width && box.bottom <= figure.height;
    if (inside) continue;  // false for NaN as well
    const Text* text = std::get_if<Text>(&operation);
    std::ostringstream fault;
    fault << "outside the figure: " << (text != nullptr ? words(*text) : "a drawing") << " at " << box.left << ' '
          << box.top << ' ' << box.right << ' ' << box.bottom;
    return fault.str();
  }
  const std::vector<Text> labels = texts(figure);
  for (std::size_t a = 0; a < labels.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (overlap(text_box(labels[a]), text_box(labels[b]))) {
        return "overlapping texts: \"" + words(labels[a]) + "\" and \"" + words(labels[b]) + '"';
      }
    }
  }
  const std::string svg = to_svg(figure);
  if (svg.find("nan") != std::string::npos || svg.find("inf") != std::string::npos) return "NaN or infinity";
  return {};
}

inline std::string read(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Byte for byte; a mismatch leaves the new picture beside the old one, to be looked at.
inline void expect_golden(const Figure& figure, const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(AXIOMETRY_SOURCE_DIR) / "tests/golden/figures";
  const std::string svg = to_svg(figure);
  if (svg == read(folder / (name + ".svg"))) return;
  const auto written = folder / (name + ".new.svg");
  std::filesystem::create_directories(folder);
  std::ofstream(written, std::ios::binary) << svg;
  ADD_FAILURE() << name << ".svg differs; look at " << written.string()
                << " and, if it is right, let it take the place of " << name << ".svg";
}

}  // namespace axiometry::report::testing
