// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/pdf/pdf_text.h"
#include "axiometry/report/drawing/utf8.h"

#include <pango/pangocairo.h>

#include <algorithm>

namespace axiometry::report::pdf {

namespace {

constexpr const char* family = "Liberation Sans, Arial, Helvetica, sans-serif";
constexpr double script_scale = 0.72;
constexpr double subscript_drop = 0.18;  // drop as a share of the size
constexpr double superscript_rise = 0.33;
constexpr double bar_above_small_letter = 0.61;
constexpr double bar_above_capital = 0.79;
constexpr double italic_slant = 0.1;
constexpr double bar_thickness = 0.07;

double points(int pango_units) { return static_cast<double>(pango_units) / PANGO_SCALE; }
int pango_units(double points) { return static_cast<int>(points * PANGO_SCALE); }

void insert(PangoAttrList* attributes, PangoAttribute* attribute, std::size_t start, std::size_t end) {
  attribute->start_index = static_cast<guint>(start);
  attribute->end_index = static_cast<guint>(end);
  pango_attr_list_insert(attributes, attribute);
}

void style_run(PangoAttrList* attributes, const TextRun& run, double size, std::size_t start, std::size_t end) {
  if (run.italic) insert(attributes, pango_attr_style_new(PANGO_STYLE_ITALIC), start, end);
  if (run.bold) insert(attributes, pango_attr_weight_new(PANGO_WEIGHT_BOLD), start, end);
  if (run.script == Script::normal) return;
  const double rise = run.script == Script::sub ? -subscript_drop : superscript_rise;
  insert(attributes, pango_attr_scale_new(script_scale), start, end);
  insert(attributes, pango_attr_rise_new(pango_units(rise * size)), start, end);
}

}  // namespace

Typesetter::Typesetter() {
  PangoFontMap* map = pango_cairo_font_map_new();
  pango_cairo_font_map_set_resolution(PANGO_CAIRO_FONT_MAP(map), 72.0);
  context_ = {pango_font_map_create_context(map), [](PangoContext* context) { g_object_unref(context); }};
  g_object_unref(map);
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  pango_cairo_context_set_font_options(context_.get(), options);
  cairo_font_options_destroy(options);
  pango_context_set_round_glyph_positions(context_.get(), FALSE);
}

namespace {

PangoLayout* new_layout(PangoContext* context, const TextStyle& style, std::optional<double> width) {
  PangoLayout* layout = pango_layout_new(context);
  PangoFontDescription* font = pango_font_description_from_string(family);
  pango_font_description_set_absolute_size(font, style.size * PANGO_SCALE);
  if (style.bold) pango_font_description_set_weight(font, PANGO_WEIGHT_BOLD);
  pango_layout_set_font_description(layout, font);
  pango_font_description_free(font);
  if (width) {
    pango_layout_set_width(layout, pango_units(*width));
    pango_layout_set_wrap(layout, PANGO_WRAP_WORD_CHAR);
  }
  return layout;
}

/// Breaks lines by itself after that many bytes without a break: Pango takes time with the square of a paragraph's
/// length, minutes for 100 kB.
constexpr std::size_t paragraph_max = 1000;

/// At a blank where there is one in the last quarter, never within a character.
std::string in_paragraphs(std::string_view text) {
  std::string result;
  while (true) {
    const std::size_t line_end = text.find('\n');
    const std::size_t length = line_end == std::string_view::npos ? text.size() : line_end + 1;
    if (length <= paragraph_max) {
      result += text.substr(0, length);
      text.remove_prefix(length);
      if (text.empty()) return result;
      continue;
    }
    std::size_t end = text.rfind(' ', paragraph_max - 1);
    const bool at_blank = end != std::string_view::npos && end >= paragraph_max * 3 / 4;
    if (!at_blank)
      for (end = paragraph_max; (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u;) --end;
    result += text.substr(0, end);
    result += '\n';
    text.remove_prefix(at_blank ? end + 1 : end);
  }
}

/// Puts the text into the layout and returns where in it each run begins, in bytes.
std::vector<std::size_t> fill(PangoLayout* layout, const RichText& text, double size) {
  std::string all;
  std::vector<std::size_t> starts;
  PangoAttrList* attributes = pango_attr_list_new();
  // A serial number broken over lines must not gain hyphens.
  pango_attr_list_insert(attributes, pango_attr_insert_hyphens_new(FALSE));
  for (const TextRun& run : text) {
    starts.push_back(all.size());
    all += in_paragraphs(cleaned(run.text));
    style_run(attributes, run, size, starts.back(), all.size());
  }
  pango_layout_set_text(layout, all.data(), static_cast<int>(all.size()));
  pango_layout_set_attributes(layout, attributes);
  pango_attr_list_unref(attributes);
  return starts;
}

/// A line above a letter, as in x̄.
struct Bar {
  std::size_t line = 0;
  double left = 0.0;
  double right = 0.0;
  double above_baseline = 0.0;
  double thickness = 0.0;
};

/// All that the layout of a text depends on, in bytes.
std::string key_of(const RichText& text, const TextStyle& style, std::optional<double> width) {
  std::string key;
  const auto add = [&key](const auto& value) { key.append(reinterpret_cast<const char*>(&value), sizeof value); };
  add(style.size);
  add(style.bold);
  add(width.value_or(-1.0));
  for (const TextRun& run : text) {
    for (const bool is : {run.italic, run.bold, run.bar}) add(is);
    add(run.script);
    add(run.text.size());
    key += run.text;
  }
  return key;
}

}  // namespace

struct SetText {
  std::unique_ptr<PangoLayout, decltype(&g_object_unref)> layout;
  std::vector<Line> lines{};
  std::vector<Bar> bars{};
  double width = 0.0;
};

namespace {

void measure_lines(SetText& set) {
  PangoLayoutIter* iterator = pango_layout_get_iter(set.layout.get());
  do {
    int top = 0;
    int bottom = 0;
    pango_layout_iter_get_line_yrange(iterator, &top, &bottom);
    PangoRectangle extents;
    pango_layout_iter_get_line_extents(iterator, nullptr, &extents);
    set.lines.push_back({points(top), points(pango_layout_iter_get_baseline(iterator)), points(bottom)});
    set.width = std::max(set.width, points(extents.width));
  } while (pango_layout_iter_next_line(iterator));
  pango_layout_iter_free(iterator);
}

Bar bar_over(PangoLayout* layout, const TextRun& run, std::size_t start, double size) {
  int line = 0;
  pango_layout_index_to_line_x(layout, static_cast<int>(start), FALSE, &line, nullptr);
  PangoRectangle place;
  pango_layout_index_to_pos(layout, static_cast<int>(start), &place);
  const double own_size = size * (run.script == Script::normal ? 1.0 : script_scale);
  const bool capital = !run.text.empty() && run.text.front() >= 'A' && run.text.front() <= 'Z';
  const double slant = run.italic ? italic_slant * own_size : 0.0;
  return {static_cast<std::size_t>(line), points(place.x) + slant, points(place.x + place.width) + 0.3 * slant,
          own_size * (capital ? bar_above_capital : bar_above_small_letter), own_size * bar_thickness};
}

SetText set_anew(PangoContext* context, const RichText& text, const TextStyle& style, std::optional<double> width) {
  SetText set{.layout = {new_layout(context, style, width), &g_object_unref}};
  const std::vector<std::size_t> starts = fill(set.layout.get(), text, style.size);
  measure_lines(set);
  for (std::size_t k = 0; k < text.size(); ++k)
    if (text[k].bar) set.bars.push_back(bar_over(set.layout.get(), text[k], starts[k], style.size));
  return set;
}

}  // namespace

TextBlock Typesetter::set(const RichText& text, const TextStyle& style, std::optional<double> width) const {
  std::shared_ptr<const SetText>& known = known_[key_of(text, style, width)];
  if (!known) known = std::make_shared<const SetText>(set_anew(context_.get(), text, style, width));
  return {known, style.colour};
}

double Typesetter::width(const RichText& text, const TextStyle& style) const {
  const auto [known, is_new] = known_widths_.try_emplace(key_of(text, style, std::nullopt));
  if (is_new) known->second = set_anew(context_.get(), text, style, std::nullopt).width;
  return known->second;
}

const std::vector<Line>& TextBlock::lines() const { return set_->lines; }
double TextBlock::width() const { return set_->width; }

void TextBlock::draw(cairo_t* cairo, Point first_baseline, std::size_t first, std::size_t last) const {
  cairo_set_source_rgb(cairo, colour_.r, colour_.g, colour_.b);
  for (std::size_t k = first; k < std::min(last, lines().size()); ++k) {
    const double y = first_baseline.y + lines()[k].baseline - lines()[first].baseline;
    cairo_move_to(cairo, first_baseline.x, y);
    pango_cairo_show_layout_line(cairo, pango_layout_get_line_readonly(set_->layout.get(), static_cast<int>(k)));
    for (const Bar& bar : set_->bars) {
      if (bar.line != k) continue;
      cairo_rectangle(cairo, first_baseline.x + bar.left, y - bar.above_baseline, bar.right - bar.left, bar.thickness);
      cairo_fill(cairo);
    }
  }
}

}  // namespace axiometry::report::pdf
