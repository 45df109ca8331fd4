// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/metadata.h"
#include "axiometry/model/motion_series.h"

/// What `axiometry straightness`, `angles` and `squareness` write as JSON (docs/results.md), as far as a model of the
/// machine is made from it.
namespace axiometry::formats {

/// One evaluated error motion: means over its runs, of both directions where there are two.
struct MotionResult {
  std::optional<MotionName> error;
  std::optional<ReadingSense> sense;  ///< which way the readings were positive; the numbers are turned already
  MotionUnit unit = MotionUnit::um;
  std::string reference;  ///< "least-squares", "end-points", "none"
  std::size_t runs = 1;
  bool has_up = false, has_down = false;
  std::vector<double> positions_mm;  ///< ascending
  std::vector<double> means;
  std::vector<double> halves;        ///< half of up less down at each position, of both directions, else empty
  std::vector<double> s_up, s_down;  ///< scatter over the runs; empty with one run, or without that direction
  std::optional<double> instrument_U, instrument_U_per_m;  ///< k = 2, in `unit`; both or none
  std::vector<std::string> remarks;
  std::vector<Equipment> equipment;  ///< equipment of its metadata, as far as named
};

/// The location error of a squareness: C0Y, B0Z or A0Z with what is known of its uncertainty.
struct LocationResult {
  std::string name;
  double urad = 0.0;
  std::optional<double> k;                               ///< absent where nothing tells an uncertainty
  double u_scatter_urad = 0.0, u_instrument_urad = 0.0;  ///< 0 where none is told
};

struct MotionResults {
  std::string result;                 ///< "straightness", "angles", "squareness"
  std::vector<MotionResult> motions;  ///< its motions; of squareness the two lines, the first one first
  std::optional<LocationResult> location;
  std::optional<double> square_error_arcsec, square_U_arcsec;
};

/// Whether the bytes begin as JSON does, which no table of readings can.
bool looks_like_motion_result(std::string_view bytes);

/// Fails, with line and column, on JSON that is none of these results, on members that are missing or of another kind,
/// on lists of different lengths, fewer than two positions, positions that do not ascend. Time grows with the bytes.
Result<MotionResults> read_motion_result(std::string_view bytes);

}  // namespace axiometry::formats
