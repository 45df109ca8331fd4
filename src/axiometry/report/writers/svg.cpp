// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/drawing/svg.h"

#include <fmt/format.h>

#include "axiometry/report/drawing/html_text.h"
#include "axiometry/report/drawing/picture.h"
#include "axiometry/report/translated.h"
#include "axiometry/report/writer.h"

namespace axiometry::report {
namespace svg {
namespace {

std::string file(const Figure& figure) { return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + to_svg(figure); }

/// For programs, which find it where SVG has a place for it; the drawing stays as it was.
std::string with_trail_head(std::string svg, const std::string& head) {
  constexpr std::string_view end = "</desc>\n";
  const std::size_t at = svg.find(end);
  if (head.empty() || at == std::string::npos) return svg;
  return svg.insert(at + end.size(),
                    fmt::format("<metadata>{}: {}</metadata>\n", trail_head_name, html::escaped(head)));
}

Result<std::string> write(const Subject& subject, const Options& options) {
  return with_trail_head(file(picture(subject, options)), subject.trail_head);
}

Result<std::string> set(const Document& document, const Options& options) {
  return file(picture(translated(document, options)));
}

}  // namespace
}  // namespace svg

extern const Writer svg_writer;
const Writer svg_writer = {
    .extension = "svg",
    .title = "All figures as one scalable drawing, for word processors and drawing programs",
    .write = svg::write,
    .set = svg::set,
};

}  // namespace axiometry::report
