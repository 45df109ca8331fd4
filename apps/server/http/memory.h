// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace axiometry::server {

/// Gives what the program has freed back to the system, where the library of C can: it would keep the hundreds of
/// megabytes of a large answer, for each of the threads. Takes some milliseconds.
void give_back_memory();

}  // namespace axiometry::server
