// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/flags/verb.h"

namespace axiometry::cli {

/// Defined in verb.cpp, which knows CLI11. Of an option that leaves the others of its verb without a use, such as
/// --list: throws UsageError where it was given and one that is not among `beside` too.
void check_alone(const Verb& verb, const std::string& name, const std::vector<std::string>& beside = {});

/// The names of the options that a verb has so far, those of its groups too.
std::vector<std::string> option_names(const Verb& verb);

}  // namespace axiometry::cli
