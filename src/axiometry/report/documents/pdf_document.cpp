// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/documents/pdf_document.h"

#include <cairo.h>

#include <algorithm>
#include <numeric>
#include <span>

#include "axiometry/report/drawing/upper_case.h"
#include "axiometry/report/pdf/cairo_painter.h"
#include "axiometry/report/pdf/pdf_palette.h"
#include "axiometry/report/pdf/pdf_table.h"

namespace axiometry::report::pdf {

namespace {

constexpr double body_size = 9.0;
constexpr double first_page_top = 36.0;  // no running head above the title
constexpr double fact_size = 8.5;
constexpr double fact_gap = 10.0;
constexpr double fact_padding = 2.4;  // above and below the text
constexpr double after_facts = 11.0;
constexpr double least_beginning = 90.0;
constexpr double undivided_facts = 0.3 * body_height;  // a shorter group is not broken across pages
constexpr double notice_indent = 12.0;
constexpr double figure_height_max = 0.86 * body_height;
constexpr double figure_caption_drop = 8.0;
constexpr double rounding = 0.1;         // so that a caption set to the very foot of a page stays below its figure
constexpr double smallest_figure = 0.7;  // of its full size, when the page then holds it

/// Where names and values of facts stand.
struct FactColumn {
  double left = 0.0;
  double width = 0.0;
  double name_width = 0.0;
};
constexpr FactColumn whole_width{margin_side, body_width, 150.0};
constexpr double column_gap = 24.0;
constexpr double column_width = (body_width - column_gap) / 2.0;
constexpr FactColumn left_column{margin_side, column_width, 104.0};
constexpr FactColumn right_column{margin_side + column_width + column_gap, column_width, 104.0};

/// Sets the blocks of a document one below the other.
struct Setter {
  const Typesetter& typesetter;
  PageFlow& flow;

  TextBlock text(const RichText& text, double size, Colour colour, double width, bool bold = false) const {
    return typesetter.set(text, {size, bold, colour}, width);
  }

  void set(const Paragraph& paragraph) const {
    place_row(flow, {{text(paragraph.text, body_size, tone_colours(paragraph.tone).text, body_width), margin_side}});
    flow.skip(6.0);
  }

  void set(const Table& table) const {
    set_table(table, typesetter, flow);
    flow.skip(14.0);
  }

  /// A name and its value side by side in a column.
  std::vector<PlacedText> fact_row(const Fact& fact, const FactColumn& column) const {
    const double value_left = column.left + column.name_width + fact_gap;
    const double value_width = column.left + column.width - value_left;
    return {{text(fact.name, fact_size, quiet, column.name_width), column.left},
            {text(fact.value.text, fact_size, tone_colours(fact.value.tone).text, value_width), value_left}};
  }

  void place(const Facts& facts, const FactColumn& column) const {
    if (!facts.title.empty()) {
      place_row(flow, {{text(strong(facts.title), body_size, ink, column.width), column.left}});
      flow.advance(3.0);
    }
    for (const Fact& fact : facts.facts) {
      place_rule(flow, column.left, column.width, 0.4, hairline);
      flow.advance(fact_padding);
      place_row(flow, fact_row(fact, column));
      flow.advance(fact_padding);
    }
    flow.skip(after_facts);
  }

  double height_of(const Facts& facts, const FactColumn& column) const {
    double height = after_facts;
    if (!facts.title.empty()) height += text(strong(facts.title), body_size, ink, column.width).height() + 3.0;
    for (const Fact& fact : facts.facts) height += row_height(fact_row(fact, column)) + 2.0 * fact_padding;
    return height;
  }

  void set(const Facts& facts) const {
    flow.need(std::min(20.0 + 16.0 * static_cast<double>(facts.facts.size()), undivided_facts));
    place(facts, whole_width);
  }

  /// How groups are parted between two columns of about the same height.
  struct Columns {
    std::size_t in_left = 0;
    double height = 0.0;
  };

  Columns columns_for(std::span<const Facts* const> groups) const {
    std::vector<double> heights;
    for (const Facts* facts : groups) heights.push_back(height_of(*facts, left_column));
    double left = 0.0;
    double right = std::accumulate(heights.begin(), heights.end(), 0.0);
    std::size_t split = 0;
    for (; split < heights.size(); ++split) {
      if (std::max(left + heights[split], right - heights[split]) > std::max(left, right)) break;
      left += heights[split];
      right -= heights[split];
    }
    return {split, std::max(left, right)};
  }

  /// Several groups side by side; one below the other where they would fill a page.
  void set(std::span<const Facts* const> groups) const {
    const Columns columns = columns_for(groups);
    if (groups.size() < 2 || columns.height > body_height) {
      for (const Facts* facts : groups) set(*facts);
      return;
    }
    flow.need(columns.height - after_facts);
    const double top = flow.y();
    for (const Facts* facts : groups.first(columns.in_left)) place(*facts, left_column);
    flow.advance(top - flow.y());
    for (const Facts* facts : groups.subspan(columns.in_left)) place(*facts, right_column);
    flow.advance(std::max(0.0, top + columns.height - flow.y()));
  }

  void set(const Notice& notice) const {
    const ToneColours colours = tone_colours(notice.tone);
    const double width = body_width - 2.0 * notice_indent;
    std::vector<TextBlock> parts = {text(notice.heading, 9.5, colours.text, width, true)};
    for (const RichText& line : notice.lines) parts.push_back(text(line, fact_size, ink, width));
    double height = 12.0;
    for (const TextBlock& part : parts) height += part.height() + 2.0;
    flow.need(height);
    if (height <= flow.room()) ground(colours, height);
    flow.advance(6.5);
    for (TextBlock& part : parts) {
      place_row(flow, {{std::move(part), margin_side + notice_indent}});
      flow.advance(2.0);
    }
    flow.advance(5.5);
    flow.skip(6.0);
  }

  void ground(const ToneColours& colours, double height) const {
    const double y = flow.y();
    flow.place([=](cairo_t* cairo) {
      cairo_set_source_rgb(cairo, colours.ground.r, colours.ground.g, colours.ground.b);
      cairo_rectangle(cairo, margin_side, y, body_width, height);
      cairo_fill(cairo);
      cairo_set_source_rgb(cairo, colours.text.r, colours.text.g, colours.text.b);
      cairo_rectangle(cairo, margin_side, y, 3.0, height);
      cairo_fill(cairo);
    });
  }

  static double full_scale(const Figure& figure) {
    return std::min(body_width / figure.width, figure_height_max / figure.height);
  }

  double caption_height(const Figure& figure) const {
    return figure_caption_drop + text(strong(figure.title), body_size, ink, body_width).height() + rounding;
  }

  /// The least height that the figure can do with.
  double height_of(const Figure& figure) const {
    return smallest_figure * full_scale(figure) * figure.height + caption_height(figure);
  }

  /// A figure that would just not fit is drawn somewhat smaller, rather than leave the page half empty.
  void set(const Figure& figure) const {
    flow.need(height_of(figure));
    const double scale = std::min(full_scale(figure), (flow.room() - caption_height(figure)) / figure.height);
    const double x = margin_side + (body_width - scale * figure.width) / 2.0;
    flow.place([&figure, x, y = flow.y(), scale](cairo_t* cairo) {
      cairo_save(cairo);
      cairo_translate(cairo, x, y);
      cairo_scale(cairo, scale, scale);
      paint(figure, cairo);
      cairo_restore(cairo);
    });
    flow.advance(scale * figure.height + figure_caption_drop);
    place_row(flow, {{text(strong(figure.title), body_size, ink, body_width), margin_side}});
    flow.skip(18.0);
  }

  /// Room that a section's title needs below it, so that it does not stand alone at a page's foot.
  double height_of_beginning(const Section& section) const {
    if (section.blocks.empty()) return 0.0;
    const Block& first = section.blocks.front();
    if (const auto* figure = std::get_if<Figure>(&first)) return height_of(*figure);
    if (const auto* table = std::get_if<Table>(&first)) return beginning_height(*table, typesetter);
    const auto groups = leading_facts(section.blocks);
    return groups.size() > 1 ? columns_for(groups).height : least_beginning;
  }

  static std::vector<const Facts*> leading_facts(std::span<const Block> blocks) {
    std::vector<const Facts*> groups;
    for (const Block& block : blocks) {
      const auto* facts = std::get_if<Facts>(&block);
      if (!facts) break;
      groups.push_back(facts);
    }
    return groups;
  }

  void set(std::span<const Block> blocks) const {
    for (std::size_t b = 0; b < blocks.size();) {
      if (const auto groups = leading_facts(blocks.subspan(b)); !groups.empty()) {
        set(std::span(groups));
        b += groups.size();
      } else {
        std::visit([&](const auto& block) { set(block); }, blocks[b++]);
      }
    }
  }

  void set(const Section& section, const std::string& label) const {
    flow.skip(8.0);
    flow.need(30.0 + height_of_beginning(section));
    flow.bookmark(section.title);
    std::vector<PlacedText> title = {{text(strong(section.title), 12.0, accent, body_width), margin_side}};
    if (section.shows_results && !label.empty()) {
      TextBlock tag = text(strong(label), 8.0, tone_colours(Tone::caution).text, body_width / 2.0);
      const double x = margin_side + body_width - tag.width();
      title.push_back({std::move(tag), x});
    }
    place_row(flow, title);
    flow.advance(4.0);
    place_rule(flow, margin_side, body_width, 1.0, accent);
    flow.advance(10.0);
    set(std::span(section.blocks));
  }

  /// Some of axis, machine, date, … side by side.
  void place_beside(std::span<const Fact> identity) const {
    constexpr double gap = 10.0;
    // One that has much to say gets the room of two.
    constexpr std::size_t much = 18;  // bytes
    const auto length = [](const Fact& fact) { return plain_text(fact.value.text).size(); };
    const auto longest = std::ranges::max_element(identity, {}, length);
    const bool widened = length(*longest) > much;
    const double share = (body_width + gap) / static_cast<double>(identity.size() + (widened ? 1 : 0));
    std::vector<PlacedText> names;
    std::vector<PlacedText> values;
    double x = margin_side;
    for (auto fact_at = identity.begin(); fact_at != identity.end(); ++fact_at) {
      const Fact& fact = *fact_at;
      const double width = (widened && fact_at == longest ? 2.0 : 1.0) * share - gap;
      names.push_back({text(fact.name, 7.5, quiet, width), x});
      values.push_back(
          {text(fact.value.text, body_size, tone_colours(fact.value.tone).text, width, fact.value.tone != Tone::quiet),
           x});
      x += width + gap;
    }
    place_row(flow, names);
    flow.advance(2.0);
    place_row(flow, values);
    flow.advance(8.0);
  }

  void set_identity(std::span<const Fact> identity) const {
    if (identity.empty()) return;
    constexpr std::size_t side_by_side = 5;
    place_rule(flow, margin_side, body_width, 0.6, rule);
    flow.advance(7.0);
    for (; identity.size() > side_by_side; identity = identity.subspan(side_by_side))
      place_beside(identity.first(side_by_side));
    place_beside(identity);
    place_rule(flow, margin_side, body_width, 0.6, rule);
    flow.advance(12.0);
  }
};

}  // namespace

PageFlow set_document(const Document& document, const Typesetter& typesetter) {
  PageFlow flow(first_page_top);
  const Setter setter{typesetter, flow};
  place_rule(flow, margin_side, body_width, 3.0, accent);
  flow.advance(12.0);
  place_row(flow, {{setter.text(strong(upper_case(document.kind) + " · " + document.edition), 8.0, accent, body_width),
                    margin_side}});
  flow.advance(4.0);
  place_row(flow, {{setter.text(strong(document.title), 17.0, ink, body_width), margin_side}});
  flow.advance(12.0);
  setter.set_identity(document.identity);
  for (const Notice& notice : document.status) setter.set(notice);
  for (const Section& section : document.sections) setter.set(section, document.label);
  return flow;
}

}  // namespace axiometry::report::pdf
