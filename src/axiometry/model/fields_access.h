// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "axiometry/model/fields.h"

/// What the rows of the metadata vocabulary (fields_table.cpp) are made of: how a member of each type is read
/// and written as a FieldValue.
namespace axiometry::fields_access {

// A quantity brings its unit as a pair of functions; optionals are absent when not given.

template <typename T>
struct InUnit {
  T (*make)(double);
  double (T::*read)() const;
};

inline constexpr InUnit<Length> nm{&Length::nm, &Length::in_nm};
inline constexpr InUnit<Length> mm{&Length::mm, &Length::in_mm};
inline constexpr InUnit<Temperature> celsius{&Temperature::celsius, &Temperature::in_celsius};
inline constexpr InUnit<TemperatureDifference> kelvin{&TemperatureDifference::kelvin,
                                                      &TemperatureDifference::in_kelvin};
inline constexpr InUnit<ExpansionCoefficient> per_m_K{&ExpansionCoefficient::um_per_m_K,
                                                      &ExpansionCoefficient::in_um_per_m_K};
inline constexpr InUnit<RelativeLength> per_m{&RelativeLength::um_per_m, &RelativeLength::in_um_per_m};
inline constexpr InUnit<Angle> degrees{&Angle::deg, &Angle::in_deg};
inline constexpr InUnit<Duration> seconds{&Duration::s, &Duration::in_s};
inline constexpr InUnit<Pressure> kilopascal{&Pressure::kPa, &Pressure::in_kPa};
inline constexpr InUnit<RelativeHumidity> percent{&RelativeHumidity::percent, &RelativeHumidity::in_percent};
inline constexpr InUnit<Position> position{&Position::native, &Position::in_native};
inline constexpr InUnit<Deviation> deviation{&Deviation::native, &Deviation::in_native};

/// Members as a path of pointers to members: At<&Metadata::machine, &Machine::name>.
template <auto Group, auto Member>
struct At {
  static auto& in(Metadata& m) { return m.*Group.*Member; }
  static const auto& in(const Metadata& m) { return m.*Group.*Member; }
};

template <typename Path>
struct TextAccess {
  static FieldValue get(const Metadata& m) { return Path::in(m).empty() ? FieldValue{} : FieldValue(Path::in(m)); }
  static void put(Metadata& m, const FieldValue& value) {
    const auto* s = std::get_if<std::string>(&value);
    Path::in(m) = s ? *s : std::string();
  }
};

template <typename Path, const auto& Unit>
struct QuantityAccess {
  static FieldValue get(const Metadata& m) {
    const auto& member = Path::in(m);
    return member ? FieldValue(((*member).*(Unit.read))()) : FieldValue{};
  }
  static void put(Metadata& m, const FieldValue& value) {
    const auto* x = std::get_if<double>(&value);
    if (x) {
      Path::in(m) = Unit.make(*x);
    } else {
      Path::in(m).reset();
    }
  }
};

/// Optional plain members: bool and double.
template <typename Path, typename T>
struct PlainAccess {
  static FieldValue get(const Metadata& m) { return Path::in(m) ? FieldValue(*Path::in(m)) : FieldValue{}; }
  static void put(Metadata& m, const FieldValue& value) {
    const auto* x = std::get_if<T>(&value);
    Path::in(m) = x ? std::optional<T>(*x) : std::nullopt;
  }
};

template <typename Path>
struct NumbersAccess {
  static FieldValue get(const Metadata& m) { return Path::in(m).empty() ? FieldValue{} : FieldValue(Path::in(m)); }
  static void put(Metadata& m, const FieldValue& value) {
    const auto* list = std::get_if<std::vector<double>>(&value);
    Path::in(m) = list ? *list : std::vector<double>{};
  }
};

/// An enumeration by its words, the first being the default (and so never "not given").
template <typename Path, const auto& Words>
struct ChoiceAccess {
  static FieldValue get(const Metadata& m) { return std::string(Words[static_cast<std::size_t>(Path::in(m))]); }
  static void put(Metadata& m, const FieldValue& value) {
    auto& member = Path::in(m);
    member = {};
    const auto* word = std::get_if<std::string>(&value);
    for (std::size_t k = 0; word && k < std::size(Words); ++k)
      if (Words[k] == *word) member = static_cast<std::remove_reference_t<decltype(member)>>(k);
  }
};

/// The same where "not given" is another answer.
template <typename Path, const auto& Words>
struct OptionalChoiceAccess {
  static FieldValue get(const Metadata& m) {
    const auto& member = Path::in(m);
    return member ? FieldValue(std::string(Words[static_cast<std::size_t>(*member)])) : FieldValue{};
  }
  static void put(Metadata& m, const FieldValue& value) {
    auto& member = Path::in(m);
    member.reset();
    const auto* word = std::get_if<std::string>(&value);
    for (std::size_t k = 0; word && k < std::size(Words); ++k)
      if (Words[k] == *word)
        member.emplace(static_cast<typename std::remove_reference_t<decltype(member)>::value_type>(k));
  }
};

inline Cell text_cell(const std::string& s) { return s.empty() ? Cell{} : Cell(s); }
inline std::string text_of(const Cell& cell) {
  const auto* s = std::get_if<std::string>(&cell);
  return s ? *s : std::string();
}
inline Cell temperature_cell(const std::optional<Temperature>& t) { return t ? Cell(t->in_celsius()) : Cell{}; }
inline std::optional<Temperature> temperature_of(const Cell& cell) {
  const auto* x = std::get_if<double>(&cell);
  return x ? std::optional(Temperature::celsius(*x)) : std::nullopt;
}

inline constexpr double any = 1e6;  // far beyond any machine, so that only slips of the pen are refused

template <typename Access>
constexpr Field text_field(std::string_view key, std::string_view title, std::string_view clause, Field::Wanted wanted,
                           std::string_view description) {
  return {key, title, FieldType::text, "", "", clause, wanted, 0, 0, {}, {}, description, &Access::get, &Access::put};
}

template <typename Access>
constexpr Field number_field(std::string_view key, std::string_view title, std::string_view unit_linear,
                             std::string_view unit_rotary, std::string_view clause, Field::Wanted wanted,
                             double minimum, double maximum, std::string_view description) {
  return {key, title, FieldType::number, unit_linear,  unit_rotary, clause, wanted, minimum, maximum,
          {},  {},    description,       &Access::get, &Access::put};
}

template <typename Access>
constexpr Field numbers_field(std::string_view key, std::string_view title, std::string_view unit_linear,
                              std::string_view unit_rotary, std::string_view clause, Field::Wanted wanted,
                              std::string_view description) {
  return {key, title, FieldType::numbers, unit_linear,  unit_rotary, clause, wanted, -any, any,
          {},  {},    description,        &Access::get, &Access::put};
}

template <typename Access>
constexpr Field choice_field(std::string_view key, std::string_view title, std::string_view clause,
                             std::span<const std::string_view> words, std::string_view description) {
  return {key,   title, FieldType::choice, "",           "",          clause, Field::Wanted::no, 0, 0,
          words, {},    description,       &Access::get, &Access::put};
}

template <typename Access>
constexpr Field records_field(std::string_view key, std::string_view title, std::string_view clause,
                              Field::Wanted wanted, std::span<const RecordColumn> columns,
                              std::string_view description) {
  return {key, title,   FieldType::records, "",           "",          clause, wanted, 0, 0,
          {},  columns, description,        &Access::get, &Access::put};
}

}  // namespace axiometry::fields_access
