// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "server/routes/routes.h"

namespace axiometry::server {
namespace {

const std::vector<EmbeddedFile> files = {{"app.css", "body{}"},           {"app.js", "run()"},
                                         {"app.js.gz", "zipped"},         {"chart-settings.js", "chart()"},
                                         {"font-BxY3z0ab.woff2", "font"}, {"index.html", "<!doctype html>"}};

Response get(const std::string& path, Pairs headers = {}, std::span<const EmbeddedFile> page = files,
             std::string method = "GET") {
  Router router;
  add_page_routes(router, page);
  return router.answer({.method = std::move(method),
                        .path = path,
                        .query = {},
                        .headers = std::move(headers),
                        .body = {},
                        .actor = {},
                        .captured = {}});
}

std::optional<std::string> header(const Response& response, const std::string& name) {
  for (const auto& [each, value] : response.headers)
    if (each == name) return value;
  return {};
}

TEST(PageRoutes, give_each_file_with_its_type) {
  EXPECT_EQ(get("/app.js").body, "run()");
  EXPECT_EQ(get("/app.js").content_type, "text/javascript; charset=utf-8");
  EXPECT_EQ(get("/app.css").content_type, "text/css; charset=utf-8");
  EXPECT_EQ(get("/font-BxY3z0ab.woff2").content_type, "font/woff2");
}

TEST(PageRoutes, answer_every_path_of_the_page_with_the_page) {
  for (const std::string path : {"/", "/tests/3", "/machines/", "/nothing"}) {
    EXPECT_EQ(get(path).status, 200) << path;
    EXPECT_EQ(get(path).body, "<!doctype html>") << path;
  }
  EXPECT_EQ(get("/missing.js").status, 404);
  EXPECT_EQ(get("/api").status, 404);
  EXPECT_EQ(get("/api/nothing").status, 404);
  EXPECT_EQ(get("/tests", {}, files, "POST").status, 405);
}

TEST(PageRoutes, let_browsers_keep_for_good_only_what_is_called_by_its_hash) {
  EXPECT_THAT(*header(get("/font-BxY3z0ab.woff2"), "Cache-Control"), ::testing::HasSubstr("immutable"));
  for (const std::string path : {"/", "/index.html", "/app.js", "/chart-settings.js"})
    EXPECT_EQ(header(get(path), "Cache-Control"), "no-cache") << path;
}

TEST(PageRoutes, send_nothing_that_the_browser_has) {
  const std::string tag = header(get("/app.css"), "ETag").value();
  EXPECT_EQ(get("/app.css", {{"if-none-match", "\"other\", W/" + tag}}).status, 304);
  EXPECT_EQ(get("/app.css", {{"if-none-match", tag}}).body, "");
  EXPECT_EQ(get("/app.js", {{"if-none-match", tag}}).status, 200);
}

TEST(PageRoutes, send_compressed_files_to_who_takes_them) {
  const Response zipped = get("/app.js", {{"accept-encoding", "deflate, gzip, br"}});
  EXPECT_EQ(zipped.body, "zipped");
  EXPECT_EQ(header(zipped, "Content-Encoding"), "gzip");
  EXPECT_EQ(zipped.content_type, "text/javascript; charset=utf-8");
  EXPECT_NE(header(zipped, "ETag"), header(get("/app.js"), "ETag"));
  EXPECT_EQ(get("/app.js", {{"accept-encoding", "gzip;q=0"}}).body, "run()");
  EXPECT_EQ(get("/app.css", {{"accept-encoding", "gzip"}}).body, "body{}");
  EXPECT_EQ(header(get("/app.js"), "Vary"), "Accept-Encoding");
}

TEST(PageRoutes, say_how_to_build_a_page_that_is_not_there) {
  EXPECT_THAT(get("/", {}, {}).body, ::testing::HasSubstr("npm run build"));
}

}  // namespace
}  // namespace axiometry::server
