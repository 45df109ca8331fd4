// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/recordings/capture_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

/// Numbers that a flag may have, the bounds included.
struct Bounds {
  double lowest = -1e9;
  double highest = 1e9;
};
constexpr Bounds positive{1e-12, 1e12};
constexpr Bounds not_negative{0.0, 1e12};

Result<double> number_within(const std::string& word, Bounds bounds) {
  const auto number = parse_number(word);
  if (number && *number > bounds.highest)
    return fail(fmt::format("found {}, expected a number up to {}", text::quoted(word), format_exact(bounds.highest)));
  if (!number || *number < bounds.lowest)
    return fail(fmt::format("found {}, expected a number{}", text::quoted(word),
                            bounds.lowest >= 0.0 ? (bounds.lowest > 0.0 ? " above 0" : " of 0 or more") : ""));
  return *number;
}

Result<std::size_t> count_from(const std::string& word) {
  AXIOMETRY_TRY(const double number, number_within(word, {1, 1e6}));
  const auto whole = static_cast<std::size_t>(number);
  if (static_cast<double>(whole) != number)
    return fail(fmt::format("found {}, expected a whole number", format_exact(number)));
  return whole;
}

Result<bool> switch_from(const std::string& word) {
  if (word == "1" || word == "true") return true;
  if (word == "0" || word == "false") return false;
  return fail(fmt::format("found {}, expected 1 or 0", text::quoted(word)));
}

template <auto member>
Result<void> put_seconds(const std::string& word, CaptureOptions& o) {
  AXIOMETRY_TRY(const double x, number_within(word, member == &CaptureOptions::settling ? not_negative : positive));
  o.*member = Duration::s(x);
  return {};
}

template <auto member>
Result<void> put_positive(const std::string& word, CaptureOptions& o) {
  AXIOMETRY_TRY(o.*member, number_within(word, positive));
  return {};
}

Result<void> put_part(const std::string& word, CaptureOptions& o) {
  AXIOMETRY_TRY(o.part, count_from(word));
  return {};
}

Result<void> put_stream(const std::string& word, CaptureOptions& o) {
  o.stream = word;
  return {};
}

Result<void> put_units_per_count(const std::string& word, CaptureOptions& o) {
  AXIOMETRY_TRY(o.recording.units_per_count, number_within(word, {}));
  return {};
}

Result<void> put_rate(const std::string& word, CaptureOptions& o) {
  AXIOMETRY_TRY(o.recording.rate_hz, number_within(word, positive));
  return {};
}

Result<void> put_stream_axis(const std::string& word, CaptureOptions& o) {
  AXIOMETRY_TRY(const std::size_t axis, count_from(word));
  o.recording.axis = axis - 1;
  o.recording.axis_stated = true;
  return {};
}

Result<void> put_skip_damaged(const std::string& word, CaptureOptions& o) {
  AXIOMETRY_TRY(o.recording.skip_damaged, switch_from(word));
  return {};
}

Result<void> put_rest_threshold(const std::string& word, CaptureOptions& o) {
  AXIOMETRY_TRY(const double x, number_within(word, positive));
  o.rest_threshold = Position::native(x);
  return {};
}

Result<void> put_target_window(const std::string& word, CaptureOptions& o) {
  AXIOMETRY_TRY(const double x, number_within(word, positive));
  o.matcher.window = Position::native(x);
  return {};
}

Result<void> put_reverse(const std::string& word, CaptureOptions& o) {
  AXIOMETRY_TRY(o.matcher.reversed, switch_from(word));
  return {};
}

Result<void> put_datum(const std::string& word, CaptureOptions& o) {
  AXIOMETRY_TRY(const double x, number_within(word, {}));
  o.matcher.datum = Position::native(x);
  return {};
}

Result<void> put_zero(const std::string& word, CaptureOptions& o) {
  if (word != "first-target") return fail(fmt::format("found {}, expected first-target", text::quoted(word)));
  o.matcher.zero_at_first_target = true;
  return {};
}

// The order is that of the help.
constexpr CaptureOption capture_option_table[] = {
    {"--part", "N", "Of a plan with further ones: 1 is the plan itself (1); of a volumetric plan the station and tool",
     put_part},
    {"--stream", "ID",
     "Layout of the stream instead of recognising it: umd, hpi-3d, time-position, npy, camonitor-stream", put_stream},
    {"--units-per-count", "MM", "mm or degrees per count, for streams of counts", put_units_per_count},
    {"--wavelength", "NM", "Wavelength of the laser in the air of the test, nm, for streams of counts",
     put_positive<&CaptureOptions::wavelength_nm>},
    {"--counts-per-wavelength", "N", "Counts for a wavelength of travel: 2, 4 or 8 after the optics",
     put_positive<&CaptureOptions::counts_per_wavelength>},
    {"--rate", "HZ", "Samples per second, for streams that do not tell it", put_rate},
    {"--stream-axis", "N", "Which axis or column of a stream of several (1)", put_stream_axis},
    {"--skip-damaged", "",
     "Count lines that are no samples as lost instead of refusing the recording; always so for live streams",
     put_skip_damaged},
    {"--rest-window", "S", "Time over which rest is judged (a quarter of the plan's dwell, 0.1 to 1 s)",
     put_seconds<&CaptureOptions::rest_window>},
    {"--rest-threshold", "MM",
     "Range of the means in that time, mm or degrees, up to which the axis rests (follows the noise)",
     put_rest_threshold},
    {"--settling", "S", "Time after a stop that is not averaged (the window)", put_seconds<&CaptureOptions::settling>},
    {"--shortest-rest", "S", "Shorter standstills are not used (half the plan's dwell)",
     put_seconds<&CaptureOptions::shortest_rest>},
    {"--target-window", "MM",
     "Farthest from a target, mm or degrees (a quarter of the smallest interval, half the overrun at most)",
     put_target_window},
    {"--reverse", "", "The instrument counts up when the axis moves down", put_reverse},
    {"--datum", "POSITION", "Where on the axis the instrument shows zero, mm or degrees (0)", put_datum},
    {"--zero", "WHERE",
     "first-target: the first standstill at target 1 is its nominal position; the constant is reported", put_zero},
};

}  // namespace

std::span<const CaptureOption> capture_options() { return capture_option_table; }

Result<CaptureOptions> capture_options_from(std::span<const std::pair<std::string, std::string>> texts) {
  CaptureOptions options;
  std::vector<std::string_view> known;
  for (const CaptureOption& option : capture_option_table) known.push_back(option.name.substr(2));
  bool datum = false;
  for (const auto& [name, text] : texts) {
    const auto place = std::ranges::find(known, std::string_view(name));
    if (place == known.end())
      return fail(
          fmt::format("found the unknown option {}, expected one of {}", text::quoted(name), fmt::join(known, ", ")));
    if (auto put = capture_option_table[place - known.begin()].apply(text, options); !put)
      return fail(fmt::format("{}: {}", name, put.error().message));
    options.stated = name;
    datum = datum || name == "datum";
  }
  if (datum && options.matcher.zero_at_first_target) return fail("found both datum and zero, expected one of them");
  return options;
}

}  // namespace axiometry::app
