// SPDX-License-Identifier: Apache-2.0
// A4 pages by Cairo and Pango. The same report gives the same bytes on one machine: the date of
// creation is that of the test, or left out.
#include <cairo-pdf.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "axiometry/report/documents/compose.h"
#include "axiometry/report/documents/pdf_document.h"
#include "axiometry/report/drawing/utf8.h"
#include "axiometry/report/pdf/pdf_palette.h"
#include "axiometry/report/translated.h"
#include "axiometry/report/writer.h"

namespace axiometry::report {

namespace pdf {
namespace {

using namespace pdf;

constexpr double running_size = 7.5;
constexpr double head_baseline = 40.0;
constexpr double foot_baseline = page_height - 32.0;
constexpr double program_baseline = foot_baseline + 10.0;  // a status may be as long as the line above

cairo_status_t append_bytes(void* closure, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void draw_at(cairo_t* cairo, const TextBlock& text, double x, double baseline) {
  text.draw(cairo, {x, baseline}, 0, 1);
}

/// A line of text at the left, another at the right end of the page.
void draw_running(cairo_t* cairo, const Typesetter& typesetter, const std::string& left, const std::string& right,
                  double baseline) {
  const TextStyle style{running_size, false, quiet};
  const TextBlock at_end = typesetter.set(plain(right), style);
  draw_at(cairo, typesetter.set(plain(left), style), margin_side, baseline);
  draw_at(cairo, at_end, margin_side + body_width - at_end.width(), baseline);
}

void draw_line(cairo_t* cairo, double y) {
  cairo_set_source_rgb(cairo, rule.r, rule.g, rule.b);
  cairo_rectangle(cairo, margin_side, y, body_width, 0.5);
  cairo_fill(cairo);
}

bool is_iso_date(std::string_view date) {
  constexpr std::string_view shape = "dddd-dd-dd";
  return date.size() == shape.size() &&
         std::ranges::equal(date, shape, [](char c, char s) { return s == 'd' ? c >= '0' && c <= '9' : c == s; });
}

void set_metadata(cairo_surface_t* surface, const Document& document) {
  const std::string title = cleaned(fmt::format("{} – {}", document.running_head, document.title));
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, title.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_SUBJECT, document.edition.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, document.generator.c_str());
}

/// Cairo writes the time of day as the date of creation (and 1.16 no valid one when told another). In
/// its place, without moving a byte behind it, goes the date of the test, or white space.
void settle_creation_date(std::string& bytes, std::string_view date) {
  const std::size_t start = bytes.rfind("/CreationDate (");
  const std::size_t end = start == std::string::npos ? start : bytes.find(')', start);
  if (end == std::string::npos) return;
  const std::string entry = is_iso_date(date) ? fmt::format("/CreationDate (D:{}{}{})", date.substr(0, 4),
                                                            date.substr(5, 2), date.substr(8, 2))
                                              : std::string();
  std::fill(bytes.begin() + start, bytes.begin() + end + 1, ' ');
  if (entry.size() <= end + 1 - start) bytes.replace(start, entry.size(), entry);
}

void draw_pages(cairo_surface_t* surface, cairo_t* cairo, const PageFlow& flow, const Document& document,
                const Typesetter& typesetter, const Options& options) {
  const std::size_t count = flow.pages().size();
  for (std::size_t page = 0; page < count; ++page) {
    for (const Bookmark& bookmark : flow.bookmarks())
      if (bookmark.page == page)
        cairo_pdf_surface_add_outline(
            surface, CAIRO_PDF_OUTLINE_ROOT, bookmark.title.c_str(),
            fmt::format("page={} pos=[{:.1f} {:.1f}]", page + 1, margin_side, bookmark.y).c_str(),
            CAIRO_PDF_OUTLINE_FLAG_OPEN);
    if (page > 0) {
      draw_running(cairo, typesetter, document.running_head, document.running_number, head_baseline);
      draw_line(cairo, head_baseline + 6.0);
    }
    for (const Drawing& drawing : flow.pages()[page]) draw(drawing, cairo);
    draw_line(cairo, foot_baseline - 12.0);
    draw_running(cairo, typesetter, document.running_status,
                 translated(fmt::format("Page {} of {}", page + 1, count), options), foot_baseline);
    draw_running(cairo, typesetter, document.generator, "", program_baseline);
    cairo_show_page(cairo);
  }
}

Result<std::string> drawn(const Document& document, const Options& options) {
  const Typesetter typesetter;
  const PageFlow flow = set_document(document, typesetter);
  std::string bytes;
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_pdf_surface_create_for_stream(&append_bytes, &bytes, page_width, page_height), &cairo_surface_destroy);
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo(cairo_create(surface.get()), &cairo_destroy);
  set_metadata(surface.get(), document);
  draw_pages(surface.get(), cairo.get(), flow, document, typesetter, options);
  cairo_surface_finish(surface.get());
  for (cairo_status_t status : {cairo_status(cairo.get()), cairo_surface_status(surface.get())})
    if (status != CAIRO_STATUS_SUCCESS)
      return fail(fmt::format("the PDF could not be drawn: {}", cairo_status_to_string(status)));
  settle_creation_date(bytes, document.date);
  return bytes;
}

Result<std::string> write(const Subject& subject, const Options& options) {
  return drawn(translated(compose(subject, options), options), options);
}

Result<std::string> set(const Document& document, const Options& options) {
  return drawn(translated(document, options), options);
}

}  // namespace
}  // namespace pdf

extern const Writer pdf_writer;
const Writer pdf_writer = {"pdf", "PDF, A4", &pdf::write, &pdf::set};

}  // namespace axiometry::report
