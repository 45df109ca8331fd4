// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/machine/chain.h"

#include <fmt/format.h>

#include "axiometry/base/text/text.h"

namespace axiometry::volumetric {
namespace {

constexpr std::string_view letters = "XYZ";

std::unexpected<Error> not_a_chain(std::string_view text) {
  return fail(
      fmt::format("found the chain {}, expected X, Y, Z and F for the foundation once each, those that move the "
                  "workpiece before F, from the workpiece to the tool, as XFYZ",
                  text::quoted(text)));
}

}  // namespace

Result<KinematicChain> KinematicChain::make(std::string_view text) {
  std::string_view middle = text;
  if (middle.starts_with('w')) middle.remove_prefix(1);
  if (middle.ends_with('t')) middle.remove_suffix(1);
  if (middle.size() != 4) return not_a_chain(text);
  KinematicChain chain;
  std::size_t axes = 0;
  bool behind_foundation = false;
  std::array<bool, 3> seen{};
  for (const char c : middle) {
    if (c == 'F' || c == 'b') {
      if (behind_foundation) return not_a_chain(text);
      behind_foundation = true;
      chain.workpiece_axes_ = axes;
      continue;
    }
    const std::size_t axis = letters.find(c);
    if (axis == std::string_view::npos || seen[axis] || axes == 3) return not_a_chain(text);
    seen[axis] = true;
    chain.order_[axes++] = axis;
    chain.carries_workpiece_[axis] = !behind_foundation;
  }
  if (!behind_foundation || axes != 3) return not_a_chain(text);
  return chain;
}

std::string KinematicChain::text() const {
  std::string text;
  for (std::size_t k = 0; k < 3; ++k) {
    if (k == workpiece_axes_) text += 'F';
    text += letters[order_[k]];
  }
  if (workpiece_axes_ == 3) text += 'F';
  return text;
}

std::array<Vector3, 3> KinematicChain::levers(Vector3 axes, Vector3 tool) const {
  std::array<Vector3, 3> r;
  const std::array<double, 3> way = {axes.x, axes.y, axes.z};
  std::array<double, 3> behind = {tool.x, tool.y, tool.z};
  for (std::size_t k = 3; k-- > 0;) {
    const std::size_t a = order_[k];
    const Vector3 without = {behind[0], behind[1], behind[2]};
    behind[a] += way[a];
    r[a] = carries_workpiece_[a] ? Vector3{behind[0], behind[1], behind[2]} : without;
  }
  return r;
}

}  // namespace axiometry::volumetric
