// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <stdexcept>
#include <string>
#include <string_view>

/// What must be true in every world.
namespace axiometry::world {

using Chance = std::minstd_rand;

[[noreturn]] inline void broken(const std::string& what) { throw std::runtime_error(what); }

inline void expect(bool holds, std::string_view what) {
  if (!holds) broken(std::string(what));
}

}  // namespace axiometry::world
