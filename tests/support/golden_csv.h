// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::testing_support {

/// The rows of a table of numbers below tests/golden/, without its heading.
inline std::vector<std::vector<double>> golden_rows(const std::string& name) {
  std::ifstream file(std::string(AXIOMETRY_SOURCE_DIR) + "/tests/golden/" + name);
  if (!file) throw std::runtime_error(name + " is not there");
  std::vector<std::vector<double>> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::vector<double>& row = rows.emplace_back();
    for (std::string_view cell : text::split(line, ',')) row.push_back(parse_number(cell).value());
  }
  return rows;
}

}  // namespace axiometry::testing_support
