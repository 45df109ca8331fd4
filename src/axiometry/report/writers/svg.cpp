// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/svg.h"

#include "axiometry/report/picture.h"
#include "axiometry/report/writer.h"

namespace axiometry::report {
namespace {

Result<std::string> write(const Subject& subject, const Options& options) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + to_svg(picture(subject, options));
}

}  // namespace

extern const Writer svg_writer;
const Writer svg_writer = {
    .extension = "svg",
    .title = "All figures as one scalable drawing, for word processors and drawing programs",
    .write = write,
};

}  // namespace axiometry::report
