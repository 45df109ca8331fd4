// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "axiometry/model/series.h"
#include "axiometry/verification/exact.h"

/// Clause 3 of ISO 230-2:2014 once more, from the decimals of the readings in exact arithmetic.
namespace axiometry::verification {

/// The parameters, in the order of this list.
enum class Parameter { A, A_up, A_down, E, E_up, E_down, M, R, R_up, R_down, B, B_mean };

struct ParameterName {
  std::string_view key;
  std::string_view symbol;
};
inline constexpr std::array<ParameterName, 12> parameter_names = {{{"A", "A"},
                                                                   {"A_up", "A↑"},
                                                                   {"A_down", "A↓"},
                                                                   {"E", "E"},
                                                                   {"E_up", "E↑"},
                                                                   {"E_down", "E↓"},
                                                                   {"M", "M"},
                                                                   {"R", "R"},
                                                                   {"R_up", "R↑"},
                                                                   {"R_down", "R↓"},
                                                                   {"B", "B"},
                                                                   {"B_mean", "B̄"}}};

using Exact = std::optional<Interval>;  ///< absent: does not exist

/// One per parameter.
using ExactParameters = std::array<Exact, parameter_names.size()>;
inline const Exact& of(const ExactParameters& all, Parameter p) { return all[static_cast<std::size_t>(p)]; }
inline Exact& of(ExactParameters& all, Parameter p) { return all[static_cast<std::size_t>(p)]; }

inline std::string_view key_of(Parameter p) { return parameter_names[static_cast<std::size_t>(p)].key; }
inline std::string_view symbol_of(Parameter p) { return parameter_names[static_cast<std::size_t>(p)].symbol; }

std::optional<Parameter> parameter_of_key(std::string_view key);
std::optional<Parameter> parameter_of_symbol(std::string_view symbol);

/// What one target and direction gives.
struct ExactCell {
  std::size_t count = 0;
  Exact mean;
  Exact s;  ///< needs two readings
  Exact variance;
};

struct ExactPosition {
  Interval target;
  ExactCell up;
  ExactCell down;

  Exact mean() const;
  Exact reversal() const;
  Exact R_up() const;
  Exact R_down() const;
  Exact R() const;
};

std::vector<ExactPosition> exact_positions(const Series& series);
ExactParameters exact_parameters(std::span<const ExactPosition> positions);

/// How far the figures of the program may be from the exact ones by the rounding of its arithmetic (docs/theory/
/// verification.md): (12n + 2m + 112) units of roundoff of the largest reading.
Interval rounding_of(const Series& series);

/// The smallest number of readings in a measured cell.
std::size_t fewest_runs(std::span<const ExactPosition> positions);

/// The positions after (A.10): each s_i² less (U_EVE/2)², not below 0, of every s_i within `rounding` of the exact one:
/// where the two are nearly equal, the root of their difference is as far apart as the root of the rounding.
std::vector<ExactPosition> without_environment(std::vector<ExactPosition> positions, const Interval& U_eve,
                                               const Interval& rounding);

}  // namespace axiometry::verification
