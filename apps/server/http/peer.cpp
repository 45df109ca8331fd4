// SPDX-License-Identifier: Apache-2.0
#include "server/http/peer.h"

#include <algorithm>

namespace axiometry::server {

std::string peer_of(const boost::asio::ip::address& address) {
  namespace ip = boost::asio::ip;
  if (address.is_v4() || address.is_loopback()) return address.to_string();
  const ip::address_v6 whole = address.to_v6();
  if (whole.is_v4_mapped()) return ip::make_address_v4(ip::v4_mapped, whole).to_string();
  auto network = whole.to_bytes();
  std::fill(network.begin() + 8, network.end(), 0);
  return ip::address_v6(network, whole.scope_id()).to_string() + "/64";
}

}  // namespace axiometry::server
