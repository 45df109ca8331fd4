// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/devices/error_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "axiometry/base/read_budget.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/series/approaches.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/text_source.h"
#include "axiometry/formats/text/units.h"

namespace axiometry::formats {
namespace {

Result<NamedTest> named_test(const ErrorCurve& curve) {
  const ReadingRule rule{Measured::deviation, find_unit("mm")};
  std::vector<ListedReading> approaches;
  for (const ErrorPoint& point : curve.points) {
    const Position target = Position::native(point.position_mm);
    AXIOMETRY_TRY(const double deviation, placed(native_deviation(rule, target, point.error_mm), point.at));
    approaches.push_back({.target = target, .deviation = Deviation::native(deviation), .at = point.at});
  }
  AXIOMETRY_TRY(GatheredSeries result, placed(gathered(approaches), {curve.line, 1}));
  Metadata metadata;
  metadata.axis.name = curve.axis;
  metadata.conditions.comment = fmt::format("Error table {}, no measured approaches", curve.name);
  return NamedTest{
      curve.name,
      curve.line,
      std::move(metadata),
      std::move(result.series),
      {{true, fmt::format("found the error table {}, expected measured approaches; its values stand under ↑ with the "
                          "sign found",
                          curve.name)}}};
}

Result<Test> only_test(const std::vector<ErrorCurve>& curves) {
  if (curves.empty()) return fail("found no positioning error of a linear axis, expected one of EXX, EYY and EZZ");
  if (curves.size() > 1) {
    std::string names;
    for (const ErrorCurve& curve : curves) names += fmt::format("{}{}", names.empty() ? "" : ", ", curve.name);
    return fail(fmt::format("found {} positioning errors ({}), expected one test", curves.size(), names),
                {curves[1].line, 1});
  }
  AXIOMETRY_TRY(NamedTest named, named_test(curves.front()));
  Test test{std::move(named.metadata), std::move(named.series), Provenance{}};
  test.provenance.remarks = std::move(named.remarks);
  return test;
}

Result<std::string> all_bytes(ByteReader& bytes) {
  constexpr std::size_t block = std::size_t{64} << 10;
  std::string all;
  while (true) {
    const std::size_t filled = all.size();
    all.resize(filled + block);
    AXIOMETRY_TRY(const std::size_t count, bytes.read({all.data() + filled, block}));
    all.resize(filled + count);
    if (count == 0) return all;
    if (all.size() > read_budget::file_bytes)
      return fail(fmt::format("found a table of errors beyond {} MiB, expected less", read_budget::file_bytes >> 20));
  }
}

}  // namespace

std::string axis_of_error(std::string_view name) {
  for (std::string_view axis : {"X", "Y", "Z"})
    if (text::equal_ignoring_case(name, fmt::format("E{0}{0}", axis))) return std::string(axis);
  return {};
}

std::string_view without_comment(std::string_view line) { return text::trim(line.substr(0, line.find("//"))); }

Result<Test> read_curve(std::string_view bytes, CurvesOf& curves_of) {
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  AXIOMETRY_TRY(const std::vector<ErrorCurve> curves, curves_of(decoded.text));
  AXIOMETRY_TRY(Test test, only_test(curves));
  std::ranges::move(encoding_remarks(decoded), std::back_inserter(test.provenance.remarks));
  return test;
}

Result<void> read_curves(ByteReader& bytes, const NamedTestSink& sink, CurvesOf& curves_of) {
  AXIOMETRY_TRY(const std::string all, all_bytes(bytes));
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(all));
  AXIOMETRY_TRY(const std::vector<ErrorCurve> curves, curves_of(decoded.text));
  for (const ErrorCurve& curve : curves) {
    AXIOMETRY_TRY(NamedTest named, named_test(curve));
    std::ranges::move(encoding_remarks(decoded), std::back_inserter(named.remarks));
    AXIOMETRY_TRY_VOID(sink(std::move(named)));
  }
  return {};
}

}  // namespace axiometry::formats
