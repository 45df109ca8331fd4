// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/formats/text/json_members.h"

/// Members that requests of the workbench have, and files have not: switches, numbers that may be left out.
namespace axiometry::app {

/// Replaces `target` when the member is there. Fails on anything but true and false.
Result<void> take_switch(formats::JsonMembers& members, std::string_view name, bool& target);

/// Likewise. Fails on what is no number.
Result<void> take_number(formats::JsonMembers& members, std::string_view name, std::optional<double>& target);

struct WholeNumbers {
  double least;
  double most;
};
/// Absent when the member is. Fails on a number that is none of them.
Result<std::optional<double>> whole_member(formats::JsonMembers& members, std::string_view name, WholeNumbers range);

}  // namespace axiometry::app
