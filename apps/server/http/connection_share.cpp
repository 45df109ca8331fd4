// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/http/connection.h"
#include "server/http/peer.h"

namespace axiometry::server {
namespace {

constexpr std::size_t small_answer = std::size_t{16} << 10;  // an answer this small is never refused for want of memory
constexpr std::string_view no_memory_for_answers =
    "found more answers on their way than the server has memory for, expected fewer";

struct Guests {
  std::vector<Guest*> all;
  std::vector<ConnectionState> states;  // of all, in the same order
};

Guests guests_of(const ConnectionShare& share) {
  Guests guests;
  guests.all.assign(share.connections.begin(), share.connections.end());
  guests.states.reserve(guests.all.size());
  for (const Guest* guest : guests.all) guests.states.push_back(guest->state());
  return guests;
}

}  // namespace

std::string peer_of(const boost::asio::ip::tcp::socket& socket) {
  boost::system::error_code code;
  const auto endpoint = socket.remote_endpoint(code);
  return code ? "" : peer_of(endpoint.address());
}

void ConnectionShare::tell_of_answer(const Request& request, const Response& response,
                                     std::chrono::nanoseconds took) const {
  if (!service.answered) return;
  service.answered({.request = request,
                    .status = response.status,
                    .bytes = response.body.size(),
                    .milliseconds = std::chrono::duration<double, std::milli>(took).count()});
}

void ConnectionShare::tell_of_event(const Request& request, const Response& response) const {
  if (service.secured && response.event != SecurityEvent::none) service.secured(request, response);
}

bool ConnectionShare::make_room(const std::string& peer) {
  if (connections.size() < limits.connections_of_one) return true;
  const Guests guests = guests_of(*this);
  const Room room =
      room_for(guests.states, peer, limits.connections, limits.connections_of_one, ConnectionState::Clock::now());
  if (!room.is_full) return true;
  if (!room.goes) {
    Request unread;
    unread.peer = peer;
    tell_of_event(unread, {.status = 0, .event = SecurityEvent::quota_refused});
    return false;
  }
  guests.all[*room.goes]->make_room();
  return true;
}

bool ConnectionShare::make_memory(const Guest& guest, std::size_t bytes) {
  Guests guests = guests_of(*this);
  const ConnectionState asker = guest.state();
  const bool of_body = asker.doing == ConnectionState::Doing::receiving;
  const MemoryClaim claim{.peer = asker.peer, .bytes = bytes, .of_body = of_body, .held = of_body ? asker.bytes : 0};
  std::vector<Guest*> going;
  while (true) {
    const Room room = memory_for(guests.states, claim, limits.held_bytes, ConnectionState::Clock::now());
    if (!room.is_full) break;
    if (!room.goes || guests.all[*room.goes] == &guest) return false;
    going.push_back(guests.all[*room.goes]);
    guests.states[*room.goes].bytes = 0;
  }
  for (Guest* one : going) one->make_room();
  return true;
}

std::shared_ptr<const Response> ConnectionShare::as_fits(const Guest& guest, std::shared_ptr<const Response> response,
                                                         const Request& request) {
  const std::size_t size = response->body.size();
  if (size <= small_answer || response->status / 100 != 2 || make_memory(guest, size)) return response;
  if (response->is_receipt) return std::make_shared<const Response>(receipt_of(*response, request.language));
  Response refused =
      with_event(busy(no_memory_for_answers, ask_again_soon, request.language), SecurityEvent::quota_refused);
  service.finish(refused);
  tell_of_event(request, refused);
  return std::make_shared<const Response>(std::move(refused));
}

}  // namespace axiometry::server
