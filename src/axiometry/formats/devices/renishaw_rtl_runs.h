// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/test.h"

namespace axiometry::formats {

/// One line of a file in the layout of Renishaw's laser software: run, target, deviation.
struct RtlReading {
  std::size_t run = 0;     ///< one way, from 1
  std::size_t target = 0;  ///< number in the order of the list of targets, from 1
  double value = 0.0;      ///< deviation in the unit of the file
  TextPosition at;
};

/// The largest run number.
std::size_t rtl_run_count(std::span<const RtlReading> rows);

/// How the runs of a file are to be taken, and what must be told about it.
struct RtlRunRule {
  bool one_way = false;        ///< every run goes along the list
  std::vector<bool> absent{};  ///< whether a run is filled with zeros and was never measured
  std::vector<SourceRemark> remarks{};
};

/// Odd runs go along the list of targets, even ones return. The order of the rows within a run must confirm it; where
/// it does not, the flags of the file decide (`unidirectional`). Fails, with the place, on a run that contradicts its
/// number when the flags do not explain it.
Result<RtlRunRule> rtl_run_rule(std::span<const RtlReading> rows, std::optional<bool> unidirectional);

}  // namespace axiometry::formats
