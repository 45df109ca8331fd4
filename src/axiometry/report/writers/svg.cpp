// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/svg.h"

#include "axiometry/report/picture.h"
#include "axiometry/report/translated.h"
#include "axiometry/report/writer.h"

namespace axiometry::report {
namespace {

std::string file(const Figure& figure) { return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + to_svg(figure); }

Result<std::string> write(const Subject& subject, const Options& options) { return file(picture(subject, options)); }

Result<std::string> set(const Document& document, const Options& options) {
  return file(picture(translated(document, options)));
}

}  // namespace

extern const Writer svg_writer;
const Writer svg_writer = {
    .extension = "svg",
    .title = "All figures as one scalable drawing, for word processors and drawing programs",
    .write = write,
    .set = set,
};

}  // namespace axiometry::report
