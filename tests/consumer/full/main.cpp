// SPDX-License-Identifier: Apache-2.0
#include <axiometry/app/evaluate/evaluate.h>
#include <axiometry/report/writer.h>

#include <cstdio>

int main(int argc, char** argv) {
  using namespace axiometry;
  if (argc != 2) return 1;
  std::size_t bytes = 0;
  const auto done = app::evaluate_file(argv[1], {}, [&](app::Evaluated&& e) -> Result<void> {
    auto page = report::find_writer("html")->write({e.test, e.assessment, e.judgements}, {});
    if (!page) return std::unexpected(page.error());
    bytes = page->size();
    return {};
  });
  if (!done) std::fprintf(stderr, "%s\n", done.error().to_string().c_str());
  std::printf("a report of %zu bytes\n", bytes);
  return done && bytes > 10000 ? 0 : 1;
}
