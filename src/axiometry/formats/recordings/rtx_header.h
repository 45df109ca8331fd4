// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/axis.h"

/// The beginning of a Renishaw `.rtx` (dynamic) recording. Known from two programs that read it, not from its maker.
namespace axiometry::formats {

struct RtxHeader {
  std::size_t data_at = 0;    ///< byte where the numbers begin
  std::uint64_t samples = 0;  ///< "Sample no"
  double rate_hz = 0.0;       ///< "Actual sample rate"; "Sample rate" where that is not stated
  bool rate_is_actual = true;
  std::optional<double> trigger_interval;  ///< as stated; that of time is 1/rate
  std::string owner, version, file_type, machine, serial_number, date, by, axis, location;
};

/// Nothing while the header is not complete. Fails on what is none, on one of more than 64 KiB, and on a number of
/// samples or a rate that is missing or none.
Result<std::optional<RtxHeader>> rtx_header(std::string_view bytes);

/// Of which kind of axis its file type says that it is, where that is told by a word: numbers are in mm or in mrad.
std::optional<AxisKind> rtx_kind(const RtxHeader& header);

/// What the header tells that no sample does, as sentences.
std::vector<std::string> rtx_remarks(const RtxHeader& header);

}  // namespace axiometry::formats
