// SPDX-License-Identifier: Apache-2.0
#include <numeric>
#include <string>
#include <vector>

#include "connection.h"

namespace axiometry::server {
namespace {

struct Guests {
  std::vector<Guest*> all;
  std::vector<Standing> standings;  // in the same order
};

Guests guests_of(const ConnectionShare& share) {
  Guests guests;
  guests.all.assign(share.connections.begin(), share.connections.end());
  guests.standings.reserve(guests.all.size());
  for (const Guest* guest : guests.all) guests.standings.push_back(guest->standing());
  return guests;
}

}  // namespace

std::string peer_of(const boost::asio::ip::tcp::socket& socket) {
  boost::system::error_code code;
  const auto endpoint = socket.remote_endpoint(code);
  return code ? "" : endpoint.address().to_string();
}

bool ConnectionShare::make_room(const std::string& peer) {
  if (connections.size() < limits.connections_of_one) return true;
  const Guests guests = guests_of(*this);
  const Room room =
      room_for(guests.standings, peer, limits.connections, limits.connections_of_one, Standing::Clock::now());
  if (!room.is_full) return true;
  if (!room.goes) return false;
  guests.all[*room.goes]->give_way();
  return true;
}

bool ConnectionShare::make_memory(const Guest& guest, std::size_t bytes) {
  while (true) {
    const Guests guests = guests_of(*this);
    const std::size_t held = std::accumulate(guests.standings.begin(), guests.standings.end(), bytes,
                                             [](std::size_t sum, const Standing& one) { return sum + one.bytes; });
    if (held <= limits.held_bytes) return true;
    const auto goes = gives_back(guests.standings, guest.standing().peer, Standing::Clock::now());
    if (!goes || guests.all[*goes] == &guest) return false;
    guests.all[*goes]->give_way();
  }
}

}  // namespace axiometry::server
