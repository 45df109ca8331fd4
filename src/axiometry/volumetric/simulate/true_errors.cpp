// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/simulate/true_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/unit_sizes.h"
#include "axiometry/numeric/random/random.h"
#include "axiometry/volumetric/simulate/random_streams.h"

namespace axiometry::volumetric {
namespace {

constexpr std::size_t nodes_most = 100'000;
constexpr std::size_t drawn_nodes = 65;
constexpr std::size_t drawn_degree = 6;

constexpr double half_share = 0.25;
constexpr std::size_t half_degree = 3;

/// g_0 + Σ g_k/k·P_k(x), k from 1, by (k + 1) P_{k+1} = (2k + 1) x P_k − k P_{k−1}.
double drawn_shape(std::span<const double> g, double x) {
  double before = 1.0, now = x, sum = g[0];
  for (std::size_t k = 1; k < g.size(); ++k) {
    const double n = static_cast<double>(k);
    sum += g[k] / n * now;
    const double next = ((2.0 * n + 1.0) * x * now - n * before) / (n + 1.0);
    before = now;
    now = next;
  }
  return sum;
}

TrueCurve drawn_curve(const TravelBox& travel, ErrorMotion error, std::span<const double> g, DrawnSize size) {
  const double lowest = travel.lowest_mm[error.axis], highest = travel.highest_mm[error.axis];
  const double scale = error.motion < first_rotation ? size.displacement_um : size.rotation_urad;
  std::vector<TrueCurve::Node> nodes;
  for (std::size_t k = 0; k < drawn_nodes; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(drawn_nodes - 1);
    nodes.push_back({lowest + share * (highest - lowest), scale * drawn_shape(g, 2.0 * share - 1.0)});
  }
  return *TrueCurve::make(std::move(nodes));
}

}  // namespace

Result<TrueCurve> TrueCurve::make(std::vector<Node> nodes) {
  if (nodes.size() < 2 || nodes.size() > nodes_most)
    return fail(fmt::format("found {}, expected 2 to {}", counted(nodes.size(), "value"), nodes_most));
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    if (!std::isfinite(nodes[k].position_mm) || !std::isfinite(nodes[k].value))
      return fail(fmt::format("found a number that is not finite in value {}", k + 1));
    if (k > 0 && !(nodes[k - 1].position_mm < nodes[k].position_mm))
      return fail(fmt::format("found the position {} behind {}, expected them to rise",
                              format_exact(nodes[k].position_mm), format_exact(nodes[k - 1].position_mm)));
  }
  TrueCurve curve;
  curve.nodes_ = std::move(nodes);
  return curve;
}

double TrueCurve::at(double position_mm) const {
  if (nodes_.empty()) return 0.0;
  const std::size_t n = nodes_.size(), width = std::min<std::size_t>(4, n);
  const auto above = std::ranges::upper_bound(nodes_, position_mm, {}, &Node::position_mm) - nodes_.begin();
  const auto first = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - static_cast<std::ptrdiff_t>(width / 2),
                                                                         0, static_cast<std::ptrdiff_t>(n - width)));
  double sum = 0.0;
  for (std::size_t i = first; i < first + width; ++i) {
    double weight = nodes_[i].value;
    for (std::size_t k = first; k < first + width; ++k)
      if (k != i) weight *= (position_mm - nodes_[k].position_mm) / (nodes_[i].position_mm - nodes_[k].position_mm);
    sum += weight;
  }
  return sum;
}

/// By Gauss–Legendre quadrature with three nodes in each piece, exact for a cubic times a line.
TrueCurve::Line TrueCurve::line(double lower_mm, double upper_mm) const {
  if (nodes_.empty()) return {};
  std::vector<double> ends = {lower_mm};
  for (const Node& node : nodes_)
    if (node.position_mm > lower_mm && node.position_mm < upper_mm) ends.push_back(node.position_mm);
  ends.push_back(upper_mm);
  const double middle = 0.5 * (lower_mm + upper_mm), length = upper_mm - lower_mm;
  const double offset = std::sqrt(0.6);
  double sum = 0.0, moment = 0.0;
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const double half = 0.5 * (ends[k] - ends[k - 1]), centre = 0.5 * (ends[k] + ends[k - 1]);
    for (const auto& [x, share] : {std::pair{-offset, 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {offset, 5.0 / 9.0}}) {
      const double q = centre + half * x, part = half * share * at(q);
      sum += part;
      moment += part * (q - middle);
    }
  }
  return {sum / length, 12.0 * moment / (length * length * length)};
}

TrueCurve TrueCurve::less(Line line, double lower_mm, double upper_mm) const {
  TrueCurve curve = *this;
  for (Node& node : curve.nodes_)
    node.value -= line.mean + line.slope_per_mm * (node.position_mm - 0.5 * (lower_mm + upper_mm));
  return curve;
}

ErrorValues TrueErrors::at(Vector3 axes_mm, Approaches approaches) const {
  ErrorValues values;
  for (std::size_t a = 0; a < axis_count; ++a)
    for (std::size_t m = 0; m < motion_count; ++m)
      values.motions[a][m] = curves[a][m].at(axes_mm[a]) + approaches[a] * halves[a][m].at(axes_mm[a]);
  values.squareness_urad = squareness_urad;
  return values;
}

bool TrueErrors::has_reversal() const {
  return std::ranges::any_of(halves, [](const auto& of_axis) {
    return std::ranges::any_of(of_axis, [](const TrueCurve& half) { return !half.nodes().empty(); });
  });
}

TrueErrors drawn_errors(const TravelBox& travel, DrawnSize size, Draw draw) {
  TrueErrors errors;
  for (std::size_t a = 0; a < axis_count; ++a)
    for (std::size_t m = 0; m < motion_count; ++m) {
      std::array<double, drawn_degree + 1> g{};
      numeric::fill_normal({draw.seed, detail::stream_curve + a * motion_count + m, draw.trial}, g);
      errors.curves[a][m] = drawn_curve(travel, {a, m}, g, size);
    }
  numeric::fill_normal({draw.seed, detail::stream_squareness, draw.trial}, errors.squareness_urad);
  for (double& s : errors.squareness_urad) s *= size.rotation_urad;
  return errors;
}

TrueErrors with_drawn_reversal(TrueErrors errors, const TravelBox& travel, Reversal reversal, DrawnSize size,
                               Draw draw) {
  if (reversal == Reversal::none) return errors;
  for (std::size_t a = 0; a < axis_count; ++a)
    for (std::size_t m = 0; m < motion_count; ++m) {
      std::array<double, half_degree + 1> g{};
      numeric::fill_normal({draw.seed, detail::stream_half + a * motion_count + m, draw.trial}, g);
      if (reversal == Reversal::constant) std::fill(g.begin() + 1, g.end(), 0.0);
      for (double& x : g) x *= half_share;
      errors.halves[a][m] = drawn_curve(travel, {a, m}, g, size);
    }
  return errors;
}

TrueErrors in_gauge(const TrueErrors& errors, const MachineModel& machine) {
  TrueErrors gauged = errors;
  Matrix3 a_matrix{};  // µm/m
  std::array<Vector3, axis_count> turned{};
  for (std::size_t a = 0; a < axis_count; ++a)
    for (std::size_t m = 0; m < motion_count; ++m) {
      const double lower = machine.travel.lowest_mm[a], upper = machine.travel.highest_mm[a];
      TrueCurve::Line line = errors.curves[a][m].line(lower, upper);
      const ErrorMotion error{a, m};
      if (error.is_straightness()) a_matrix[m][a] += mm_per_m * line.slope_per_mm;
      if (error.is_rotation()) turned[a][m - first_rotation] = line.mean;
      if (!error.is_straightness()) line.slope_per_mm = 0.0;
      gauged.curves[a][m] = errors.curves[a][m].less(line, lower, upper);
    }
  const std::array<std::size_t, 3>& order = machine.chain.order();
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t k = i; k < order.size(); ++k) {
      if (k == i && !machine.chain.carries_workpiece(order[i])) continue;
      Vector3 along{};
      along[order[k]] = 1.0;
      const Vector3 moved = cross(turned[order[i]], along);
      for (std::size_t c = 0; c < 3; ++c) a_matrix[c][order[k]] += moved[c];
    }
  const auto [c0y, b0z, a0z] = errors.squareness_urad;
  a_matrix[0][1] -= c0y;
  a_matrix[0][2] += b0z;
  a_matrix[1][2] -= a0z;
  gauged.squareness_urad = {-(a_matrix[0][1] + a_matrix[1][0]), a_matrix[0][2] + a_matrix[2][0],
                            -(a_matrix[1][2] + a_matrix[2][1])};
  return gauged;
}

}  // namespace axiometry::volumetric
