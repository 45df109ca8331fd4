// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/files/given_file.h"
#include "axiometry/app/results/experiment.h"
#include "axiometry/app/volumetric/gathered_lengths.h"
#include "axiometry/app/volumetric/identify_options.h"
#include "axiometry/base/result.h"
#include "axiometry/volumetric/identify/identification.h"

/// The use case "from lengths of a tracking interferometer to the 21 errors of the machine".
namespace axiometry::app {

struct IdentifyRequest {
  LengthsRequest lengths;
  std::string machine = {};  ///< JSON, formats/volumetric/machine_json.h; empty: that of the plan
  std::string plan = {};     ///< JSON, formats/volumetric/volumetric_plan_json.h; may be empty where a machine is named
  volumetric::IdentifyOptions options = {};
};

struct IdentifiedMachine {
  IdentifyRequest request;
  std::vector<LengthsFile> files;
  std::string machine_sha256;  ///< hash of the file of the machine, or of the plan that has it
  std::string plan_sha256;     ///< empty without a plan
  volumetric::MachineModel machine;
  volumetric::VolumetricLengths lengths;

  /// The file in which the machine stands.
  const std::string& machine_file() const { return request.machine.empty() ? request.plan : request.machine; }
  volumetric::Identification identification;  ///< its findings hold the remarks of the readers too
};

/// Fails as the files, and as gather_lengths() and volumetric::identify() do, with the file's name, and without machine
/// and plan. Of two machines that of its own file counts, and it is told where they differ.
Result<IdentifiedMachine> identify_lengths(const IdentifyRequest& request);

/// Files that are at hand; none is looked for under their names.
struct IdentifyFiles {
  std::vector<GivenFile> lengths;
  std::optional<GivenFile> machine, plan;  ///< one of them at least
  std::stop_token stop{};                  ///< nobody waits for the answer any more
};

using LengthsCheck = std::function<Result<void>(const volumetric::VolumetricLengths& lengths)>;

/// The same of these. Fails also as `check` does, which sees the lengths before anything is computed.
Result<IdentifiedMachine> identify_lengths(const IdentifyFiles& files, const IdentifyChoices& choices,
                                           const LengthsCheck& check);

/// Keys: docs/results.md.
json::Value to_json(const IdentifiedMachine& identified);

/// Report and JSON.
Experiment present(const IdentifiedMachine& identified, const report::Options& options);

/// The lengths that were used, as `volumetric identify` reads them; where they came from stands above as comments.
std::string gathered_table(const IdentifiedMachine& identified);

/// Each reading with its residual, as CSV.
std::string residuals_csv(const IdentifiedMachine& identified);

}  // namespace axiometry::app
