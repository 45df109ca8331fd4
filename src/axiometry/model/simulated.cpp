// SPDX-License-Identifier: Apache-2.0
#include "axiometry/model/simulated.h"

#include <fmt/format.h>

#include "axiometry/base/text.h"

namespace axiometry {
namespace {

/// So begin the words of simulations in the three languages: simulated, simuliert, simulée; but also simultaneous.
constexpr std::string_view simulating = "simul", at_once = "simultan";

std::size_t find_simulating(std::string_view lower) {
  std::size_t at = lower.find(simulating);
  while (at != std::string_view::npos && lower.substr(at).starts_with(at_once)) at = lower.find(simulating, at + 1);
  return at;
}

}  // namespace

std::optional<std::string> simulated_by_purpose(std::string_view purpose) {
  const std::string_view said = text::trim(purpose);
  const std::string lower = text::to_lower(said);
  const std::size_t at = find_simulating(lower);
  if (at == std::string_view::npos) return std::nullopt;
  if (at == 0 && said.find_first_of(" \t,;:(") == std::string_view::npos)
    return "found readings that were simulated, expected those of a machine";
  return fmt::format("found the purpose {}, which speaks of a simulation, expected readings of a machine",
                     text::quoted(said));
}

}  // namespace axiometry
