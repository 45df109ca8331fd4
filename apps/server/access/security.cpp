// SPDX-License-Identifier: Apache-2.0
#include "server/access/security.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "axiometry/base/text/text.h"

namespace axiometry::server {
namespace {

constexpr std::string_view page_policy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; font-src 'self'; "
    "connect-src 'self'; frame-src 'self'; manifest-src 'self'; base-uri 'none'; form-action 'self'; "
    "frame-ancestors 'self'";

constexpr std::pair<std::string_view, std::string_view> always[] = {
    {"X-Content-Type-Options", "nosniff"},
    {"Referrer-Policy", "no-referrer"},
    {"Cross-Origin-Opener-Policy", "same-origin"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Permissions-Policy",
     "accelerometer=(), camera=(), display-capture=(), geolocation=(), gyroscope=(), magnetometer=(), microphone=(), "
     "payment=(), usb=()"},
    {"X-Frame-Options", "SAMEORIGIN"},
};

bool is_harmless(std::string_view policy) {
  return policy.starts_with("sandbox") && policy.contains("default-src 'none'") &&
         policy.contains("frame-ancestors 'self'") && !policy.contains("allow-scripts") &&
         !policy.contains("script-src");
}

bool has(const Response& response, std::string_view name) {
  return std::ranges::any_of(response.headers,
                             [&](const auto& header) { return text::equal_ignoring_case(header.first, name); });
}

}  // namespace

void add_security_headers(Response& response, bool tls) {
  const bool replaced = std::ranges::any_of(response.headers, [](const auto& header) {
    return text::equal_ignoring_case(header.first, "Content-Security-Policy") && is_harmless(header.second);
  });
  if (!replaced) response.headers.emplace_back("Content-Security-Policy", page_policy);
  std::erase_if(response.headers, [](const auto& header) {
    return std::ranges::any_of(always, [&](const auto& ours) { return ours.first == header.first; });
  });
  for (const auto& [name, value] : always) response.headers.emplace_back(name, value);
  if (tls) response.headers.emplace_back("Strict-Transport-Security", "max-age=31536000");
  if (response.content_type.ends_with("+xml")) response.content_type += "; charset=utf-8";
  if (!has(response, "Cache-Control")) response.headers.emplace_back("Cache-Control", "no-store");
}

}  // namespace axiometry::server
