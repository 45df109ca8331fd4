// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

/// The clock on the wall of the program that links this: what the system calls CLOCK_REALTIME. It stands still but
/// where it is moved, also backwards, as clocks are that somebody sets.
namespace axiometry::world {

void set_clock_ms(std::int64_t since_1970);
void move_clock_ms(std::int64_t by);

}  // namespace axiometry::world
