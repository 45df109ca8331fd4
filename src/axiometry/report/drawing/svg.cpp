// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/drawing/svg.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "axiometry/base/contract.h"
#include "axiometry/report/drawing/text_layout.h"
#include "axiometry/report/drawing/utf8.h"

namespace axiometry::report {
namespace {

constexpr std::string_view css_font_family = "Liberation Sans,Arial,Helvetica,sans-serif";

/// Hundredths of a point without trailing zeros: a hundredth is finer than any printer's dot.
void put_number(std::string& out, double x) {
  AXIOMETRY_CONTRACT(std::isfinite(x) && std::abs(x) < 1e9);
  const long long hundredths = std::llround(x * 100.0);
  const long long magnitude = std::abs(hundredths);
  if (hundredths < 0) out += '-';
  char digits[24];
  const auto end = std::to_chars(digits, digits + sizeof digits, magnitude / 100).ptr;
  const bool no_integer_part = magnitude < 100 && magnitude > 0;
  if (!no_integer_part) out.append(digits, end);
  if (const long long fraction = magnitude % 100; fraction != 0) {
    out += '.';
    out += static_cast<char>('0' + fraction / 10);
    if (fraction % 10 != 0) out += static_cast<char>('0' + fraction % 10);
  }
}

void put_point(std::string& out, Point p) {
  put_number(out, p.x);
  out += ' ';
  put_number(out, p.y);
}

void put_attribute(std::string& out, std::string_view name, double value) {
  out += ' ';
  out += name;
  out += "=\"";
  put_number(out, value);
  out += '"';
}

void put_escaped(std::string& out, std::string_view text) {
  for (const char c : printable(text)) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  }
}

/// fill="#0072b2" fill-opacity=".1", or the same for the stroke.
void put_colour(std::string& out, std::string_view name, const Colour& colour) {
  out += ' ';
  out += name;
  if (colour.alpha <= 0.0) {
    out += "=\"none\"";
    return;
  }
  out += "=\"#";
  constexpr std::string_view hexadecimal = "0123456789abcdef";
  for (const double share : {colour.r, colour.g, colour.b}) {
    const auto byte = static_cast<std::size_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
    out += hexadecimal[byte / 16];
    out += hexadecimal[byte % 16];
  }
  out += '"';
  if (colour.alpha < 1.0) put_attribute(out, std::string(name) + "-opacity", colour.alpha);
}

void put_stroke(std::string& out, const Stroke& stroke) {
  if (stroke.width <= 0.0) return;
  put_colour(out, "stroke", stroke.colour);
  put_attribute(out, "stroke-width", stroke.width);
  if (stroke.dashes.empty()) return;
  out += " stroke-dasharray=\"";
  for (std::size_t k = 0; k < stroke.dashes.size(); ++k) {
    if (k > 0) out += ' ';
    put_number(out, stroke.dashes[k]);
  }
  out += '"';
}

void put_path(std::string& out, const Path& path) {
  if (path.points.empty()) return;
  out += "<path d=\"M";
  for (std::size_t k = 0; k < path.points.size(); ++k) {
    if (k > 0) out += 'L';
    put_point(out, path.points[k]);
  }
  if (path.closed) out += 'Z';
  out += '"';
  put_colour(out, "fill", path.fill);
  put_stroke(out, path.stroke);
  out += "/>\n";
}

void put_circle(std::string& out, const Disc& disc) {
  out += "<circle";
  put_attribute(out, "cx", disc.centre.x);
  put_attribute(out, "cy", disc.centre.y);
  put_attribute(out, "r", disc.radius);
  put_colour(out, "fill", disc.fill);
  put_stroke(out, disc.stroke);
  out += "/>\n";
}

bool same_dot(const Disc& a, const Disc& b) {
  return a.radius == b.radius && a.fill == b.fill && a.stroke.width == 0.0 && b.stroke.width == 0.0;
}

/// Plain dots of one look as one path of round points: a tenth of the bytes of a circle each.
void put_dots(std::string& out, std::span<const Operation> dots) {
  out += "<path d=\"";
  for (const Operation& dot : dots) {
    out += 'M';
    put_point(out, std::get<Disc>(dot).centre);
    out += "h0";
  }
  const Disc& look = std::get<Disc>(dots.front());
  out += "\" fill=\"none\" stroke-linecap=\"round\"";
  put_stroke(out, {.colour = look.fill, .width = 2.0 * look.radius, .dashes = {}});
  out += "/>\n";
}

void put_run(std::string& out, const PlacedRun& placed, double size, double previous_rise) {
  const TextRun& run = *placed.run;
  const bool plain = !run.italic && !run.bold && placed.size == size && placed.rise == previous_rise;
  if (!plain) {
    out += "<tspan";
    if (placed.rise != previous_rise) put_attribute(out, "dy", previous_rise - placed.rise);
    if (placed.size != size) put_attribute(out, "font-size", placed.size);
    if (run.italic) out += " font-style=\"italic\"";
    if (run.bold) out += " font-weight=\"bold\"";
    out += '>';
  }
  put_escaped(out, run.text);
  if (!plain) out += "</tspan>";
}

/// Rotation about the label's point, for the text and its bars.
void put_rotation(std::string& out, const Text& text) {
  out += " transform=\"rotate(";
  put_number(out, -text.degrees);
  out += ' ';
  put_point(out, text.at);
  out += ")\"";
}

void put_text(std::string& out, const Text& text) {
  const TextLayout layout = lay_out(text);
  out += "<text";
  put_attribute(out, "x", text.at.x);
  put_attribute(out, "y", text.at.y);
  put_attribute(out, "font-size", text.size);
  if (text.anchor == Anchor::middle) out += " text-anchor=\"middle\"";
  if (text.anchor == Anchor::end) out += " text-anchor=\"end\"";
  put_colour(out, "fill", text.colour);
  if (text.degrees != 0.0) put_rotation(out, text);
  out += '>';
  double rise = 0.0;
  for (const PlacedRun& placed : layout.runs) {
    put_run(out, placed, text.size, rise);
    rise = placed.rise;
  }
  out += "</text>\n";
  const double start = text.at.x + anchor_shift(text.anchor, layout.width);
  for (const PlacedBar& bar : layout.bars) {
    out += "<path d=\"M";
    put_point(out, {start + bar.x, text.at.y - bar.rise});
    out += 'h';
    put_number(out, bar.width);
    out += '"';
    put_stroke(out, {.colour = text.colour, .width = bar.thickness, .dashes = {}});
    if (text.degrees != 0.0) put_rotation(out, text);
    out += "/>\n";
  }
}

void put_opening(std::string& out, const Figure& figure) {
  out += "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 ";
  put_point(out, {figure.width, figure.height});
  out += "\" width=\"";
  put_number(out, figure.width);
  out += "pt\" height=\"";
  put_number(out, figure.height);
  out += "pt\" font-family=\"";
  out += css_font_family;
  out += "\" stroke-linejoin=\"round\" xml:space=\"preserve\">\n<title>";
  put_escaped(out, figure.title);
  out += "</title>\n<desc>";
  put_escaped(out, figure.description);
  out += "</desc>\n";
}

}  // namespace

std::string to_svg(const Figure& figure) {
  std::string out;
  out.reserve(256 + 128 * figure.operations.size());
  put_opening(out, figure);
  const std::span<const Operation> operations = figure.operations;
  for (std::size_t k = 0; k < operations.size(); ++k) {
    if (const Path* path = std::get_if<Path>(&operations[k])) {
      put_path(out, *path);
    } else if (const Text* text = std::get_if<Text>(&operations[k])) {
      put_text(out, *text);
    } else {
      const Disc& disc = std::get<Disc>(operations[k]);
      std::size_t end = k + 1;
      while (end < operations.size() && std::holds_alternative<Disc>(operations[end]) &&
             same_dot(disc, std::get<Disc>(operations[end]))) {
        ++end;
      }
      if (end - k > 1 && disc.stroke.width == 0.0) {
        put_dots(out, operations.subspan(k, end - k));
        k = end - 1;
      } else {
        put_circle(out, disc);
      }
    }
  }
  out += "</svg>\n";
  return out;
}

}  // namespace axiometry::report
