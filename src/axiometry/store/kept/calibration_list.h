// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/store/records.h"

/// What is found of calibrations.
namespace axiometry::store {

class Connection;

struct CalibrationFilter {
  std::string text;  ///< each word in title, notes, file or machine name; any case
  std::string kind;  ///< empty: of any
  std::optional<Id> machine{};
  std::optional<Id> instrument{};
  std::string measured_from{};  ///< dates, both included
  std::string measured_to{};
  bool withdrawn = false;  ///< show withdrawn ones too
  enum class Order { received, measured, title } order = Order::received;
  bool descending = true;
  std::int64_t offset = 0;
  std::int64_t limit = 50;  ///< most records, at most largest_page
};

/// One line of a list: its result is not read for it.
struct CalibrationRow {
  Versioned<CalibrationRecord> calibration;  ///< the latest version
  std::string received_at;             ///< time of the first version
  std::string machine_name;            ///< as it is called now; empty without a machine
};

struct CalibrationPage {
  std::vector<CalibrationRow> rows;
  std::int64_t total = 0;  ///< number without limit and offset
};

/// Reads a line of every calibration that the filter's columns fit. Ties are broken by arrival.
Result<CalibrationPage> find_calibrations(Connection& connection, const CalibrationFilter& filter);

}  // namespace axiometry::store
