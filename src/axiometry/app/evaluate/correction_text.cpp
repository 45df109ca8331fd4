// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/correction_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <vector>

#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

constexpr std::array<std::string_view, 7> correction_words = {"sign",      "gain", "air=ciddor", "air=edlen",
                                                              "dead-path", "nde",  "drift"};

Result<void> choose(std::string_view name, CorrectionRequest& request) {
  if (name == "sign") {
    request.sign = true;
  } else if (name == "gain") {
    request.gain = true;
  } else if (name == "dead-path") {
    request.dead_path = true;
  } else if (name == "nde") {
    request.expansion = true;
  } else if (name == "drift") {
    request.drift = true;
  } else if (name == "air" || name.starts_with("air=")) {
    AXIOMETRY_TRY(const AirEquation equation, parse_air_equation(name == "air" ? "ciddor" : name.substr(4)));
    if (request.air && *request.air != equation)
      return fail("found corrections for the air by two equations, expected one of air=ciddor and air=edlen");
    request.air = equation;
  } else {
    const auto near =
        text::nearest(name, std::vector<std::string_view>(correction_words.begin(), correction_words.end()));
    return fail(fmt::format(
        "found the correction {}, expected {}", text::quoted(name),
        near ? fmt::format("perhaps {}", *near) : fmt::format("some of {}", fmt::join(correction_words, ","))));
  }
  return {};
}

}  // namespace

Result<AirEquation> parse_air_equation(std::string_view word) {
  for (const AirEquation equation : {AirEquation::ciddor, AirEquation::edlen})
    if (word == air_equation_key(equation)) return equation;
  return fail(fmt::format("found the equation {} of air, expected ciddor or edlen", text::quoted(word)));
}

Result<void> choose_corrections(std::string_view list, CorrectionRequest& request) {
  for (const std::string_view name : text::split(list, ',')) AXIOMETRY_TRY_VOID(choose(text::trim(name), request));
  return {};
}

}  // namespace axiometry::app
