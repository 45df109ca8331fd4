// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/evaluate_many.h"

#include <algorithm>
#include <exception>
#include <thread>
#include <utility>

#include "axiometry/numeric/side_by_side.h"

namespace axiometry::app {
namespace {

constexpr std::size_t tests_of_thread = 32;        // at once: the threads wait for the slowest of so many
constexpr std::size_t readings_at_once = 1 << 16;  // or fewer tests, if they are large

}  // namespace

TestsSideBySide::TestsSideBySide(Evaluate evaluate, ManyThreads threads, EvaluatedTextSink sink)
    : evaluate_(std::move(evaluate)), threads_(std::move(threads)), sink_(std::move(sink)) {
  if (threads_.count == 0) threads_.count = std::max(1u, std::thread::hardware_concurrency());
}

// Tests are large: what is made of one is made where it stays, or moved once.
TestsSideBySide::Done TestsSideBySide::done(Waiting& waiting) const {
  Done done{evaluate_(std::move(waiting.test)), {}};
  if (!done.evaluated) return done;
  done.evaluated->name = std::move(waiting.name);
  if (!threads_.make_text) return done;
  auto text = threads_.make_text(*done.evaluated);
  if (text)
    done.text = *std::move(text);
  else
    done.evaluated = std::unexpected(std::move(text).error());
  return done;
}

std::size_t TestsSideBySide::at_once() const { return threads_.count == 1 ? 1 : tests_of_thread * threads_.count; }

Result<void> TestsSideBySide::add(Test&& test, std::string name, std::size_t line) {
  readings_ += test.series.reading_count();
  if (waiting_.empty()) waiting_.reserve(at_once());
  waiting_.emplace_back(std::move(test), std::move(name), line);
  return waiting_.size() < at_once() && readings_ < readings_at_once ? Result<void>{} : finish();
}

Result<void> TestsSideBySide::finish() {
  std::vector<std::optional<Done>> results(waiting_.size());
  std::vector<std::exception_ptr> thrown(waiting_.size());
  numeric::side_by_side(waiting_.size(), threads_.count, [&](std::size_t k) {
    try {
      results[k].emplace(done(waiting_[k]));
    } catch (...) {
      thrown[k] = std::current_exception();
    }
  });
  const std::vector<Waiting> waited = std::exchange(waiting_, {});
  readings_ = 0;
  for (std::size_t k = 0; k < results.size(); ++k) {
    if (thrown[k]) std::rethrow_exception(thrown[k]);
    auto handed_over = Result<void>();
    if (Done& result = *results[k]; result.evaluated)
      handed_over = sink_(*std::move(result.evaluated), std::move(result.text));
    else
      handed_over = std::unexpected(std::move(result.evaluated).error());
    if (handed_over) continue;
    if (Error& error = handed_over.error(); error.at.line == 0 && error.file.empty()) error.at.line = waited[k].line;
    return handed_over;
  }
  return {};
}

}  // namespace axiometry::app
