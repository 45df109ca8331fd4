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

/// The curve as the only run under ↑. Fails, with the place, as gathered() does.
Result<NamedTest> named_test(const ErrorCurve& curve);

/// The only curve as a test with the remark that it was not measured by approaches. Fails when there are several,
/// naming them.
Result<Test> only_test(const std::vector<ErrorCurve>& curves);

/// Everything a reader of bytes has. Fails beyond 64 MiB: error tables are small.
Result<std::string> all_bytes(ByteReader& bytes);

}  // namespace axiometry::formats
