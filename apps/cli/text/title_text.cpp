// SPDX-License-Identifier: Apache-2.0
#include "cli/text/title_text.h"

#include "axiometry/report/translated.h"
#include "axiometry/standards/test_standard.h"

namespace axiometry::cli {

std::string title_text(const Axis& axis, const std::string& machine, const report::Options& options) {
  std::string title = report::translated(title_of(axis), options);
  if (axis.name.empty()) title += " (" + report::translated("not named", options) + ")";
  if (machine.empty()) return title;
  return title + (options.language == language::Language::english ? " of " : ", ") + machine;
}

}  // namespace axiometry::cli
