// SPDX-License-Identifier: Apache-2.0
#include "guard.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "axiometry/base/text.h"

namespace axiometry::server {
namespace {

constexpr std::array<std::string_view, 5> methods = {"GET", "HEAD", "POST", "PUT", "DELETE"};

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

std::optional<Response> wrong_host(const Request& request, const Site& site) {
  const auto host = request.header("host");
  if (!host) return refusal(400, "found no header Host, expected one", request.language);
  if (std::ranges::find(site.hosts, text::to_lower(*host)) != site.hosts.end()) return {};
  return refusal(421,
                 fmt::format("found the host {}, expected {}; other names of this machine are given to 'axiometry "
                             "serve' by --host-name",
                             text::quoted(*host), site.hosts.front()),
                 request.language);
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
  const std::string ours = fmt::format("{}://{}", site.scheme, text::to_lower(request.header("host").value_or("")));
  if (origin && text::to_lower(*origin) != ours)
    return refusal(403, fmt::format("found the origin {}, expected {}", text::quoted(*origin), ours), request.language);
  if (foreign_site)
    return refusal(403, "found a request that another page has sent, expected one of this page", request.language);
  return {};
}

}  // namespace

Site make_site(const SiteOptions& options) {
  Site site{.scheme = options.tls ? "https" : "http", .hosts = {}};
  const unsigned usual_port = options.tls ? 443 : 80;
  std::vector<std::string> names = {"127.0.0.1", "localhost", "[::1]"};
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
    return response;
  }
  if (auto refused = wrong_host(request, site)) return refused;
  return foreign_page(request, site);
}

}  // namespace axiometry::server
