// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "axiometry/app/workbench/calibrations/calibrations.h"

namespace axiometry::app {
namespace {

using json::Kind;
using json::Value;
using store::KeptFigure;

std::optional<double> number_of(const Value& object, std::string_view name) {
  const Value* value = object.is(Kind::object) ? object.find(name) : nullptr;
  if (value == nullptr || !value->is(Kind::number)) return std::nullopt;
  return value->number();
}

/// The node where the amount is largest, with the uncertainty there; nothing where the lengths do not tell the curve.
std::optional<KeptFigure> largest_of(const std::string& error, const Value& nodes, const std::string& unit) {
  std::optional<KeptFigure> largest;
  for (const Value& node : nodes.items()) {
    const auto value = number_of(node, "value");
    if (!value || (largest && std::abs(*value) <= largest->value)) continue;
    largest = KeptFigure{error, "", std::abs(*value), number_of(node, "u"), unit};
  }
  return largest;
}

/// Of error motions the second letter is of the axis that moves along (X, Y, Z) or turns (A, B, C) after ISO 230-1.
std::string unit_of(const std::string& error) {
  return error.size() == 3 && error[1] >= 'X' && error[1] <= 'Z' ? "um" : "urad";
}

/// Figures of a list, and of the 21 errors the largest amount of each curve and the squareness.
std::vector<KeptFigure> compared_figures(const KeptCalibration& kept) {
  std::vector<KeptFigure> figures = kept.calibration.value.figures;
  const Value* errors = kept.result.is(Kind::object) ? kept.result.find("errors") : nullptr;
  if (kept.calibration.value.kind != "volumetric" || errors == nullptr || !errors->is(Kind::object)) return figures;
  for (const auto& [error, told] : errors->members()) {
    if (told.is(Kind::array)) {
      if (auto largest = largest_of(error, told, unit_of(error))) figures.push_back(*std::move(largest));
    } else if (const auto value = number_of(told, "value")) {
      figures.push_back({error, "", *value, number_of(told, "u"), "urad"});
    }
  }
  return figures;
}

std::vector<ComparedFigure> compared(const std::vector<KeptFigure>& before, const std::vector<KeptFigure>& after) {
  std::vector<ComparedFigure> rows;
  const auto row_of = [&](const KeptFigure& figure) -> ComparedFigure& {
    const auto found = std::ranges::find_if(rows, [&](const ComparedFigure& row) {
      return row.parameter == figure.parameter && row.of == figure.of && row.unit == figure.unit;
    });
    if (found != rows.end()) return *found;
    return rows.emplace_back(ComparedFigure{figure.parameter, figure.of, figure.unit, {}, {}, {}, {}});
  };
  for (const KeptFigure& figure : before) {
    ComparedFigure& row = row_of(figure);
    row.before = figure.value;
    row.before_u = figure.u;
  }
  for (const KeptFigure& figure : after) {
    ComparedFigure& row = row_of(figure);
    row.after = figure.value;
    row.after_u = figure.u;
  }
  return rows;
}

}  // namespace

Result<CalibrationComparison> compare_calibrations(const store::Store& archive, store::Id before, store::Id after) {
  AXIOMETRY_TRY(KeptCalibration first, kept_calibration(archive, before));
  AXIOMETRY_TRY(KeptCalibration second, kept_calibration(archive, after));
  if (first.calibration.value.kind != second.calibration.value.kind)
    return fail(fmt::format("found calibrations of the kinds {} and {}, expected two of the same",
                            first.calibration.value.kind, second.calibration.value.kind));
  auto rows = compared(compared_figures(first), compared_figures(second));
  return CalibrationComparison{std::move(first), std::move(second), std::move(rows)};
}

}  // namespace axiometry::app
