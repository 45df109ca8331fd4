// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "axiometry/app/files/given_file.h"
#include "axiometry/app/results/experiment.h"
#include "axiometry/base/result.h"
#include "axiometry/volumetric/identify/identification.h"

/// The use case "from lengths of a tracking interferometer to the 21 errors of the machine".
namespace axiometry::app {

struct IdentifyRequest {
  std::string lengths;  ///< CSV, formats/volumetric/volumetric_lengths_csv.h; "-" is the standard input
  std::string machine;  ///< JSON, formats/volumetric/machine_json.h
  volumetric::IdentifyOptions options = {};
};

struct IdentifiedMachine {
  IdentifyRequest request;
  std::string lengths_sha256, machine_sha256;
  volumetric::MachineModel machine;
  volumetric::VolumetricLengths lengths;
  volumetric::Identification identification;  ///< its findings hold the remarks of the readers too
};

/// Fails as the files, and as volumetric::identify() does, with the file's name.
Result<IdentifiedMachine> identify_lengths(const IdentifyRequest& request);

/// The same of files that are at hand.
Result<IdentifiedMachine> identify_lengths(const GivenFile& lengths, const GivenFile& machine,
                                           const volumetric::IdentifyOptions& options);

/// Keys: docs/results.md.
json::Value to_json(const IdentifiedMachine& identified);

/// Report and JSON.
Experiment present(const IdentifiedMachine& identified, const report::Options& options);

/// Each reading with its residual, as CSV.
std::string residuals_csv(const IdentifiedMachine& identified);

}  // namespace axiometry::app
