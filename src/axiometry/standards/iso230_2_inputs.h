// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/metadata.h"
#include "axiometry/model/series.h"
#include "axiometry/uncertainty/distribution.h"

/// The input quantities of a positioning test's uncertainty, with their distributions: the one list that the
/// law of propagation (iso230_2_gum.h) and the Monte Carlo method (iso230_2_monte_carlo.h) both read. Model and
/// equation numbers: Lira & Cargill, Precision Engineering 28 (2004) 232. Derivation: docs/theory/uncertainty.md.
namespace axiometry::iso230_2 {

/// How an input acts on the readings. One draw is shared by all readings of …
enum class Effect {
  machine_expansion,    ///< … the test: α in x = P (f_t(α, ΔT) − f_t(α̂, ΔT̂)), eq. 14; µm/(m·°C)
  machine_temperature,  ///< … the test: ΔT of the same; °C
  device_expansion,     ///< … the test: the same for the expansion of the device (A.6, A.8)
  device_temperature,
  alignment,         ///< … the test: angle θ in x = P (cos θ's departure from its mean), eq. 18; °
  scale,             ///< … the test: x = P ε; µm/m
  target,            ///< … one target in both directions, µm or ″
  target_direction,  ///< … one target in one direction, µm or ″
  run,               ///< … one run, µm or ″
  reading,           ///< each reading has its own, µm or ″: the noise of known size
};

struct UncertaintyInput {
  std::string key;     ///< "machine_temperature"; also names the input in `uncertainty.distributions`
  std::string symbol;  ///< "ΔT"
  std::string title;   ///< "Temperature of the machine"
  std::string source;  ///< equation or formula: "16, A.5"
  Effect effect = Effect::scale;
  uncertainty::Distribution distribution;
  std::string unit;  ///< of the distribution
  std::string note;  ///< "assumed", "from the sensors", "as given"; may be empty
};

/// Everything that is known about the inputs of a test.
struct UncertaintyInputs {
  std::vector<UncertaintyInput> inputs;
  double up_down_correlation = 1.0;  ///< between systematic effects on x↑ and x↓ at a target, eq. 10
  std::vector<std::string> notes;    ///< what was assumed
};

/// From the metadata, where `uncertainty.distributions` replaces or adds to what the single items say.
/// Empty inputs when nothing was given. Fails on a distribution that cannot be read or is not allowed, naming its
/// input, and on a correlation outside −1 to 1.
Result<UncertaintyInputs> uncertainty_inputs(const Metadata& metadata, const Series& series);

/// Which of two questions the uncertainty answers; named in every result.
enum class Measurand {
  this_test,     ///< what the same approaches would have given with perfect instruments at 20 °C
  this_machine,  ///< what the axis does in the long run: the sampling of n approaches counts too
};

std::string_view measurand_key(Measurand measurand);    ///< "this-test", "this-machine"
std::string_view measurand_title(Measurand measurand);  ///< a clause for reports

}  // namespace axiometry::iso230_2
