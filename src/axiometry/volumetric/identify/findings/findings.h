// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axiometry/volumetric/identify/identifier.h"

/// What is to be told about an identification. Internal to identify().
namespace axiometry::volumetric::detail {

/// Serious ones first.
std::vector<VolumetricFinding> findings_of(const Identifier& done, const MachineModel& machine,
                                           const VolumetricLengths& lengths, const Identification& result);

/// What looks wrong with tools and stations: offsets that several stations contradict alike, axes or signs that are
/// mixed up, stations that stand elsewhere than was said or have moved. In setup_findings.cpp.
void add_setup_findings(const Identifier& done, const MachineModel& machine, const VolumetricLengths& lengths,
                        const Identification& result, std::vector<VolumetricFinding>& findings);

/// Travels so short that their numbers look like inches; all are read as millimetres.
std::optional<VolumetricFinding> small_machine_finding(const MachineModel& machine);

}  // namespace axiometry::volumetric::detail
