// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/contract.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/shown_number.h"

namespace axiometry::report {

TableCell quiet_cell(std::string_view text) { return {plain(text), Tone::quiet}; }

TableCell text_cell(std::string_view text) { return {plain(text)}; }

TableCell verbatim_cell(std::string_view text) { return {verbatim(text)}; }

RichText strong_verbatim(std::string_view text) {
  return {TextRun{.text = std::string(text), .bold = true, .verbatim = true}};
}

TableCell deviation_cell(const std::optional<Deviation>& deviation, const Options& options) {
  return deviation ? text_cell(shown_deviation(*deviation, options)) : quiet_cell("–");
}

namespace {

std::string number_list(const std::vector<double>& numbers, const Options& options) {
  const std::string_view separator = numbers.size() <= 3 ? " / " : "; ";
  std::string all;
  for (double x : numbers) {
    if (!all.empty()) all += separator;
    all += shown_exact(x, options);
  }
  return all;
}

/// "X 0 to 800 mm, Y 0 to 600 mm, Z -500 to 0 mm"
bool is_travels(std::string_view text) {
  return text.starts_with("X ") && text.contains(" mm, Y ") && text.contains(" mm, Z ") && text.ends_with(" mm") &&
         text.contains(" to ");
}

/// What the program itself puts into a field of words: travels, where it corrected the expansion, along planned lines.
bool is_of_this_program(std::string_view text) {
  return is_travels(text) || text.starts_with("by this program from start and end temperatures") ||
         text.starts_with("away from a tracking interferometer at (") ||
         text.contains(" there and back over the measurement travel at ");
}

}  // namespace

TableCell stated(const Field& field, const Metadata& metadata, const Options& options) {
  const FieldValue value = field.get(metadata);
  if (std::holds_alternative<std::monostate>(value)) return quiet_cell("not stated");
  std::string shown = field_text(field, value);
  if (field.type == FieldType::text && is_of_this_program(shown)) return text_cell(with_true_minus(shown));
  if (field.type == FieldType::text || field.type == FieldType::records) return verbatim_cell(shown);
  if (const auto* x = std::get_if<double>(&value)) shown = shown_exact(*x, options);
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) shown = number_list(*numbers, options);
  const bool has_unit = field.type == FieldType::number || field.type == FieldType::numbers;
  const std::string_view unit = has_unit ? field_unit(field, metadata.axis.kind) : std::string_view{};
  if (!unit.empty()) shown.append(unit == "°" ? "" : "\u00a0").append(unit);
  return text_cell(shown);
}

TableCell stated(std::string_view field_key, const Metadata& metadata) {
  const Field* field = find_field(field_key);
  AXIOMETRY_CONTRACT(field != nullptr);
  return stated(*field, metadata, Options{});
}

}  // namespace axiometry::report
