// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "axiometry/store/database/connection.h"
#include "axiometry/store/records.h"

/// Lists that lie as JSON in a column: what calibrations and compensations have of the same kind.
namespace axiometry::store {

std::string files_text(const std::vector<KeptFile>& files);
std::string figures_text(const std::vector<KeptFigure>& figures);

/// Of what the functions above write; fail with `damaged` on anything else, saying whose it is.
Result<std::vector<KeptFile>> kept_files(const std::string& text, std::string_view whose);
Result<std::vector<KeptFigure>> kept_figures(const std::string& text, std::string_view whose);

Result<void> check_options(const std::string& options);              ///< fails unless they are a JSON object
Result<void> check_figures(const std::vector<KeptFigure>& figures);  ///< fails on one without a number
Result<void> check_files(Connection& connection, const std::vector<KeptFile>& files);  ///< fails where any is missing

}  // namespace axiometry::store
