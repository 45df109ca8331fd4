// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/recordings/stop_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/motions/motion_units.h"
#include "axiometry/model/fields.h"

namespace axiometry::app {
namespace {

using capture::StopSign;

constexpr std::pair<std::string_view, StopSign> sign_words[] = {{"keys", StopSign::keys},
                                                                {"trigger", StopSign::trigger},
                                                                {"readings", StopSign::readings},
                                                                {"position", StopSign::position}};

MotionStatement& stated_in(CaptureOptions& options) {
  return options.motion ? *options.motion : options.motion.emplace();
}

Result<double> number_above_zero(const std::string& word) {
  const auto number = parse_number(word);
  if (number && *number > 0.0 && *number <= 1e6) return *number;
  return fail(fmt::format("found {}, expected a number above 0 up to 1e6", text::quoted(word)));
}

Result<void> put_stops(const std::string& word, CaptureOptions& o) {
  const auto sign = stop_sign(word);
  if (!sign) return fail(fmt::format("found {}, expected keys, trigger, readings or position", text::quoted(word)));
  stated_in(o).sign = *sign;
  return {};
}

Result<void> put_stop_column(const std::string& word, CaptureOptions& o) {
  const auto number = parse_count(word);
  if (!number || *number < 1 || *number > 1000)
    return fail(fmt::format("found {}, expected a number from 1 to 1000", text::quoted(word)));
  stated_in(o).stop_column = static_cast<std::size_t>(*number) - 1;
  return {};
}

Result<void> put_error_read(const std::string& word, CaptureOptions& o) {
  AXIOMETRY_TRY(stated_in(o).error, motion_name(word));
  return {};
}

Result<void> put_unit_sent(const std::string& word, CaptureOptions& o) {
  const formats::Unit* const unit = formats::find_motion_unit(word);
  if (unit == nullptr)
    return fail(fmt::format("found the unit {}, expected one of {}", text::quoted(word), formats::unit_names()));
  stated_in(o).unit = unit;
  return {};
}

Result<void> put_sense_read(const std::string& word, CaptureOptions& o) {
  AXIOMETRY_TRY(stated_in(o).sense, reading_sense(word));
  return {};
}

Result<void> put_reading_window(const std::string& word, CaptureOptions& o) {
  AXIOMETRY_TRY(const double seconds, number_above_zero(word));
  stated_in(o).window = Duration::s(seconds);
  return {};
}

Result<void> put_still(const std::string& word, CaptureOptions& o) {
  AXIOMETRY_TRY(stated_in(o).still, number_above_zero(word));
  return {};
}

Result<void> put_equipment(const std::string& word, CaptureOptions& o) {
  Metadata tried;
  AXIOMETRY_TRY_VOID(set_field_text(tried, "equipment", word));
  stated_in(o).equipment.push_back(word);
  return {};
}

// The order is that of the help.
constexpr CaptureOption stop_option_table[] = {
    {stops_option, "HOW",
     "What tells the stops: keys (a person, at each), trigger (a column that is not 0), readings (one comes at each), "
     "position (a column)",
     put_stops},
    {"--stop-column", "N", "Column of the trigger or the position, beside the time; 1 is the first", put_stop_column},
    {"--error", "NAME", "What is read, EYX or EBX (the only one that the plan is made for)", put_error_read},
    {"--unit", "UNIT", "In which the instrument sends: um, mm, nm, urad, arcsec, mrad, deg and so on", put_unit_sent},
    {"--positive", "WAY", "Which way readings are positive, in axes of the machine: +Y, -A", put_sense_read},
    {"--reading-window", "S", "Averaged behind a key or a trigger (two fifths of the plan's dwell)",
     put_reading_window},
    {"--still", "RANGE",
     "Range of the means within a stop, µm, arcsec or µrad, up to which readings stand still (follows the noise)",
     put_still},
    {equipment_option, "TEXT",
     "Of the measuring instrument, written above the readings: 'Laser head | Maker | Type | Serial number'",
     put_equipment},
};

}  // namespace

std::span<const CaptureOption> stop_options() { return stop_option_table; }

std::string_view stop_sign_word(StopSign sign) {
  return std::ranges::find(sign_words, sign, &std::pair<std::string_view, StopSign>::second)->first;
}

std::optional<StopSign> stop_sign(std::string_view word) {
  const auto row = std::ranges::find(sign_words, word, &std::pair<std::string_view, StopSign>::first);
  return row == std::end(sign_words) ? std::nullopt : std::optional(row->second);
}

Result<CaptureOptions> live_options_from(std::span<const std::pair<std::string, std::string>> texts) {
  CaptureOptions said;
  std::vector<std::pair<std::string, std::string>> others;
  bool given = false;
  for (const auto& [name, text] : texts) {
    const auto option =
        std::ranges::find(stop_option_table, std::string_view(name), [](const auto& o) { return o.name.substr(2); });
    if (option == std::end(stop_option_table)) {
      others.emplace_back(name, text);
      continue;
    }
    if (auto put = option->apply(text, said); !put) return fail(fmt::format("{}: {}", name, put.error().message));
    given = given || option->name == stops_option;
  }
  AXIOMETRY_TRY(CaptureOptions options, capture_options_from(others));
  if (said.motion && !given)
    return fail("found what is said of stops without stops, expected keys, trigger, readings or position");
  if (given && options.part) return fail("found a part beside stops, expected a plan of one axis alone");
  options.motion = std::move(said.motion);
  return options;
}

}  // namespace axiometry::app
