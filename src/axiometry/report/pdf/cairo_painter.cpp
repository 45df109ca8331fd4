// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/pdf/cairo_painter.h"

#include <cairo.h>
#include <pango/pangocairo.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "axiometry/report/drawing/text_layout.h"
#include "axiometry/report/drawing/utf8.h"

namespace axiometry::report {
namespace {

constexpr const char* pango_font_family = "Liberation Sans, Arial, Helvetica, Sans";

/// A run of another width than laid out (another face, or kerning) is squeezed or stretched; less than
/// this nobody sees, and kerned letters stay as they are.
constexpr double width_tolerance = 0.02;

/// A line of so many points covers itself again and again: four shades of a pixel's edge are as good there as 255, and
/// take a third of the time.
constexpr std::size_t dense_points = 500;

struct Unref {
  void operator()(PangoLayout* layout) const { g_object_unref(layout); }
  void operator()(PangoFontDescription* description) const { pango_font_description_free(description); }
  void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
};

using LayoutPointer = std::unique_ptr<PangoLayout, Unref>;
using DescriptionPointer = std::unique_ptr<PangoFontDescription, Unref>;
using FontOptionsPointer = std::unique_ptr<cairo_font_options_t, Unref>;

class Painter {
 public:
  explicit Painter(cairo_t* cairo) : cairo_(cairo) {}

  void operator()(const Path& path) {
    if (path.points.empty()) return;
    cairo_new_path(cairo_);
    for (const Point& p : path.points) cairo_line_to(cairo_, p.x, p.y);
    if (path.closed) cairo_close_path(cairo_);
    const bool is_dense = path.points.size() >= dense_points;
    cairo_set_antialias(cairo_, is_dense ? CAIRO_ANTIALIAS_FAST : CAIRO_ANTIALIAS_DEFAULT);
    fill_and_stroke(path.fill, path.stroke);
  }

  void operator()(const Disc& disc) {
    cairo_new_path(cairo_);
    cairo_arc(cairo_, disc.centre.x, disc.centre.y, disc.radius, 0.0, 2.0 * std::numbers::pi);
    cairo_close_path(cairo_);
    fill_and_stroke(disc.fill, disc.stroke);
  }

  void operator()(const Text& text) {
    const TextLayout layout = lay_out(text);
    cairo_save(cairo_);
    cairo_translate(cairo_, text.at.x, text.at.y);
    cairo_rotate(cairo_, -text.degrees * std::numbers::pi / 180.0);
    cairo_translate(cairo_, anchor_shift(text.anchor, layout.width), 0.0);
    set_source(text.colour);
    for (const PlacedRun& run : layout.runs) show(run);
    for (const PlacedBar& bar : layout.bars) {
      cairo_rectangle(cairo_, bar.x, -bar.rise - bar.thickness / 2.0, bar.width, bar.thickness);
      cairo_fill(cairo_);
    }
    cairo_restore(cairo_);
  }

 private:
  void set_source(const Colour& c) { cairo_set_source_rgba(cairo_, c.r, c.g, c.b, c.alpha); }

  void fill_and_stroke(const Colour& fill, const Stroke& stroke) {
    if (fill.alpha > 0.0) {
      set_source(fill);
      cairo_fill_preserve(cairo_);
    }
    if (stroke.width > 0.0 && stroke.colour.alpha > 0.0) {
      set_source(stroke.colour);
      cairo_set_line_width(cairo_, stroke.width);
      cairo_set_dash(cairo_, stroke.dashes.data(), static_cast<int>(stroke.dashes.size()), 0.0);
      cairo_stroke_preserve(cairo_);
    }
    cairo_new_path(cairo_);
  }

  void show(const PlacedRun& placed) {
    PangoLayout* layout = text_layout();
    const std::string text = printable(placed.run->text);
    pango_layout_set_text(layout, text.data(), static_cast<int>(text.size()));
    const DescriptionPointer description(pango_font_description_from_string(pango_font_family));
    pango_font_description_set_absolute_size(description.get(), placed.size * PANGO_SCALE);
    if (placed.run->italic) pango_font_description_set_style(description.get(), PANGO_STYLE_ITALIC);
    if (placed.run->bold) pango_font_description_set_weight(description.get(), PANGO_WEIGHT_BOLD);
    pango_layout_set_font_description(layout, description.get());

    PangoRectangle extent;
    pango_layout_get_extents(layout, nullptr, &extent);
    const double width = static_cast<double>(extent.width) / PANGO_SCALE;
    const double fit = width > 0.0 && placed.width > 0.0 ? placed.width / width : 1.0;
    cairo_save(cairo_);
    cairo_translate(cairo_, placed.x, -placed.rise);
    if (std::abs(fit - 1.0) > width_tolerance) cairo_scale(cairo_, fit, 1.0);
    cairo_move_to(cairo_, 0.0, -static_cast<double>(pango_layout_get_baseline(layout)) / PANGO_SCALE);
    pango_cairo_show_layout(cairo_, layout);
    cairo_restore(cairo_);
  }

  /// One layout serves all runs. Without hinting, so that glyphs stand where the metrics say.
  PangoLayout* text_layout() {
    if (!layout_) {
      layout_.reset(pango_cairo_create_layout(cairo_));
      const FontOptionsPointer options(cairo_font_options_create());
      cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
      cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
      cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
      PangoContext* context = pango_layout_get_context(layout_.get());
      pango_cairo_context_set_font_options(context, options.get());
      pango_context_set_round_glyph_positions(context, FALSE);
      pango_layout_set_single_paragraph_mode(layout_.get(), TRUE);
    }
    return layout_.get();
  }

  cairo_t* cairo_;
  LayoutPointer layout_;
};

}  // namespace

void paint(const Figure& figure, cairo_t* cairo) {
  cairo_save(cairo);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
  Painter painter(cairo);
  for (const Operation& operation : figure.operations) std::visit(painter, operation);
  cairo_restore(cairo);
}

}  // namespace axiometry::report
