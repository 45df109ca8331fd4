// SPDX-License-Identifier: Apache-2.0
#include "server/access/sessions.h"

#include <fmt/format.h>
#include <openssl/rand.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "axiometry/digest/sha256.h"

namespace axiometry::server {
namespace {

std::string random_text() {
  std::array<unsigned char, 32> bytes{};
  if (::RAND_bytes(bytes.data(), static_cast<int>(bytes.size())) != 1)
    throw std::runtime_error("found no random numbers for a session");
  std::string text;
  for (const unsigned char byte : bytes) text += fmt::format("{:02x}", byte);
  return text;
}

}  // namespace

bool Sessions::is_over(const Times& times, Clock::time_point now) {
  return now - times.began >= longest || now - times.used >= unused;
}

Sessions::Begun Sessions::begin(Clock::time_point now) {
  std::string session = random_text();
  const std::scoped_lock lock(mutex_);
  if (all_.size() >= most) std::erase_if(all_, [&](const auto& entry) { return is_over(entry.second, now); });
  const bool ends_another = all_.size() >= most;
  if (ends_another) all_.erase(std::ranges::min_element(all_, {}, [](const auto& entry) { return entry.second.used; }));
  all_.emplace(sha256(session), Times{now, now});
  return {std::move(session), ends_another};
}

bool Sessions::knows(std::string_view session, Clock::time_point now) {
  const std::string hash = sha256(session);
  const std::scoped_lock lock(mutex_);
  const auto found = all_.find(hash);
  if (found == all_.end()) return false;
  if (is_over(found->second, now)) {
    all_.erase(found);
    return false;
  }
  found->second.used = now;
  return true;
}

bool Sessions::end(std::string_view session) {
  const std::string hash = sha256(session);
  const std::scoped_lock lock(mutex_);
  return all_.erase(hash) > 0;
}

std::size_t Sessions::count() const {
  const std::scoped_lock lock(mutex_);
  return all_.size();
}

}  // namespace axiometry::server
