// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "axiometry/report/document.h"

/// Parts of a composed report, to look at.
namespace axiometry::testing_support {

inline std::vector<std::string> section_ids(const report::Document& document) {
  std::vector<std::string> ids;
  for (const report::Section& section : document.sections) ids.push_back(section.id);
  return ids;
}

inline const report::Section& section(const report::Document& document, std::string_view id) {
  for (const report::Section& candidate : document.sections)
    if (candidate.id == id) return candidate;
  throw std::logic_error("no such section");
}

inline std::vector<report::Table> tables(const report::Section& section) {
  std::vector<report::Table> all;
  for (const report::Block& block : section.blocks)
    if (const auto* table = std::get_if<report::Table>(&block)) all.push_back(*table);
  return all;
}

}  // namespace axiometry::testing_support
