// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "axiometry/report/drawing/svg.h"
#include "axiometry/report/figures/parts/symbols.h"

namespace axiometry::report {
namespace {

constexpr double margin = 18.0;
constexpr double caption_size = 8.0;
constexpr double caption_drop = 14.0;  // from a figure's lower edge to the base line of its caption
constexpr double after_figure = 20.0;
constexpr Colour caption_colour{0.1, 0.1, 0.1};

class Shift {
 public:
  explicit Shift(Point by) : by_(by) {}

  Operation operator()(Path path) const {
    for (Point& point : path.points) point = shifted(point);
    return path;
  }
  Operation operator()(Disc disc) const {
    disc.centre = shifted(disc.centre);
    return disc;
  }
  Operation operator()(Text text) const {
    text.at = shifted(text.at);
    return text;
  }

 private:
  Point shifted(Point p) const { return {p.x + by_.x, p.y + by_.y}; }
  Point by_;
};

Text caption(const Figure& figure, Point at) {
  return {.runs = {plot::plain(plot::shortened(figure.title, figure.width, caption_size))},
          .at = at,
          .size = caption_size,
          .colour = caption_colour,
          .anchor = Anchor::start,
          .degrees = 0.0};
}

void append(std::string& list, const std::string& item) {
  if (!item.empty()) list += (list.empty() ? "" : " ") + item;
}

}  // namespace

Figure stacked(std::span<const Figure> figures) {
  Figure page;
  double y = margin;
  for (const Figure& figure : figures) {
    page.width = std::max(page.width, figure.width + 2.0 * margin);
    const Shift shift({margin, y});
    for (const Operation& operation : figure.operations) page.operations.push_back(std::visit(shift, operation));
    y += figure.height;
    if (!figure.title.empty()) {
      page.operations.push_back(caption(figure, {margin, y + caption_drop}));
      y += caption_drop + after_figure;
    }
    append(page.title, figure.title);
    append(page.description, figure.description);
  }
  page.height = y + margin - (figures.empty() || figures.back().title.empty() ? 0.0 : after_figure);
  return page;
}

}  // namespace axiometry::report
