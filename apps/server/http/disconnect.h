// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace axiometry::server {

/// Whether the other end of a connected socket has closed it, wholly or for sending. Reads nothing, so that it is seen
/// behind what was sent ahead, and through TLS.
bool has_left(int socket);

}  // namespace axiometry::server
