// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "axiometry/app/files/reader.h"
#include "axiometry/base/json/json.h"

/// Results in the language of their reader, those just made as well as those that the archive keeps.
namespace axiometry::app {

/// What a result is of, as docs/results.md tells their members.
enum class ResultKind {
  test,                 ///< a test of one axis
  lines,                ///< a plan's lines
  motions,              ///< straightness, angles, squareness
  periodic,             ///< a periodic positioning error
  dynamic,              ///< a recording without standstills
  volumetric,           ///< the 21 errors of a machine, from lengths or measured singly
  coordinates,          ///< points from lengths, or from lengths with angles
  volumetric_plan,      ///< what a set-up is expected to tell
  field_difference,     ///< two fields, before and after
  compensation,         ///< a table of a control, from a test or from the 21 errors
  control,              ///< what is known of a control
  findings_beside_all,  ///< any other, whose sentences are those of its findings
  findings,             ///< a list of them
};

/// Contract: one of store::calibration_kinds.
ResultKind result_kind_of_calibration(std::string_view kind);

/// The result with the program's sentences and titles in the reader's language. Where they stand in a result is said
/// by place, one list for each kind; every other text stays as it is: names, keys, what users wrote, and members that
/// no result has.
json::Value localised_result(const json::Value& result, ResultKind kind, const Reader& reader);

}  // namespace axiometry::app
