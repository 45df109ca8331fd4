// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/asio/ip/address.hpp>
#include <string>

namespace axiometry::server {

/// Whom an address stands for: one of IPv4 for itself, also where it is written as one of IPv6; one of IPv6 for its
/// network, "2001:db8:0:7::/64", any address of which the same machine may give itself; and ::1 for this machine.
std::string peer_of(const boost::asio::ip::address& address);

}  // namespace axiometry::server
