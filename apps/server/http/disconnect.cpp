// SPDX-License-Identifier: Apache-2.0
#include "server/http/disconnect.h"

#include <poll.h>

namespace axiometry::server {

bool has_left(int socket) {
  pollfd descriptor{.fd = socket, .events = POLLRDHUP, .revents = 0};
  return ::poll(&descriptor, 1, 0) > 0 && (descriptor.revents & (POLLRDHUP | POLLHUP | POLLERR)) != 0;
}

}  // namespace axiometry::server
