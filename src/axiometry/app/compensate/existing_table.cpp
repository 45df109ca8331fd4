// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/compensate/existing_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "axiometry/base/text/rounded_text.h"
#include "axiometry/nc/numbers.h"

namespace axiometry::app {
namespace {

constexpr double beside = 1e-3;  // mm or °: what positions in a file may lie beside targets

struct Stretch {
  double low = 0.0, high = 0.0;
};

/// What two stretches have in common, of what they cover together.
double common_share(Stretch a, Stretch b) {
  const double common = std::min(a.high, b.high) - std::max(a.low, b.low);
  const double covered = std::max(a.high, b.high) - std::min(a.low, b.low);
  return covered > 0.0 ? std::max(0.0, common) / covered : 0.0;
}

Stretch stretch_of(const std::vector<double>& positions, double scale = 1.0) {
  return {scale * positions.front(), scale * positions.back()};
}

Stretch stretch_of(const Series& series) {
  return {series.targets().front().in_native(), series.targets().back().in_native()};
}

}  // namespace

Result<void> check_unit_of_length(const AxisCorrection& existing, const Series& series, bool in_inch) {
  if (existing.kind() != AxisKind::linear) return {};
  constexpr double little = 0.2, most = 0.5;
  const Stretch targets = stretch_of(series);
  const double scale = in_inch ? 1.0 / nc::mm_per_inch : nc::mm_per_inch;
  const Stretch as_read = stretch_of(existing.positions()), otherwise = stretch_of(existing.positions(), scale);
  if (common_share(as_read, targets) >= little || common_share(otherwise, targets) <= most) return {};
  return fail(
      fmt::format("found a table from {} to {} mm where the targets go from {} to {} mm, which it would fit in {}: "
                  "expected it in {}, as the table to make, or the unit of the existing table stated",
                  format_rounded(as_read.low), format_rounded(as_read.high), format_rounded(targets.low),
                  format_rounded(targets.high), in_inch ? "mm" : "inches", in_inch ? "inches" : "mm"));
}

Result<AxisCorrection> without_lead_to(LeadOn lead, AxisCorrection existing, const Series& series) {
  const std::vector<double>& positions = existing.positions();
  const Stretch targets = stretch_of(series), table = stretch_of(positions);
  const bool turns = existing.kind() == AxisKind::rotary && table.high - table.low > 360.0 - beside;
  if (positions.size() < 2 || turns) return existing;
  const double step = positions[1] - positions[0];
  const auto is_alike = [&](std::size_t a, std::size_t b) {
    return existing.values(Direction::up)[a] == existing.values(Direction::up)[b] &&
           existing.values(Direction::down)[a] == existing.values(Direction::down)[b];
  };
  std::size_t first = 0, last = positions.size() - 1;
  const auto leads_up = [&](std::size_t k) {
    return positions[k] <= lead.reference + step + beside ||
           (lead.over_targets && positions[k - 1] <= targets.high + beside);
  };
  const auto leads_down = [&](std::size_t k) {
    return positions[k] >= lead.reference - beside || (lead.over_targets && positions[k + 1] >= targets.low - beside);
  };
  while (last > first + 1 && positions[last] > targets.high + beside && leads_up(last) && is_alike(last, last - 1))
    --last;
  while (first + 1 < last && positions[first] < targets.low - beside && leads_down(first) && is_alike(first, first + 1))
    ++first;
  const auto part = [&](const std::vector<double>& all) {
    return std::vector(all.begin() + static_cast<std::ptrdiff_t>(first),
                       all.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  };
  return AxisCorrection::make(existing.kind(), part(positions), part(existing.values(Direction::up)),
                              part(existing.values(Direction::down)));
}

Result<void> check_over_targets(const AxisCorrection& existing, const Series& series) {
  const Stretch table = stretch_of(existing.positions()), targets = stretch_of(series);
  const bool turns = existing.kind() == AxisKind::rotary && table.high - table.low > 360.0 - beside;
  if (turns || (table.low <= targets.low + beside && table.high >= targets.high - beside)) return {};
  const std::string_view unit = position_unit(existing.kind());
  return fail(fmt::format(
      "found a table from {} to {} {} and targets from {} to {} {}: beyond its ends this control does not hold the "
      "last value but goes on to that of the other end; expected a table over all targets (where it has positions "
      "that it does not tell: '; range LOW to HIGH' in its head)",
      format_rounded(table.low), format_rounded(table.high), unit, format_rounded(targets.low),
      format_rounded(targets.high), unit));
}

Result<void> check_within_targets(const AxisCorrection& existing, const Series& series) {
  const Stretch table = stretch_of(existing.positions()), targets = stretch_of(series);
  if (table.low >= targets.low - beside && table.high <= targets.high + beside) return {};
  const std::string_view unit = position_unit(existing.kind());
  return fail(fmt::format(
      "found the existing table from {} to {} {}, beyond the targets from {} to {} {}: what it should "
      "become there nobody measured; expected the last value held beyond the targets, which changes it there "
      "as at the last target, or other positions of the new one",
      format_rounded(table.low), format_rounded(table.high), unit, format_rounded(targets.low),
      format_rounded(targets.high), unit));
}

Result<AxisCorrection> without_number_beside(const AxisCorrection& existing) {
  const std::vector<double>& curve = existing.values(Direction::up);
  return AxisCorrection::make(existing.kind(), existing.positions(), curve, curve);
}

std::optional<NamedFinding> finding_of_cut_table(const AxisCorrection& existing, const std::vector<double>& nodes) {
  const Stretch before = stretch_of(existing.positions()), now = stretch_of(nodes);
  if (now.low <= before.low + beside && now.high >= before.high - beside) return std::nullopt;
  const std::string_view unit = position_unit(existing.kind());
  return NamedFinding{
      "compensation-existing-cut", true,
      fmt::format("the table that was active goes from {} to {} {}, the new one from {} to {} {}: beyond "
                  "its ends what the old one corrected is given up",
                  format_rounded(before.low), format_rounded(before.high), unit, format_rounded(now.low),
                  format_rounded(now.high), unit)};
}

}  // namespace axiometry::app
