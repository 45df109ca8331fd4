// SPDX-License-Identifier: Apache-2.0
#include "server/access/guard.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::server {
namespace {

constexpr std::array<std::string_view, 5> methods = {"GET", "HEAD", "POST", "PUT", "DELETE"};

constexpr std::array<std::string_view, 3> own_names = {"127.0.0.1", "localhost", "[::1]"};

bool only_reads(const Request& request) { return request.method == "GET" || request.method == "HEAD"; }

/// An address of IPv6 stands in brackets in a URL.
std::string host_text(std::string_view name) {
  const bool is_bare_v6 = std::ranges::count(name, ':') > 1 && !name.starts_with('[');
  return text::to_lower(is_bare_v6 ? fmt::format("[{}]", name) : std::string(name));
}

bool has_port(std::string_view host) {
  const std::size_t colon = host.rfind(':');
  return colon != std::string_view::npos && !host.substr(colon).contains(']');
}

/// Of a host as in a URL: letters, digits, hyphens and full stops, or an address of IPv6 in brackets.
bool is_name(std::string_view name) {
  const bool is_v6 = name.size() > 2 && name.starts_with('[') && name.ends_with(']');
  const std::string_view inner = is_v6 ? name.substr(1, name.size() - 2) : name;
  const std::string_view signs = is_v6 ? ":." : "-.";
  return !inner.empty() && std::ranges::all_of(inner, [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || signs.contains(c);
  });
}

const PublicAddress* public_address(const Site& site, std::string_view host) {
  const auto found = std::ranges::find_if(site.public_addresses, [&](const PublicAddress& address) {
    return std::ranges::find(address.hosts, host) != address.hosts.end();
  });
  return found == site.public_addresses.end() ? nullptr : &*found;
}

/// What a page of this server says of itself when it was asked for by that host.
std::string own_origin(const Site& site, const std::string& host) {
  const PublicAddress* address = public_address(site, host);
  return address != nullptr ? address->origin : fmt::format("{}://{}", site.scheme, host);
}

std::optional<Response> wrong_host(const Request& request, const Site& site) {
  const auto host = request.header("host");
  if (!host)
    return with_event(refusal(400, "found no header Host, expected one", request.language),
                      SecurityEvent::host_refused);
  const std::string name = text::to_lower(*host);
  if (std::ranges::find(site.hosts, name) != site.hosts.end() || public_address(site, name) != nullptr) return {};
  const std::string message = fmt::format(
      "found the host {}, expected {}; other names of this machine are given to 'axiometry serve' by "
      "--host-name, the address of a proxy by --public-address",
      text::quoted(*host), site.hosts.front());
  return with_event(refusal(421, message, request.language), SecurityEvent::host_refused);
}

std::optional<Response> foreign_page(const Request& request, const Site& site) {
  const auto origin = request.header("origin");
  const auto fetch_site = request.header("sec-fetch-site");
  const bool foreign_site = fetch_site && *fetch_site != "same-origin" && *fetch_site != "none";
  if (only_reads(request)) {
    const bool navigates = request.header("sec-fetch-mode").value_or("") == "navigate";
    if (!foreign_site || navigates || !request.path.starts_with("/api/")) return {};
    return refusal(403, "found a request that another page embeds, expected one of this page", request.language);
  }
  const std::string ours = own_origin(site, text::to_lower(request.header("host").value_or("")));
  const auto is_ours = [&](const std::string& said) {
    return said == ours ||
           std::ranges::find(site.public_addresses, said, &PublicAddress::origin) != site.public_addresses.end();
  };
  if (origin && !is_ours(text::to_lower(*origin)))
    return refusal(403,
                   fmt::format("found the origin {}, expected {}; the address of a proxy is given to 'axiometry serve' "
                               "by --public-address",
                               text::quoted(*origin), ours),
                   request.language);
  if (foreign_site)
    return refusal(403, "found a request that another page has sent, expected one of this page", request.language);
  return {};
}

}  // namespace

Result<PublicAddress> parse_public_address(std::string_view given) {
  const std::string text = text::to_lower(given);
  const bool tls = text.starts_with("https://");
  const std::string_view scheme = tls ? "https://" : "http://";
  const auto refused = [&](std::string_view expected) {
    return fail(fmt::format("found the public address {}, expected {}", text::quoted(given), expected));
  };
  constexpr std::string_view example = "one as https://calibration.example or https://calibration.example:8443";
  if (!text.starts_with(scheme)) return refused(example);
  std::string_view host = std::string_view(text).substr(scheme.size());
  if (host.ends_with('/')) host.remove_suffix(1);
  const std::size_t colon = has_port(host) ? host.rfind(':') : host.size();
  const std::string_view name = host.substr(0, colon);
  if (!is_name(name)) return refused(example);
  const unsigned usual_port = tls ? 443 : 80;
  const auto port = colon == host.size() ? usual_port : parse_count(host.substr(colon + 1)).value_or(0);
  if (port == 0 || port > 65'535) return refused(example);
  const bool is_local = std::ranges::find(own_names, name) != own_names.end();
  if (!tls && !is_local) return refused("one that begins with https://: what goes over http can be read and changed");
  const bool is_usual = port == usual_port;
  const std::string with_port = fmt::format("{}:{}", name, port);
  PublicAddress address{.origin = fmt::format("{}{}", scheme, is_usual ? std::string(name) : with_port),
                        .hosts = {with_port},
                        .is_local = is_local};
  if (is_usual) address.hosts.emplace_back(name);
  return address;
}

Site make_site(const SiteOptions& options) {
  Site site{.scheme = options.tls ? "https" : "http", .hosts = {}, .public_addresses = options.public_addresses};
  const unsigned usual_port = options.tls ? 443 : 80;
  std::vector<std::string> names(own_names.begin(), own_names.end());
  if (options.listen != "0.0.0.0" && options.listen != "::") names.insert(names.begin(), host_text(options.listen));
  for (const std::string& name : options.names) names.push_back(host_text(name));
  for (const std::string& name : names) {
    if (has_port(name)) {
      site.hosts.push_back(name);
      continue;
    }
    site.hosts.push_back(fmt::format("{}:{}", name, options.port));
    if (options.port == usual_port) site.hosts.push_back(name);
  }
  return site;
}

std::optional<Response> refused_by_guard(const Request& request, const Site& site) {
  if (std::ranges::find(methods, request.method) == methods.end()) {
    Response response = refusal(
        405, fmt::format("found the method {}, expected GET, HEAD, POST, PUT or DELETE", text::quoted(request.method)),
        request.language);
    response.headers.emplace_back("Allow", "GET, HEAD, POST, PUT, DELETE");
    return with_event(std::move(response), SecurityEvent::method_refused);
  }
  if (auto refused = wrong_host(request, site)) return refused;
  auto refused = foreign_page(request, site);
  if (refused) refused->event = SecurityEvent::origin_refused;
  return refused;
}

}  // namespace axiometry::server
