// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/tracking/length_difference.h"

namespace axiometry::cli {

class Verb;

/// `axiometry tracking length-difference`, and as an experiment of the paper with its figures for defaults.
void add_length_difference_verb(const Verb& parent, const std::string& description,
                                const app::LengthDifferenceRequest& defaults, int& exit_code);

}  // namespace axiometry::cli
