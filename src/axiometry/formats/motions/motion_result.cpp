// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/motions/motion_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/counted.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/reading_limits.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/formats/text/text_source.h"

namespace axiometry::formats {
namespace {

using json::Kind;
using json::Value;

/// nullptr where it is absent or null. Contract: `object` is one.
const Value* member_of(const Value& object, std::string_view name) {
  const Value* found = object.find(name);
  return found == nullptr || found->is(Kind::null) ? nullptr : found;
}

Result<const Value*> required_member(const Value& object, std::string_view name) {
  if (!object.is(Kind::object))
    return fail(fmt::format("found {}, expected an object with {}", json::kind_name(object.kind()), text::quoted(name)),
                object.at());
  if (const Value* found = member_of(object, name)) return found;
  return fail(fmt::format("found no {}, expected it as axiometry straightness, angles and squareness write it",
                          text::quoted(name)),
              object.at());
}

Result<double> bounded_number(const Value& value, std::string_view name) {
  AXIOMETRY_TRY(const double number, number_in(value, name));
  if (std::abs(number) <= largest_stated) return number;
  return fail(fmt::format("found {} above 1e9 in {}, expected less", number, text::quoted(name)), value.at());
}

Result<std::optional<double>> known_number(const Value& object, std::string_view name) {
  const Value* value = member_of(object, name);
  if (value == nullptr) return std::optional<double>();
  AXIOMETRY_TRY(const double number, bounded_number(*value, name));
  return std::optional(number);
}

/// 0 or above; absent as 0.
Result<double> amount_or_zero(const Value& object, std::string_view name) {
  AXIOMETRY_TRY(const std::optional<double> number, known_number(object, name));
  if (number.value_or(0.0) >= 0.0) return number.value_or(0.0);
  return fail(fmt::format("found {} below 0, expected 0 or more", text::quoted(name)), object.at());
}

Result<std::vector<double>> course_numbers(const Value& value, std::string_view name, std::size_t count) {
  AXIOMETRY_TRY(const std::vector<Value>* items, items_in(value, name));
  if (count > 0 && items->size() != count)
    return fail(fmt::format("found {} in {}, expected {} as there are positions", counted(items->size(), "number"),
                            text::quoted(name), count),
                value.at());
  std::vector<double> numbers;
  numbers.reserve(items->size());
  for (const Value& item : *items) {
    AXIOMETRY_TRY(const double number, bounded_number(item, name));
    numbers.push_back(number);
  }
  return numbers;
}

Result<MotionUnit> unit_of_result(const Value& value) {
  AXIOMETRY_TRY(const std::string name, text_in(value, "unit"));
  for (const MotionUnit unit : {MotionUnit::um, MotionUnit::urad, MotionUnit::arcsec})
    if (motion_unit_name(unit) == name) return unit;
  return fail(fmt::format("found the unit {}, expected um, urad or arcsec", text::quoted(name)), value.at());
}

/// The lists of one course; `s` of a direction alone.
Result<void> read_course(const Value& positions, std::string_view course, MotionResult& motion,
                         std::vector<double>* s) {
  const Value* object = member_of(positions, course);
  if (object == nullptr) return {};
  AXIOMETRY_TRY(const Value* mean, required_member(*object, "mean"));
  AXIOMETRY_TRY(motion.means, course_numbers(*mean, "mean", motion.positions_mm.size()));
  if (s == nullptr || motion.runs < 2) return {};
  AXIOMETRY_TRY(const Value* scatter, required_member(*object, "s"));
  AXIOMETRY_TRY(*s, course_numbers(*scatter, "s", motion.positions_mm.size()));
  if (std::ranges::any_of(*s, [](double x) { return x < 0.0; }))
    return fail("found a standard deviation below 0, expected 0 or more", scatter->at());
  return {};
}

Result<void> read_positions(const Value& object, MotionResult& motion) {
  AXIOMETRY_TRY(const Value* positions, required_member(object, "positions"));
  AXIOMETRY_TRY(const Value* at, required_member(*positions, "position_mm"));
  AXIOMETRY_TRY(motion.positions_mm, course_numbers(*at, "position_mm", 0));
  const auto& list = motion.positions_mm;
  if (list.size() < 2 || std::ranges::adjacent_find(list, std::greater_equal<>()) != list.end())
    return fail(
        "found positions that do not ascend or fewer than two of them, expected two or more, each above the "
        "one before",
        at->at());
  motion.has_up = member_of(*positions, "up") != nullptr;
  motion.has_down = member_of(*positions, "down") != nullptr;
  AXIOMETRY_TRY_VOID(read_course(*positions, "up", motion, &motion.s_up));
  const std::vector<double> up = motion.means;
  AXIOMETRY_TRY_VOID(read_course(*positions, "down", motion, &motion.s_down));
  if (motion.has_up && motion.has_down)
    for (std::size_t i = 0; i < up.size(); ++i) motion.halves.push_back(0.5 * (up[i] - motion.means[i]));
  if (motion.has_up && motion.has_down) AXIOMETRY_TRY_VOID(read_course(*positions, "mean", motion, nullptr));
  if (motion.means.empty() || (motion.has_up && motion.has_down && member_of(*positions, "mean") == nullptr))
    return fail("found no means over the positions, expected those of up, of down, or of both and mean",
                positions->at());
  return {};
}

Result<void> read_instrument(const Value& object, MotionResult& motion) {
  const Value* instrument = member_of(object, "instrument");
  if (instrument == nullptr) return {};
  AXIOMETRY_TRY_VOID(required_member(*instrument, "U_constant"));
  AXIOMETRY_TRY(motion.instrument_U, amount_or_zero(*instrument, "U_constant"));
  AXIOMETRY_TRY(motion.instrument_U_per_m, amount_or_zero(*instrument, "U_per_m"));
  return {};
}

Result<void> read_remarks(const Value& object, std::vector<std::string>& remarks) {
  const Value* list = member_of(object, "remarks");
  if (list == nullptr) return {};
  AXIOMETRY_TRY(const std::vector<Value>* items, items_in(*list, "remarks"));
  for (const Value& item : *items) {
    AXIOMETRY_TRY(std::string remark, text_in(item, "remarks"));
    remarks.push_back(std::move(remark));
  }
  return {};
}

/// Names of the equipment; what else the metadata holds belongs to others.
Result<void> read_equipment(const Value& object, std::vector<Equipment>& equipment) {
  const Value* metadata = member_of(object, "metadata");
  if (metadata == nullptr || !metadata->is(Kind::object)) return {};
  const Value* list = member_of(*metadata, "equipment");
  if (list == nullptr) return {};
  AXIOMETRY_TRY(const std::vector<Value>* items, items_in(*list, "equipment"));
  for (const Value& item : *items) {
    if (!item.is(Kind::object)) return fail("found equipment that is no object, expected one for each", item.at());
    Equipment& component = equipment.emplace_back();
    for (const auto& [name, target] :
         {std::pair{"role", &component.role}, std::pair{"manufacturer", &component.manufacturer},
          std::pair{"type", &component.type}, std::pair{"serial_number", &component.serial_number}})
      if (const Value* text = member_of(item, name)) {
        AXIOMETRY_TRY(*target, text_in(*text, name));
      }
  }
  return {};
}

Result<MotionResult> motion_of_result(const Value& object) {
  MotionResult motion;
  AXIOMETRY_TRY(const Value* unit, required_member(object, "unit"));
  AXIOMETRY_TRY(motion.unit, unit_of_result(*unit));
  if (const Value* error = member_of(object, "error")) {
    AXIOMETRY_TRY(const std::string name, text_in(*error, "error"));
    AXIOMETRY_TRY(motion.error, placed(motion_name(name), error->at()));
    if (motion.error->rotation() != is_angle(motion.unit))
      return fail(fmt::format("found {} in {}, expected {}", motion.error->text(), motion_unit_symbol(motion.unit),
                              motion.error->rotation() ? "readings of an angle" : "readings of a length"),
                  error->at());
  }
  if (const Value* sense = member_of(object, "read_positive")) {
    AXIOMETRY_TRY(const std::string name, text_in(*sense, "read_positive"));
    AXIOMETRY_TRY(motion.sense, placed(reading_sense(name), sense->at()));
  }
  AXIOMETRY_TRY(const Value* reference, required_member(object, "reference"));
  AXIOMETRY_TRY(motion.reference, text_in(*reference, "reference"));
  AXIOMETRY_TRY(const Value* runs, required_member(object, "runs"));
  AXIOMETRY_TRY(const double count, bounded_number(*runs, "runs"));
  if (!(count >= 1.0) || count != std::floor(count))
    return fail(fmt::format("found {} runs, expected a whole number from 1", count), runs->at());
  motion.runs = static_cast<std::size_t>(count);
  AXIOMETRY_TRY_VOID(read_instrument(object, motion));
  AXIOMETRY_TRY_VOID(read_positions(object, motion));
  AXIOMETRY_TRY_VOID(read_remarks(object, motion.remarks));
  AXIOMETRY_TRY_VOID(read_equipment(object, motion.equipment));
  return motion;
}

Result<LocationResult> location_of_result(const Value& object) {
  LocationResult location;
  AXIOMETRY_TRY(const Value* name, required_member(object, "name"));
  AXIOMETRY_TRY(location.name, text_in(*name, "name"));
  AXIOMETRY_TRY(const Value* estimate, required_member(object, "urad"));
  AXIOMETRY_TRY(const Value* value, required_member(*estimate, "value"));
  AXIOMETRY_TRY(location.urad, bounded_number(*value, "value"));
  AXIOMETRY_TRY(location.k, known_number(*estimate, "k"));
  AXIOMETRY_TRY(location.u_scatter_urad, amount_or_zero(*estimate, "u_scatter"));
  AXIOMETRY_TRY(location.u_instrument_urad, amount_or_zero(*estimate, "u_instrument"));
  return location;
}

Result<void> read_square(const Value& root, MotionResults& results) {
  if (results.motions.size() != 2)
    return fail(fmt::format("found {} in \"lines\", expected the two lines of a squareness", results.motions.size()),
                root.at());
  AXIOMETRY_TRY(results.square_error_arcsec, known_number(root, "square_error_arcsec"));
  AXIOMETRY_TRY(results.square_U_arcsec, known_number(root, "square_uncertainty_arcsec"));
  if (const Value* location = member_of(root, "location_error")) {
    AXIOMETRY_TRY(results.location, location_of_result(*location));
  }
  return {};
}

}  // namespace

bool looks_like_motion_result(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && bytes[first] == '{';
}

Result<MotionResults> read_motion_result(std::string_view bytes) {
  AXIOMETRY_TRY(const Value root, json::parse(bytes));
  AXIOMETRY_TRY(const Value* result, required_member(root, "result"));
  MotionResults results;
  AXIOMETRY_TRY(results.result, text_in(*result, "result"));
  const bool one = results.result == "straightness", square = results.result == "squareness";
  if (!one && !square && results.result != "angles")
    return fail(
        fmt::format("found the result {}, expected straightness, angles or squareness", text::quoted(results.result)),
        result->at());
  AXIOMETRY_TRY(const Value* list, required_member(root, one ? "straightness" : square ? "lines" : "angles"));
  if (one) {
    AXIOMETRY_TRY(MotionResult motion, motion_of_result(*list));
    results.motions.push_back(std::move(motion));
    return results;
  }
  AXIOMETRY_TRY(const std::vector<Value>* items, items_in(*list, square ? "lines" : "angles"));
  for (const Value& item : *items) {
    AXIOMETRY_TRY(MotionResult motion, motion_of_result(item));
    results.motions.push_back(std::move(motion));
  }
  if (results.motions.empty()) return fail("found no errors, expected one or more", list->at());
  if (square) AXIOMETRY_TRY_VOID(read_square(root, results));
  return results;
}

}  // namespace axiometry::formats
