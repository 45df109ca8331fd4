// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/text/text.h"
#include "axiometry/digest/sha256.h"
#include "server/routes/routes.h"

namespace axiometry::server {
namespace {

struct MediaType {
  std::string_view extension;
  std::string_view type;
};
constexpr std::array media_types = {
    MediaType{".html", "text/html; charset=utf-8"},
    MediaType{".js", "text/javascript; charset=utf-8"},
    MediaType{".css", "text/css; charset=utf-8"},
    MediaType{".svg", "image/svg+xml"},
    MediaType{".png", "image/png"},
    MediaType{".ico", "image/x-icon"},
    MediaType{".woff2", "font/woff2"},
    MediaType{".json", "application/json"},
    MediaType{".webmanifest", "application/manifest+json"},
    MediaType{".txt", "text/plain; charset=utf-8"},
};

constexpr std::string_view not_built = R"(<!doctype html><html lang="en"><meta charset="utf-8"><title>Axiometry</title>
<h1>The page is not built in</h1>
<p>This program was compiled without its page. In the source, run <code>npm install &amp;&amp; npm run build</code> in
<code>web/</code>, then build the program again. The API answers: see <a href="/api/openapi.json">openapi.json</a>.</p>
</html>
)";

struct PageFile {
  std::string_view name;
  std::string_view bytes;
  std::string_view zipped;  ///< empty where there is no NAME.gz
  std::string_view type;
  std::string tag;  ///< entity tag of the bytes: `"…"`
  bool is_immutable = false;
};

std::string_view media_type(std::string_view name) {
  const auto row = std::ranges::find_if(media_types, [&](const MediaType& t) { return name.ends_with(t.extension); });
  return row == media_types.end() ? std::string_view("application/octet-stream") : row->type;
}

/// "index-BxY3z0ab.js": the bundler's hash of eight characters. One without a digit may be a word, and is not trusted.
bool has_hash(std::string_view name) {
  const std::string_view stem = name.substr(0, name.rfind('.'));
  if (stem.size() < 10 || stem[stem.size() - 9] != '-') return false;
  const std::string_view hash = stem.substr(stem.size() - 8);
  return std::ranges::any_of(hash, [](char c) { return c >= '0' && c <= '9'; });
}

std::vector<PageFile> prepared(std::span<const EmbeddedFile> files) {
  std::vector<PageFile> page;
  for (const EmbeddedFile& file : files) {
    if (file.name.ends_with(".gz")) continue;
    const auto zipped = std::ranges::find(files, fmt::format("{}.gz", file.name), &EmbeddedFile::name);
    page.push_back({.name = file.name,
                    .bytes = file.bytes,
                    .zipped = zipped == files.end() ? std::string_view() : zipped->bytes,
                    .type = media_type(file.name),
                    .tag = fmt::format("\"{}\"", sha256(file.bytes).substr(0, 32)),
                    .is_immutable = has_hash(file.name)});
  }
  return page;
}

const PageFile* find_file(const std::vector<PageFile>& page, std::string_view name) {
  const auto found = std::ranges::find(page, name, &PageFile::name);
  return found == page.end() ? nullptr : &*found;
}

/// A word of a list as "gzip, deflate;q=0.5"; q=0 refuses it.
bool accepts_gzip(const Request& request) {
  for (const std::string_view item : text::split(request.header("accept-encoding").value_or(""), ',')) {
    const auto parts = text::split(item, ';');
    if (!text::equal_ignoring_case(text::trim(parts.front()), "gzip")) continue;
    const std::string_view weight = parts.size() > 1 ? text::trim(parts[1]) : std::string_view();
    return !(weight == "q=0" || weight.starts_with("q=0.0"));
  }
  return false;
}

bool knows_already(const Request& request, std::string_view tag) {
  for (const std::string_view item : text::split(request.header("if-none-match").value_or(""), ',')) {
    std::string_view known = text::trim(item);
    if (known.starts_with("W/")) known.remove_prefix(2);
    if (known == tag || known == "*") return true;
  }
  return false;
}

Response response_of(const PageFile& file, const Request& request) {
  const bool zipped = !file.zipped.empty() && accepts_gzip(request);
  std::string tag = file.tag;
  if (zipped) tag.insert(tag.size() - 1, "-gz");
  Response response{
      .content_type = std::string(file.type),
      .headers = {{"ETag", tag},
                  {"Cache-Control", file.is_immutable ? "public, max-age=31536000, immutable" : "no-cache"}}};
  if (!file.zipped.empty()) response.headers.emplace_back("Vary", "Accept-Encoding");
  if (knows_already(request, tag)) {
    response.status = 304;
    return response;
  }
  if (zipped) response.headers.emplace_back("Content-Encoding", "gzip");
  response.body = zipped ? file.zipped : file.bytes;
  return response;
}

}  // namespace

void add_page_routes(Router& router, std::span<const EmbeddedFile> files) {
  router.add_otherwise([page = prepared(files)](const Request& request) -> Result<Response> {
    if (const PageFile* file = find_file(page, std::string_view(request.path).substr(1)))
      return response_of(*file, request);
    const std::string_view last = std::string_view(request.path).substr(request.path.rfind('/') + 1);
    if (last.contains('.')) return refusal(404, "there is no file of this name", request.language);
    if (const PageFile* index = find_file(page, "index.html")) return response_of(*index, request);
    return Response{.status = 200, .content_type = "text/html; charset=utf-8", .body = std::string(not_built)};
  });
}

}  // namespace axiometry::server
