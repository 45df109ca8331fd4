// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/resolved_text.h"

#include <fmt/format.h>

#include "axiometry/model/fields.h"
#include "axiometry/report/shown_number.h"

namespace axiometry::report {

using iso230_2::InputOrigin;
using iso230_2::InputUse;

std::string input_title(const iso230_2::ResolvedRow& row) {
  const std::string_view key = row.key;
  const std::size_t of = key.find(" (");
  const Field* field = find_field(key.substr(0, of));
  if (field == nullptr) return row.key;
  return std::string(field->title) + std::string(of == std::string_view::npos ? "" : key.substr(of));
}

std::string input_value(const iso230_2::ResolvedRow& row, const Options& options) {
  if (row.word == "linear") return "a + b·L";
  if (row.word == "quadratic") return "√(a² + (b·L)²)";
  const std::string value = row.value ? shown_short(*row.value, options) : row.word;
  return row.unit.empty() ? value : fmt::format("{}\u00a0{}", value, row.unit);
}

std::string origin_text(const iso230_2::ResolvedRow& row) {
  switch (row.origin) {
    case InputOrigin::instrument: return row.instrument.empty() ? "instrument" : "instrument " + row.instrument;
    case InputOrigin::file:
    case InputOrigin::entered:
    case InputOrigin::flag: {
      const std::string who = row.origin == InputOrigin::file      ? "file"
                              : row.origin == InputOrigin::entered ? "entered for this test"
                                                                   : "flag";
      return row.instrument.empty() ? who : fmt::format("{}, {}", row.instrument, who);
    }
    case InputOrigin::sensors: return "sensors";
    case InputOrigin::air: return "air temperature";
    case InputOrigin::nde_correction: return "NDE correction";
    case InputOrigin::scale: return "scale";
    case InputOrigin::measured_travel: return "measured travel";
    case InputOrigin::misalignment:
    case InputOrigin::alignment_angle: return "derived";
    case InputOrigin::assumed: return "assumed";
  }
  return "";
}

std::string use_text(const iso230_2::ResolvedRow& row) {
  switch (row.use) {
    case InputUse::none: return "not used: " + row.reason;
    case InputUse::all: return "all methods";
    case InputUse::annex_a: return "Annex A";
    case InputUse::propagation: return "GUM and Monte Carlo";
  }
  return "";
}

}  // namespace axiometry::report
