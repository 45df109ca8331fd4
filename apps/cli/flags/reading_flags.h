// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/evaluate/evaluate.h"
#include "cli/flags/verb.h"

/// How a measured file is read.
namespace axiometry::cli {

using MetadataPairs = std::vector<std::pair<std::string, std::string>>;

/// Remembers a key and its value; a UsageError where the vocabulary does not allow them.
void add_metadata(MetadataPairs& metadata, const std::string& key, const std::string& value);

/// --set KEY=VALUE, as often as it is given. What it says of itself ends with "; may be repeated".
void add_metadata_flag(const Verb& verb, MetadataPairs& metadata, const std::string& description);

/// --format and --set with such an example as "axis.kind=rotary".
void add_reading_flags(const Verb& verb, app::EvaluateOptions& reading, const std::string& example);

}  // namespace axiometry::cli
