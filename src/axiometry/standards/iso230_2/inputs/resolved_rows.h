// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/standards/iso230_2/inputs/resolved_inputs.h"

/// The statements of a test as they are taken, set aside and told of. For resolved_*.cpp alone.
namespace axiometry::iso230_2 {

std::optional<double> stated_number(const std::optional<ExpansionCoefficient>& x);
std::optional<double> stated_number(const std::optional<TemperatureDifference>& x);
std::optional<double> stated_number(const std::optional<RelativeLength>& x);
std::optional<double> stated_number(const std::optional<Deviation>& x);
std::optional<double> stated_number(const std::optional<Length>& x);

/// "uncertainty.device_error_range_um_per_m = 50 µm/m (flag)".
std::string statement_text(const ResolvedRow& row);

/// Sensors and differences are stated to hundredths of a degree; less is what conversions of units leave.
inline constexpr double same_temperature = 1e-6;

class StatementList {
 public:
  /// Refers to both, which must outlive it.
  StatementList(const std::vector<InputDistribution>& distributions, const StatedItems& stated)
      : distributions_(distributions), stated_(stated) {}

  StatedBy by(std::string_view key) const { return stated_.by(key); }
  const StatedItem* item(std::string_view key) const { return stated_.find(key); }
  ResolvedRow* find(std::string_view key);  ///< nullptr when nothing was stated

  /// A statement, if made, with its row.
  MaybeResolved take(std::string_view key, std::string_view symbol, std::optional<double> value, std::string_view unit,
                     InputUse use = InputUse::all);
  /// The row of a statement in words: "linear", "uniform 10 12".
  void take_word(std::string_view key, std::string_view word, InputOrigin origin, InputUse use = InputUse::all);
  /// What follows, with its row.
  ResolvedValue follow(std::string_view key, std::string_view symbol, double value, std::string_view unit,
                       InputOrigin origin, InputUse use = InputUse::all);

  void note(std::string message) { remarks.push_back({false, std::move(message)}); }
  /// A statement that was made and counts no more, for this reason.
  void cannot_act(std::string_view key, const std::string& why);
  /// The same where something else is the reason, so that nothing is missing.
  void set_aside(std::string_view key, const std::string& why);
  /// As cannot_act(); where a distribution of this input stands for what lacks, it acts where methods know them.
  void cannot_act_without(std::string_view input, std::string_view key, const std::string& why);
  /// One statement that takes the place of another.
  void override_by(std::string_view key, std::string_view by);

  bool has_distribution(std::string_view input) const;
  /// The strongest of those that state any of these.
  StatedBy strength(std::span<const std::string_view> keys);

  std::vector<ResolvedRow> rows;
  std::vector<ResolvedRemark> remarks;

 private:
  const std::vector<InputDistribution>& distributions_;
  const StatedItems& stated_;
};

/// Expansion and temperature of machine and device.
void resolve_bodies(StatementList& list, const Metadata& metadata, ResolvedInputs& result);

}  // namespace axiometry::iso230_2
