// SPDX-License-Identifier: Apache-2.0
#include "cli/flags/stop_flags.h"

#include <fmt/format.h>

#include <utility>

#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"
#include "axiometry/model/fields.h"
#include "cli/flags/option_text.h"
#include "cli/flags/verb.h"

namespace axiometry::cli {
namespace {

using capture::StopSign;

constexpr std::pair<std::string_view, StopSign> sign_words[] = {{"keys", StopSign::keys},
                                                                {"trigger", StopSign::trigger},
                                                                {"readings", StopSign::readings},
                                                                {"position", StopSign::position}};

Result<StopSign> sign_of(const std::string& word) {
  for (const auto& [name, sign] : sign_words)
    if (word == name) return sign;
  return fail(fmt::format("found {}, expected keys, trigger, readings or position", text::quoted(word)));
}

Result<double> positive_number(const std::string& word) {
  const auto number = parse_number(word);
  if (number && *number > 0.0 && *number <= 1e6) return *number;
  return fail(fmt::format("found {}, expected a number above 0 up to 1e6", text::quoted(word)));
}

Result<std::size_t> column_of(const std::string& word) {
  const auto number = parse_count(word);
  if (number && *number >= 1 && *number <= 1000) return static_cast<std::size_t>(*number) - 1;
  return fail(fmt::format("found {}, expected a number from 1 to 1000", text::quoted(word)));
}

Result<std::string> equipment_of(const std::string& given) {
  Metadata tried;
  AXIOMETRY_TRY_VOID(set_field_text(tried, "equipment", given));
  return given;
}

Result<const formats::Unit*> stream_unit(const std::string& word) {
  const formats::Unit* unit = formats::find_unit(word);
  if (unit != nullptr) return unit;
  return fail(fmt::format("found the unit {}, expected one of {}", text::quoted(word), formats::unit_names()));
}

/// An option that says nothing without --stops.
template <typename Read>
void add_beside(const Verb& group, StopFlags& flags, const OptionText& text, Read read) {
  add_read(group, text, [&flags, name = std::string(text.name), read](const std::string& word) -> Result<void> {
    flags.beside = name;
    return read(word);
  });
}

}  // namespace

void add_stop_flags(const Verb& verb, StopFlags& flags, std::string& keys) {
  Verb group = verb.add_option_group("Straightness, roll, pitch, yaw: readings that do not show where the axis stops");
  app::MotionStatement& stated = flags.stated;
  add_read(group,
           {"--stops", "HOW",
            "What tells the stops: keys (a person, at each), trigger (a column that is not 0), readings (one comes at "
            "each), position (a column)"},
           [&flags, &stated](const std::string& word) -> Result<void> {
             AXIOMETRY_TRY(stated.sign, sign_of(word));
             flags.given = true;
             return {};
           });
  add_beside(group, flags,
             {"--stop-column", "N", "Column of the trigger or the position, beside the time; 1 is the first"},
             [&stated](const std::string& word) -> Result<void> {
               AXIOMETRY_TRY(stated.stop_column, column_of(word));
               return {};
             });
  add_beside(group, flags, {"--error", "NAME", "What is read, EYX or EBX (the only one that the plan is made for)"},
             [&stated](const std::string& word) -> Result<void> {
               AXIOMETRY_TRY(stated.error, motion_name(word));
               return {};
             });
  add_beside(group, flags,
             {"--unit", "UNIT", "In which the instrument sends: um, mm, nm, urad, arcsec, mrad, deg and so on"},
             [&stated](const std::string& word) -> Result<void> {
               AXIOMETRY_TRY(stated.unit, stream_unit(word));
               return {};
             });
  add_beside(group, flags, {"--positive", "WAY", "Which way readings are positive, in axes of the machine: +Y, -A"},
             [&stated](const std::string& word) -> Result<void> {
               AXIOMETRY_TRY(stated.sense, reading_sense(word));
               return {};
             });
  add_beside(group, flags,
             {"--reading-window", "S", "Averaged behind a key or a trigger (two fifths of the plan's dwell)"},
             [&stated](const std::string& word) -> Result<void> {
               AXIOMETRY_TRY(const double seconds, positive_number(word));
               stated.window = Duration::s(seconds);
               return {};
             });
  add_beside(group, flags,
             {"--still", "RANGE",
              "Range of the means within a stop, µm, arcsec or µrad, up to which readings stand still (follows the "
              "noise)"},
             [&stated](const std::string& word) -> Result<void> {
               AXIOMETRY_TRY(stated.still, positive_number(word));
               return {};
             });
  add_beside(group, flags, {"--keys", "FILE", "What was said at the stops of a finished recording: lines 12.5,take"},
             [&keys](const std::string& word) -> Result<void> {
               keys = word;
               return {};
             });
  group
      ->add_option_function<std::vector<std::string>>(
          "--equipment",
          [&flags, &stated](const std::vector<std::string>& given) {
            flags.beside = "--equipment";
            for (const std::string& part : given) {
              auto read = equipment_of(part);
              if (!read) throw UsageError("--equipment", read.error().message);
              stated.equipment.push_back(*std::move(read));
            }
          },
          "Of the measuring instrument, written above the readings: 'Laser head | Maker | Type | Serial number'")
      .type_name("TEXT")
      .one_at_a_time();
}

void check_stop_flags(const StopFlags& flags, app::CaptureOptions& options) {
  if (!flags.given) {
    if (flags.beside.empty()) return;
    throw UsageError(flags.beside, "found without --stops, expected with it");
  }
  if (options.part) throw UsageError("--part", "found with --stops, expected a plan of one axis alone");
  options.motion = flags.stated;
}

}  // namespace axiometry::cli
