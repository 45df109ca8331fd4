// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

/// The clocks of the program that links this. That on the wall, which the system calls CLOCK_REALTIME, stands still but
/// where it is moved, also backwards, as clocks are that somebody sets. CLOCK_MONOTONIC goes on by a
/// little whenever it is asked. Who sleeps finds both moved, and has not waited.
namespace axiometry::world {

void move_clock_ms(std::int64_t by);  ///< that on the wall
void pass_ms(std::int64_t by);        ///< both

}  // namespace axiometry::world
