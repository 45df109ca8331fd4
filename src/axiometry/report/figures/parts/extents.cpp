// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/extents.h"

#include <algorithm>

namespace axiometry::report::plot {
namespace {

using iso230_2::AxisParameters;
using iso230_2::Evaluation;
using iso230_2::PositionResult;

/// Of the deviation axis at one target.
struct DeviationSpan {
  double low = 0.0;
  double high = 0.0;
};

std::optional<DeviationSpan> mean_of(const PositionResult& p, Direction direction) {
  const auto value = mean(p, direction);
  if (!value) return std::nullopt;
  return DeviationSpan{value->in_native(), value->in_native()};
}

std::optional<DeviationSpan> band_of(const PositionResult& p, Direction direction) {
  auto span = mean_of(p, direction);
  if (!span) return std::nullopt;
  const double half = half_band(p, direction);
  return DeviationSpan{span->low - half, span->high + half};
}

/// The two means of a target, lower one first.
std::optional<DeviationSpan> reversal_of(const PositionResult& p) {
  if (!p.reversal) return std::nullopt;
  const auto [low, high] = std::minmax({p.mean_up->in_native(), p.mean_down->in_native()});
  return DeviationSpan{low, high};
}

/// 3.20: the widest of both bands and of the stretch from the upper mean's upper boundary to the lower
/// mean's lower boundary (which the wider band can exceed).
std::optional<DeviationSpan> repeatability_of(const PositionResult& p) {
  const auto up = band_of(p, Direction::up);
  const auto down = band_of(p, Direction::down);
  if (!up || !down) return up ? up : down;
  const bool up_is_upper = p.reversal->in_native() >= 0.0;
  const DeviationSpan across = up_is_upper ? DeviationSpan{down->low, up->high} : DeviationSpan{up->low, down->high};
  return std::max({across, *up, *down},
                  [](const DeviationSpan& a, const DeviationSpan& b) { return a.high - a.low < b.high - b.low; });
}

class Hull {
 public:
  void see(std::size_t target, const std::optional<DeviationSpan>& span) {
    if (!span) return;
    if (!extent_) extent_ = at(target, *span);
    if (span->low < extent_->low.in_native()) {
      extent_->low = Deviation::native(span->low);
      extent_->low_at = target;
    }
    if (span->high > extent_->high.in_native()) {
      extent_->high = Deviation::native(span->high);
      extent_->high_at = target;
    }
  }
  void see_wider(std::size_t target, const std::optional<DeviationSpan>& span) {
    if (span && (!extent_ || span->high - span->low > extent_->high.in_native() - extent_->low.in_native())) {
      extent_ = at(target, *span);
    }
  }
  std::optional<Extent> extent() const { return extent_; }

 private:
  static Extent at(std::size_t target, const DeviationSpan& span) {
    return {Deviation::native(span.low), Deviation::native(span.high), target, target};
  }
  std::optional<Extent> extent_;
};

using See = void (*)(Hull&, std::size_t, const PositionResult&);

struct Definition {
  Parameter parameter;
  See see;
};

constexpr Definition definitions[] = {
    {&AxisParameters::A,
     [](Hull& h, std::size_t i, const PositionResult& p) {
       h.see(i, band_of(p, Direction::up));
       h.see(i, band_of(p, Direction::down));
     }},
    {&AxisParameters::A_up,
     [](Hull& h, std::size_t i, const PositionResult& p) { h.see(i, band_of(p, Direction::up)); }},
    {&AxisParameters::A_down,
     [](Hull& h, std::size_t i, const PositionResult& p) { h.see(i, band_of(p, Direction::down)); }},
    {&AxisParameters::E,
     [](Hull& h, std::size_t i, const PositionResult& p) {
       h.see(i, mean_of(p, Direction::up));
       h.see(i, mean_of(p, Direction::down));
     }},
    {&AxisParameters::E_up,
     [](Hull& h, std::size_t i, const PositionResult& p) { h.see(i, mean_of(p, Direction::up)); }},
    {&AxisParameters::E_down,
     [](Hull& h, std::size_t i, const PositionResult& p) { h.see(i, mean_of(p, Direction::down)); }},
    {&AxisParameters::M,
     [](Hull& h, std::size_t i, const PositionResult& p) {
       if (p.mean) h.see(i, DeviationSpan{p.mean->in_native(), p.mean->in_native()});
     }},
    {&AxisParameters::R, [](Hull& h, std::size_t i, const PositionResult& p) { h.see_wider(i, repeatability_of(p)); }},
    {&AxisParameters::R_up,
     [](Hull& h, std::size_t i, const PositionResult& p) { h.see_wider(i, band_of(p, Direction::up)); }},
    {&AxisParameters::R_down,
     [](Hull& h, std::size_t i, const PositionResult& p) { h.see_wider(i, band_of(p, Direction::down)); }},
    {&AxisParameters::B, [](Hull& h, std::size_t i, const PositionResult& p) { h.see_wider(i, reversal_of(p)); }},
};

}  // namespace

std::optional<Deviation> mean(const PositionResult& position, Direction direction) {
  return direction == Direction::up ? position.mean_up : position.mean_down;
}

std::optional<Deviation> standard_deviation(const PositionResult& position, Direction direction) {
  return direction == Direction::up ? position.s_up : position.s_down;
}

double half_band(const PositionResult& position, Direction direction) {
  const auto s = standard_deviation(position, direction);
  return s ? iso230_2::coverage_factor * s->in_native() : 0.0;
}

std::optional<Extent> extent(const Evaluation& evaluation, Parameter parameter) {
  const auto* definition = std::ranges::find(definitions, parameter, &Definition::parameter);
  if (definition == std::end(definitions) || !(evaluation.parameters.*parameter)) return std::nullopt;
  Hull hull;
  for (std::size_t i = 0; i < evaluation.positions.size(); ++i) definition->see(hull, i, evaluation.positions[i]);
  return hull.extent();
}

}  // namespace axiometry::report::plot
