// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <initializer_list>
#include <string>
#include <string_view>

#include "axiometry/app/dynamics/dynamic_motion.h"
#include "axiometry/app/files/piecewise.h"
#include "axiometry/base/text/number_text.h"

namespace axiometry::app {
namespace {

void add_row(std::string& text, std::initializer_list<double> values) {
  bool first = true;
  for (const double x : values) {
    text += first ? "" : ",";
    text += format_exact(x);
    first = false;
  }
  text += '\n';
}

/// A table that is written piece by piece.
struct SampleTable {
  std::string head;
  std::size_t count = 0;

  Result<void> write(const auto& row, const auto& sink) const {
    constexpr std::size_t at_once = 4096;
    std::string text = head;
    for (std::size_t k = 0; k < count; ++k) {
      row(text, k);
      if (k % at_once != at_once - 1) continue;
      AXIOMETRY_TRY_VOID(sink(text));
      text.clear();
    }
    return sink(text);
  }
};

Result<void> series_to(const DynamicMotion& m, const auto& sink) {
  const std::string_view unit = m.kind == AxisKind::linear ? "mm" : "deg";
  const SampleTable table{fmt::format("time_s,position_{0},velocity_{0}_per_s,acceleration_{0}_per_s2\n", unit),
                          m.record.positions.size()};
  return table.write(
      [&](std::string& text, std::size_t k) {
        add_row(text, {m.record.time_s(k), m.record.positions[k], m.course.velocity[k], m.course.acceleration[k]});
      },
      sink);
}

Result<void> spectrum_to(const DynamicMotion& m, const auto& sink) {
  const SampleTable table{fmt::format("frequency_hz,amplitude_{}\n", m.kind == AxisKind::linear ? "um" : "arcsec"),
                          m.spectrum.amplitudes.size()};
  return table.write(
      [&](std::string& text, std::size_t k) {
        add_row(text, {static_cast<double>(k) * m.spectrum.step_hz, m.spectrum.amplitudes[k]});
      },
      sink);
}

}  // namespace

Result<void> write_series(const DynamicMotion& m, const std::string& file) {
  return write_piecewise(file, [&](const auto& sink) { return series_to(m, sink); });
}

Result<void> write_spectrum(const DynamicMotion& m, const std::string& file) {
  return write_piecewise(file, [&](const auto& sink) { return spectrum_to(m, sink); });
}

std::string series_csv(const DynamicMotion& m) {
  return text_of_pieces([&](const auto& sink) { return series_to(m, sink); });
}

std::string spectrum_csv(const DynamicMotion& m) {
  return text_of_pieces([&](const auto& sink) { return spectrum_to(m, sink); });
}

}  // namespace axiometry::app
