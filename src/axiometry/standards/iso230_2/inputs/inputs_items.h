// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "axiometry/standards/iso230_2/inputs/inputs.h"
#include "axiometry/standards/iso230_2/inputs/resolved_inputs.h"

/// The inputs that single items of the metadata stand for. For inputs.cpp alone, which lays the given
/// distributions over them.
namespace axiometry::iso230_2 {

/// An input that the metadata know by name.
struct KnownInput {
  std::string_view key;
  std::string_view symbol;
  std::string_view title;
  std::string_view source;
  Effect effect;  ///< effect; on a rotary axis `target` stands for `scale`
  std::string_view unit_linear;
  std::string_view unit_rotary;  ///< empty: for linear axes only
};

/// In the order in which results list them.
std::span<const KnownInput> known_inputs();
const KnownInput* find_known_input(std::string_view key);  ///< nullptr when there is none

UncertaintyInput make_input(const KnownInput& known, AxisKind kind, uncertainty::Distribution distribution,
                            std::string note);

/// Without the given distributions; the correlation is left at 1.
UncertaintyInputs inputs_of_items(const Metadata& metadata, const ResolvedInputs& resolved);

/// α̂ or ΔT̂ as the items have it, for a pair of which only the other half was given as a distribution: α with
/// the width R(α), ΔT without any. Adds a note.
UncertaintyInputs complete_pairs(UncertaintyInputs inputs, const Metadata& metadata, const ResolvedInputs& resolved);

}  // namespace axiometry::iso230_2
