// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "axiometry/report/pdf/pdf_text.h"

/// Pages that fill from top to bottom. Everything is placed before anything is drawn, since the
/// running foot tells how many pages there are. Lengths in points.
namespace axiometry::report::pdf {

inline constexpr double page_width = 595.276;  // A4
inline constexpr double page_height = 841.890;
inline constexpr double margin_side = 48.0;
inline constexpr double margin_top = 62.0;
inline constexpr double margin_bottom = 58.0;
inline constexpr double body_width = page_width - 2.0 * margin_side;
inline constexpr double body_height = page_height - margin_top - margin_bottom;

/// Lines first … last − 1 of a text, the first base line at a point of the page.
struct PlacedLines {
  TextBlock text;
  Point first_baseline;
  std::size_t first = 0;
  std::size_t last = 0;
};

/// Nearly all are lines of text, and of them there may be a million.
using Drawing = std::variant<PlacedLines, std::function<void(cairo_t*)>>;

void draw(const Drawing& drawing, cairo_t* cairo);

/// Where a section begins, for the outline of the file.
struct Bookmark {
  std::string title;
  std::size_t page = 0;  ///< number of the page, from 0
  double y = 0.0;
};

class PageFlow {
 public:
  explicit PageFlow(double top_of_first_page) : pages_(1), y_(top_of_first_page) {}

  double y() const { return y_; }
  double room() const { return page_height - margin_bottom - y_; }
  bool at_top() const { return y_ == margin_top; }

  void new_page();
  /// Begins a page unless so much room is left; nothing can ask for more than a page.
  void need(double height);
  /// White space, which a page does not begin with.
  void skip(double height);
  void advance(double height) { y_ += height; }

  /// Drawings of a page happen in the order they were placed; coordinates are those of the page.
  void place(Drawing drawing) { pages_.back().push_back(std::move(drawing)); }
  void bookmark(std::string title) { bookmarks_.push_back({std::move(title), pages_.size() - 1, y_}); }

  const std::vector<std::vector<Drawing>>& pages() const { return pages_; }
  const std::vector<Bookmark>& bookmarks() const { return bookmarks_; }

 private:
  std::vector<std::vector<Drawing>> pages_;
  std::vector<Bookmark> bookmarks_;
  double y_;
};

/// One cell of a row: its text and where it stands.
struct PlacedText {
  TextBlock text;
  double x = 0.0;  ///< left edge of the lines
};

/// Places texts side by side on a common first base line. A row higher than the room left begins a
/// page; one higher than a page is broken between lines. `on_new_page` repeats a head.
void place_row(PageFlow& flow, const std::vector<PlacedText>& cells, const std::function<void()>& on_new_page = {});

/// Height of such a row.
double row_height(const std::vector<PlacedText>& cells);

void place_rule(PageFlow& flow, double x, double width, double thickness, Colour colour);

}  // namespace axiometry::report::pdf
