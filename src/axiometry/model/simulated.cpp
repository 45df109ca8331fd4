// SPDX-License-Identifier: Apache-2.0
#include "axiometry/model/simulated.h"

#include <fmt/format.h>

#include "axiometry/base/text/text.h"

namespace axiometry {
namespace {

/// So begin the words of simulations in the three languages: simulated, simuliert, simulée; but also simultaneous.
constexpr std::string_view simulating = "simul", at_once = "simultan";

/// Words that mean it and nothing else; a "Simulationsabgleich" compares a measurement with one.
bool is_word_for_it(std::string_view lower) {
  constexpr std::string_view words[] = {"simulation", "simulations", "simulationen", "simulator", "simulated",
                                        "simuliert",  "simulé",      "simulée",      "simulés",   "simulées"};
  return text::is_one_of(lower, words);
}

std::size_t find_simulating(std::string_view lower) {
  std::size_t at = lower.find(simulating);
  while (at != std::string_view::npos && lower.substr(at).starts_with(at_once)) at = lower.find(simulating, at + 1);
  return at;
}

}  // namespace

std::optional<std::string> simulated_by_purpose(std::string_view purpose) {
  const std::string_view said = text::trim(purpose);
  const std::string lower = text::to_lower(said);
  if (find_simulating(lower) == std::string_view::npos) return std::nullopt;
  if (is_word_for_it(lower)) return "found readings that were simulated, expected those of a machine";
  return fmt::format("found the purpose {}, which speaks of a simulation, expected readings of a machine",
                     text::quoted(said));
}

}  // namespace axiometry
