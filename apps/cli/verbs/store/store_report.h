// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "axiometry/app/files/output.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/app/workbench/workbench_values.h"
#include "axiometry/base/text/text.h"
#include "cli/failure.h"

/// Reports of what is kept, as --report asks for them.
namespace axiometry::cli {

/// "pdf" of "proof.PDF".
inline std::string report_extension(const std::string& file) {
  const std::string extension = text::to_lower(std::filesystem::path(file).extension().string());
  return extension.starts_with('.') ? extension.substr(1) : extension;
}

/// Refuses, before anything is changed, a name that no report is written to.
inline void check_report_name(const std::string& file) {
  if (file.empty() || app::media_type_of(report_extension(file)) != app::octets) return;
  throw UsageError("--report", fmt::format("found {}, expected a name that ends in .html, .pdf, .svg, .png or .csv",
                                           text::quoted(file)));
}

/// Nothing without a name. `report` makes it of an app::ReportRequest.
template <typename Report>
Result<void> write_report(const std::string& file, const Report& report) {
  if (file.empty()) return {};
  app::ReportRequest request;
  request.extension = report_extension(file);
  AXIOMETRY_TRY(const app::Rendered rendered, report(request));
  return app::write_file(file, rendered.bytes);
}

}  // namespace axiometry::cli
