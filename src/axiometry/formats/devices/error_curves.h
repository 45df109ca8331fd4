// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "axiometry/formats/format.h"

/// Positioning errors of linear axes out of files of volumetric errors: E_XX, E_YY and E_ZZ (ISO 230-1:2012, 3.4.3).
namespace axiometry::formats {

struct ErrorPoint {
  double position_mm = 0.0;
  double error_mm = 0.0;
  TextPosition at;
};

/// One curve of a file.
struct ErrorCurve {
  std::string name;  ///< "EXX", "EXX Z=100"
  std::string axis;  ///< "X"
  std::size_t line = 0;
  std::vector<ErrorPoint> points;
};

/// "X" for "EXX", in any case; "" for the name of another error.
std::string axis_of_error(std::string_view name);

/// What stands before "//".
std::string_view without_comment(std::string_view line);

/// All curves in the text of a file.
using CurvesOf = Result<std::vector<ErrorCurve>>(std::string_view text);

/// Format::read of a file with one curve: the only run under ↑, with the remark that it was not measured by
/// approaches. Fails as `curves_of` does, when there are several curves, naming them, and, with the place, as
/// gathered() does.
Result<Test> read_curve(std::string_view bytes, CurvesOf& curves_of);

/// Format::read_many: every curve a test of its own. Fails likewise, and beyond 64 MiB: error tables are small.
Result<void> read_curves(ByteReader& bytes, const NamedTestSink& sink, CurvesOf& curves_of);

}  // namespace axiometry::formats
