// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/inputs/resolved_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/text/number_text.h"

namespace axiometry::iso230_2 {
namespace {

template <typename Quantity>
std::optional<double> in(const std::optional<Quantity>& quantity, double (Quantity::*unit)() const) {
  return quantity ? std::optional(((*quantity).*unit)()) : std::nullopt;
}

/// Where a person reads of an origin.
std::string stated_by(const ResolvedRow& row) {
  switch (row.origin) {
    case InputOrigin::instrument: return row.instrument.empty() ? "instrument" : "instrument " + row.instrument;
    case InputOrigin::entered: return "entered for this test";
    default: return std::string(origin_key(row.origin));
  }
}

}  // namespace

std::optional<double> stated_number(const std::optional<ExpansionCoefficient>& x) {
  return in(x, &ExpansionCoefficient::in_um_per_m_K);
}
std::optional<double> stated_number(const std::optional<TemperatureDifference>& x) {
  return in(x, &TemperatureDifference::in_kelvin);
}
std::optional<double> stated_number(const std::optional<RelativeLength>& x) {
  return in(x, &RelativeLength::in_um_per_m);
}
std::optional<double> stated_number(const std::optional<Deviation>& x) { return in(x, &Deviation::in_native); }
std::optional<double> stated_number(const std::optional<Length>& x) { return in(x, &Length::in_mm); }

std::string statement_text(const ResolvedRow& row) {
  std::string value = row.value ? fmt::format("{:.9g}", *row.value) : row.word;  // differences leave a rounding
  if (!row.unit.empty()) value += " " + row.unit;
  return fmt::format("{} = {} ({})", row.key, value, stated_by(row));
}

ResolvedRow* StatementList::find(std::string_view key) {
  const auto found = std::ranges::find(rows, key, &ResolvedRow::key);
  return found == rows.end() ? nullptr : &*found;
}

MaybeResolved StatementList::take(std::string_view key, std::string_view symbol, std::optional<double> value,
                                  std::string_view unit, InputUse use) {
  if (!value) return std::nullopt;
  const StatedItem* stated = item(key);
  const auto origin = static_cast<InputOrigin>(by(key));
  rows.push_back({std::string(key), std::string(symbol), value, "", std::string(unit), origin,
                  stated != nullptr ? stated->name : "", use, ""});
  return ResolvedValue{*value, origin};
}

void StatementList::take_word(std::string_view key, std::string_view word, InputOrigin origin, InputUse use) {
  rows.push_back({std::string(key), "", {}, std::string(word), "", origin, "", use, ""});
}

ResolvedValue StatementList::follow(std::string_view key, std::string_view symbol, double value, std::string_view unit,
                                    InputOrigin origin, InputUse use) {
  rows.push_back({std::string(key), std::string(symbol), value, "", std::string(unit), origin, "", use, ""});
  return {value, origin};
}

void StatementList::cannot_act(std::string_view key, const std::string& why) {
  ResolvedRow* row = find(key);
  if (row == nullptr || row->use == InputUse::none || row->origin > InputOrigin::flag) return;
  row->use = InputUse::none;
  row->reason = why;
  remarks.push_back({true, fmt::format("{} cannot act: {}", statement_text(*row), why), row->key});
}

void StatementList::set_aside(std::string_view key, const std::string& why) {
  ResolvedRow* row = find(key);
  if (row == nullptr || row->use == InputUse::none) return;
  row->use = InputUse::none;
  row->reason = why;
  note(fmt::format("{} does not count: {}", statement_text(*row), why));
}

void StatementList::cannot_act_without(std::string_view input, std::string_view key, const std::string& why) {
  if (!has_distribution(input)) return cannot_act(key, why);
  if (ResolvedRow* row = find(key); row != nullptr && row->use == InputUse::all) {
    row->use = InputUse::propagation;
    row->reason = why;
  }
}

void StatementList::override_by(std::string_view key, std::string_view by) {
  ResolvedRow* row = find(key);
  const ResolvedRow* other = find(by);
  if (row == nullptr || other == nullptr || row->use == InputUse::none) return;
  row->use = InputUse::none;
  row->reason = fmt::format("{} takes its place", by);
  note(fmt::format("{} does not count: {} takes its place", statement_text(*row), statement_text(*other)));
}

bool StatementList::has_distribution(std::string_view input) const {
  return std::ranges::find(distributions_, input, &InputDistribution::input) != distributions_.end();
}

StatedBy StatementList::strength(std::span<const std::string_view> keys) {
  StatedBy strongest = StatedBy::instrument;
  for (const std::string_view key : keys)
    if (find(key) != nullptr) strongest = std::max(strongest, by(key));
  return strongest;
}

}  // namespace axiometry::iso230_2
