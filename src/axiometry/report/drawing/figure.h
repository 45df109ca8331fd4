// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>
#include <vector>

/// A drawing as a list of operations: drawn once, painted by the SVG, PDF and PNG writers alike.
/// Coordinates in points (1/72 inch), origin at the top left, y downwards.
namespace axiometry::report {

struct Colour {
  double r = 0.0, g = 0.0, b = 0.0, alpha = 1.0;  ///< 0 to 1
  friend bool operator==(const Colour&, const Colour&) = default;
};

struct Point {
  double x = 0.0, y = 0.0;
};

struct Stroke {
  Colour colour{};
  double width = 0.75;
  std::vector<double> dashes{};  ///< lengths on, off, …; empty for a solid line
};

/// A polyline or, closed, a polygon; filled and stroked as given.
struct Path {
  std::vector<Point> points{};
  bool closed = false;
  Stroke stroke{};          ///< width 0: no line
  Colour fill{0, 0, 0, 0};  ///< alpha 0: no fill
};

/// A filled disc, such as the mark of a mean.
struct Disc {
  Point centre{};
  double radius = 1.0;
  Colour fill{};
  Stroke stroke{.width = 0.0};
};

enum class Anchor { start, middle, end };
enum class Script { normal, sub, super };

/// A piece of a label in one style: symbols are italic, indices stand low, x̄ has a bar.
struct TextRun {
  std::string text{};
  bool italic = false;
  bool bold = false;
  bool bar = false;  ///< a line above, as in x̄ and B̄
  Script script = Script::normal;
  bool verbatim = false;  ///< words of the user, which are the same in every language
};

/// A line of text on a base line, turned by `degrees` anticlockwise about `at`.
struct Text {
  std::vector<TextRun> runs{};
  Point at{};
  double size = 8.0;  ///< height of normal script, points
  Colour colour{};
  Anchor anchor = Anchor::start;
  double degrees = 0.0;
};

using Operation = std::variant<Path, Disc, Text>;

struct Figure {
  double width = 0.0;
  double height = 0.0;
  std::string title{};        ///< caption; also the accessible name of the SVG
  std::string description{};  ///< one sentence for those who cannot see it
  std::vector<Operation> operations{};
};

/// Width of a label in points, from the metrics of the sans serif face that all writers use (Arial
/// and its metric equals), so that layout is the same in every output and needs no font at run time.
double text_width(const std::vector<TextRun>& runs, double size);

}  // namespace axiometry::report
