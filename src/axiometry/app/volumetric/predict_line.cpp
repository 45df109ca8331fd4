// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/predict_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/results/named_findings_json.h"
#include "axiometry/app/volumetric/field_volume.h"
#include "axiometry/app/volumetric/predict_targets.h"
#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/rounded_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/report/volumetric.h"
#include "axiometry/volumetric/field/unseen_reasons.h"

namespace axiometry::app {
namespace {

using json::Value;
using volumetric::axis_count;
using volumetric::ErrorModel;
using volumetric::LineComparison;
using volumetric::MeasuredMeans;
using volumetric::TestedLine;

/// Below it a test and its prediction are said to disagree: 1 in 1000 by chance.
constexpr double departs_below = 1e-3;
/// A reversal that the errors do not hold and that makes E of the test so many times as large as was predicted is
/// serious: most machines have some.
constexpr double reversal_serious = 1.5;

/// The axis moves along the line: a place of its own is none.
Result<Vector3> parse_place(const std::string& text, std::size_t axis) {
  Vector3 place;
  std::array<bool, axis_count> given{};
  if (!text.empty())
    for (const std::string_view part : text::split(text, ',')) {
      const std::string_view trimmed = text::trim(part);
      const std::size_t letter =
          trimmed.empty() ? axis_count : std::string_view("xyzXYZ").find(trimmed.front()) % axis_count;
      const auto number = trimmed.size() > 2 && trimmed[1] == '=' ? parse_number(trimmed.substr(2)) : std::nullopt;
      if (std::string_view("xyzXYZ").find(trimmed.empty() ? ' ' : trimmed.front()) == std::string_view::npos || !number)
        return fail(fmt::format("found {}, expected where the other axes stand, as y=300,z=-250", text::quoted(text)));
      if (letter == axis)
        return fail(
            fmt::format("found a place of {} in {}, expected those of the other axes alone: {} moves along the "
                        "line",
                        "XYZ"[axis], text::quoted(text), "XYZ"[axis]));
      if (given[letter])
        return fail(fmt::format("found two places of {} in {}, expected one", "XYZ"[letter], text::quoted(text)));
      place[letter] = *number;
      given[letter] = true;
    }
  for (std::size_t a = 0; a < axis_count; ++a)
    if (a != axis && !given[a])
      return fail(fmt::format("found no place of {}, expected where the other axes stand, as y=300,z=-250", "XYZ"[a]));
  return place;
}

/// Whether plan or test say that they are of another axis: "Y", "y" or "Y1", where X was asked for or a diagonal.
Result<void> check_named(const PredictRequest& request, const TargetsOfFile& targets) {
  constexpr std::string_view axes = "XYZxyz";
  const std::string& name = targets.axis_name;
  if (request.axis.empty() && request.diagonal.empty()) return {};
  if (!request.diagonal.empty() && targets.line) return {};  // the line says more
  if (name.empty() || axes.find(name.front()) == std::string_view::npos) return {};
  if (!std::ranges::all_of(std::string_view(name).substr(1), [](char c) { return c >= '0' && c <= '9'; })) return {};
  const char letter = "XYZ"[axes.find(name.front()) % axis_count];
  if (request.axis == std::string_view(&letter, 1)) return {};
  return fail(fmt::format("found the axis {} in the plan or test, expected {}", text::quoted(name),
                          request.axis.empty() ? request.diagonal : request.axis));
}

/// "X" where that axis moves alone, which is a test after ISO 230-2.
std::string stated_name(const SpatialLine& line) {
  if (moving_axes(line) > 1) return "as stated";
  std::size_t axis = 0;
  while (axis + 1 < axis_count && std::abs(line.direction[axis]) < 0.5) ++axis;
  return std::string(1, "XYZ"[axis]);
}

/// An axis with a place is that very line. A diagonal goes through what was observed, and a plan of it through the
/// travel: that it is no other diagonal is enough. Which way it is run does not matter.
Result<void> check_same_line(const TestedLine& asked, const TestedLine& stated, bool is_axis) {
  constexpr double beside_mm = 1.0, aside_rad = 1e-3, like_rad = 0.1, like_share = 0.05;
  const Vector3 along = unit(asked.to_mm - asked.from_mm), own = unit(stated.to_mm - stated.from_mm);
  const auto beside = [&](Vector3 at) { return norm(cross(along, at - asked.from_mm)); };
  const double farthest = std::max(beside(stated.from_mm), beside(stated.to_mm)), turned = norm(cross(along, own));
  const double most = is_axis ? beside_mm : like_share * distance(asked.from_mm, asked.to_mm);
  if (turned <= (is_axis ? aside_rad : like_rad) && farthest <= most) return {};
  const auto text = [](Vector3 at) { return fmt::format("({:.1f}; {:.1f}; {:.1f})", at.x, at.y, at.z); };
  return fail(fmt::format(
      "found a line that is stated from {} to {} mm, up to {:.1f} mm beside {} from {} to {} mm, expected the same one",
      text(stated.from_mm), text(stated.to_mm), farthest, asked.name, text(asked.from_mm), text(asked.to_mm)));
}

Result<TestedLine> line_of(const PredictRequest& request, const ErrorModel& model, Vector3 tool_mm,
                           const std::optional<TargetsOfFile>& targets) {
  if (!request.axis.empty() && !request.diagonal.empty())
    return fail("found both an axis and a diagonal, expected one of them");
  std::optional<TestedLine> line;
  if (!request.axis.empty()) {
    const std::size_t axis = request.axis.size() == 1 ? std::string_view("XYZ").find(request.axis) : std::string::npos;
    if (axis >= axis_count)
      return fail(fmt::format("found the axis {}, expected X, Y or Z", text::quoted(request.axis)));
    AXIOMETRY_TRY(const Vector3 place, parse_place(request.at, axis));
    line = volumetric::axis_line(model, axis, place, tool_mm);
  } else if (!request.diagonal.empty()) {
    line = volumetric::diagonal_line(model, request.diagonal, tool_mm);
    if (!line) {
      std::string names;
      for (const std::string& name : volumetric::diagonal_names()) names += (names.empty() ? "" : ", ") + name;
      return fail(fmt::format("found the diagonal {}, expected one of {}", text::quoted(request.diagonal), names));
    }
  }
  if (request.axis.empty() && !request.at.empty())
    return fail(
        fmt::format("found where axes stand, {}, and no axis, expected both or none", text::quoted(request.at)));
  if (targets) {
    if (targets->positions_mm.size() < 2)
      return fail(fmt::format("found {}, expected two or more", counted(targets->positions_mm.size(), "target")));
    AXIOMETRY_TRY_VOID(check_named(request, *targets));
    const double first = targets->positions_mm.front(), last = targets->positions_mm.back();
    if (!line && !targets->line)
      return fail(
          "found no line in space in plan or test, expected an axis and where the others stand, or a "
          "diagonal");
    if (targets->line) {  // which says where the targets lie: what was asked for must be the same line
      const TestedLine stated{.name = line ? line->name : stated_name(*targets->line),
                              .from_mm = targets->line->at(Position::native(first)),
                              .to_mm = targets->line->at(Position::native(last)),
                              .tool_mm = tool_mm};
      if (line) AXIOMETRY_TRY_VOID(check_same_line(*line, stated, !request.axis.empty()));
      line = stated;
    } else {
      const Vector3 along = unit(line->to_mm - line->from_mm), origin = line->from_mm - line->first_mm * along;
      line->from_mm = origin + first * along;
      line->to_mm = origin + last * along;
    }
    line->first_mm = first;
    line->positions_mm = targets->positions_mm;
  }
  if (!line) return fail("found no line, expected an axis and where the others stand, or a diagonal");
  return *std::move(line);
}

Result<void> check_known(const ErrorModel& model, const TestedLine& line) {
  constexpr double slack_mm = 0.01;
  for (const Vector3& end : {line.from_mm, line.to_mm})
    for (std::size_t a = 0; a < axis_count; ++a) {
      const auto& basis = model.coefficients().basis(a);
      if (end[a] < basis.lower_mm() - slack_mm || end[a] > basis.upper_mm() + slack_mm)
        return fail(fmt::format(
            "found {} at {} mm on the line, expected it from {} to {} mm, where the errors are known", "XYZ"[a],
            format_exact(end[a]), format_exact(basis.lower_mm()), format_exact(basis.upper_mm())));
    }
  return {};
}

/// What errors without directions cannot show, where the test shows it; whether it does.
bool tell_reversal(PredictedTest& test) {
  const auto& reversal = test.comparison->reversal;
  if (!reversal || !(reversal->probability < departs_below)) return false;
  const double predicted = test.predicted.systematic.value;
  test.findings.push_back(
      {"volumetric-prediction-reversal", reversal->systematic_um > reversal_serious * predicted,
       fmt::format("the directions of the measured test differ by up to {:.2f} µm at {} mm, which the errors do not "
                   "hold: E of the test is {:.2f} µm, where {:.2f} µm is predicted for the mean of both directions",
                   reversal->largest_um, format_rounded(test.predicted.line.positions_mm[reversal->target], 3),
                   reversal->systematic_um, predicted)});
  return true;
}

/// Of a test that does not say where its line lies, offsets may be counted from elsewhere, or the other way.
Result<void> check_tool(const TargetsOfFile& targets, const volumetric::Tool& tool,
                        std::vector<NamedFinding>& findings) {
  constexpr double alike_mm = 1.0;
  if (!targets.offset_mm || distance(*targets.offset_mm, tool.offset_mm) <= alike_mm) return {};
  const auto text = [](Vector3 at) { return fmt::format("({:.1f}; {:.1f}; {:.1f})", at.x, at.y, at.z); };
  const std::string of_test = text(*targets.offset_mm), of_tool = text(tool.offset_mm);
  if (targets.line)
    return fail(fmt::format("found the tool point {} mm in the test, expected {} mm, that of the tool {}", of_test,
                            of_tool, text::quoted(tool.name)));
  findings.push_back({"volumetric-prediction-tool", false,
                      fmt::format("the test states the tool point {} mm, and the tool {} has {} mm: where both are "
                                  "counted alike, this is the prediction of another point",
                                  of_test, text::quoted(tool.name), of_tool)});
  return {};
}

/// Whether a test is so uncertain that a prediction of no error at all would stand too: that it agrees tells little.
bool fits_no_error(volumetric::PredictedLine predicted, const MeasuredMeans& means) {
  for (auto* values : {&predicted.up, &predicted.down})
    for (volumetric::Estimate& at : *values) at.value = 0.0;
  return volumetric::compare(predicted, means).probability >= departs_below;
}

void tell_comparison(PredictedTest& test, const MeasuredMeans& means) {
  const LineComparison& c = *test.comparison;
  const auto largest = static_cast<std::size_t>(
      std::ranges::max_element(c.normalised, {}, [](double x) { return std::abs(x); }) - c.normalised.begin());
  const double position = test.predicted.line.positions_mm[largest % test.predicted.up.size()];
  const std::string text = fmt::format(
      "χ² = {:.1f} with ν = {} ({}); the largest difference is {:.2f} µm at {} mm, {:.1f} of its standard "
      "uncertainties",
      c.chi_squared, c.degrees_of_freedom, format_chance(c.probability),
      c.measured_um[largest] - c.predicted_um[largest], format_rounded(position, 3), std::abs(c.normalised[largest]));
  const bool has_reversal = tell_reversal(test);
  if (c.probability < departs_below)
    test.findings.push_back({"volumetric-prediction-departs", true,
                             "the measured test departs from the prediction by more than chance: " + text});
  else
    test.findings.push_back(
        {"volumetric-prediction-agrees", false,
         (has_reversal ? "the measured test agrees with the prediction but for what its directions differ by: "
                       : "the measured test agrees with the prediction: ") +
             text});
  test.findings.push_back({"volumetric-prediction-scope", false,
                           "the comparison holds the uncertainty of the errors and the scatter of the test, but not "
                           "what all readings of the "
                           "test have in common, as its temperature or wavelength: that would appear as a slope"});
  if (c.probability >= departs_below && fits_no_error(test.predicted, means))
    test.findings.push_back({"volumetric-prediction-weak", false,
                             "the measured test would fit an axis without any error as well: it tells little of "
                             "whether the prediction is right"});
}

/// Serious findings of the comparison, not of the result that the prediction was made from.
bool is_of_comparison(const NamedFinding& finding) {
  return finding.serious &&
         (finding.id == "volumetric-prediction-departs" || finding.id == "volumetric-prediction-reversal");
}

}  // namespace

Result<PredictedTest> predict_test(const PredictRequest& request) {
  AXIOMETRY_TRY(KeptModel kept, kept_model(request.result));
  std::string measured_sha256;
  if (can_be_read_twice(request.measured)) {
    AXIOMETRY_TRY(const std::string measured, whole_file(request.measured));
    measured_sha256 = sha256(measured);
  }
  if (!measured_sha256.empty() && std::ranges::find(kept.made_from, measured_sha256) != kept.made_from.end())
    kept.against.push_back({"volumetric-prediction-same-file", false,
                            "the measured test is one that the errors were taken from: the comparison proves nothing"});
  AXIOMETRY_TRY(PredictedTest test, predict_test(std::move(kept), request));
  test.measured_sha256 = std::move(measured_sha256);
  return test;
}

Result<PredictedTest> predict_test(KeptModel kept, const PredictRequest& request) {
  const ErrorModel& model = kept.model;
  AXIOMETRY_TRY(const std::size_t tool, in_file(tool_of_model(model, request.tool), request.result));
  if (!request.plan.empty() && !request.measured.empty())
    return fail("found both a plan and a measured test, expected one of them: a test has its own targets");
  std::optional<TargetsOfFile> targets;
  std::vector<NamedFinding> findings;
  if (!request.plan.empty()) {
    AXIOMETRY_TRY(targets, targets_of_plan(request.plan));
  }
  if (!request.measured.empty()) {
    AXIOMETRY_TRY(targets, targets_of_test(request.measured));
    AXIOMETRY_TRY_VOID(in_file(check_tool(*targets, model.machine().tools[tool], findings), request.measured));
  }
  AXIOMETRY_TRY(TestedLine line, line_of(request, model, model.machine().tools[tool].offset_mm, targets));
  AXIOMETRY_TRY_VOID(check_known(model, line));
  auto predicted = volumetric::predict_line(model, std::move(line));
  if (!predicted)
    return fail(
        "found a line of which the readings do not tell all errors, expected one that they tell: see the "
        "findings of the result");
  if (!predicted->untold_reversals.empty())
    findings.push_back({"volumetric-prediction-means", false,
                        fmt::format("nothing tells by what the directions differ of {} on this line: what is predicted "
                                    "is the mean of both, without reversal",
                                    volumetric::error_list(predicted->untold_reversals))});
  PredictedTest test{request, std::move(kept.model), tool, *std::move(predicted), {}, {}};
  if (targets && targets->means) {
    test.comparison = volumetric::compare(test.predicted, *targets->means);
    tell_comparison(test, *targets->means);
  }
  std::ranges::move(findings, std::back_inserter(test.findings));
  std::ranges::stable_partition(test.findings, &NamedFinding::serious);
  put_first(kept.against, test.findings);
  test.result_sha256 = std::move(kept.sha256);
  return test;
}

Experiment present(const PredictedTest& test, const report::Options& options) {
  const std::string& tool = test.model.machine().tools[test.tool].name;
  Value root = Value::object();
  root.add("line", test.predicted.line.name);
  root.add("tool", tool);
  root.add("prediction", line_value(test.predicted));
  if (test.comparison) {
    const LineComparison& c = *test.comparison;
    Value& comparison = root.add("comparison", Value::object());
    comparison.add("chi2", c.chi_squared);
    comparison.add("degrees_of_freedom", c.degrees_of_freedom);
    comparison.add("probability", c.probability);
    comparison.add("agrees", std::ranges::none_of(test.findings, is_of_comparison));
    if (c.reversal) {
      Value& reversal = comparison.add("reversal", Value::object());
      reversal.add("largest_um", c.reversal->largest_um);
      reversal.add("position_mm", test.predicted.line.positions_mm[c.reversal->target]);
      reversal.add("systematic_um", c.reversal->systematic_um);
      reversal.add("chi2", c.reversal->chi_squared);
      reversal.add("degrees_of_freedom", c.reversal->degrees_of_freedom);
      reversal.add("probability", c.reversal->probability);
    }
    Value& items = comparison.add("targets", Value::array());
    const std::size_t m = test.predicted.up.size();
    for (std::size_t k = 0; k < c.measured_um.size(); ++k) {
      Value& item = items.push(Value::object());
      item.add("position_mm", test.predicted.line.positions_mm[k % m]);
      const Direction direction = c.direction.value_or(k < m ? Direction::up : Direction::down);
      item.add("direction", !c.by_direction && !c.direction ? "mean" : direction == Direction::up ? "up" : "down");
      item.add("measured_um", c.measured_um[k]);
      item.add("predicted_um", c.predicted_um[k]);
      item.add("normalised", c.normalised[k]);
    }
  }
  root.add("findings", findings_value(test.findings));
  std::vector<report::SourceFile> sources = {{"Result", test.request.result, test.result_sha256}};
  if (!test.request.measured.empty()) sources.push_back({"Measured test", test.request.measured, test.measured_sha256});
  return {report::compose(
              report::PredictedTestSubject{test.model, test.predicted, test.comparison, test.findings, tool, sources},
              options),
          std::move(root)};
}

}  // namespace axiometry::app
