// SPDX-License-Identifier: Apache-2.0
// Reports of stations, lines and periodic errors.
#include "axiometry/language/german.h"

namespace axiometry::language {
namespace {

constexpr Phrase rows[] = {
    {"none of these", "nichts davon"},
};

}  // namespace

const std::span<const Phrase> german_tracking{rows};

}  // namespace axiometry::language
