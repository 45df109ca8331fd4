// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/evaluate_many.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <utility>

namespace axiometry::app {
namespace {

constexpr std::size_t tests_of_thread = 32;        // at once: the threads wait for the slowest of so many
constexpr std::size_t readings_at_once = 1 << 16;  // or fewer tests, if they are large

}  // namespace

/// Tests that other threads evaluate as soon as it exists, and in the end this one too.
class TestsSideBySide::Batch {
 public:
  Batch(const TestsSideBySide& owner, std::vector<Waiting> tests)
      : waiting(std::move(tests)), results(waiting.size()), thrown(waiting.size()), owner_(owner) {
    const std::size_t used = std::min<std::size_t>(owner.threads_.count, results.size());
    for (std::size_t k = 1; k < used; ++k) others_.emplace_back([this] { work(); });
  }
  ~Batch() { next_ = results.size(); }  // what nobody waits for is not begun

  void finish() {
    work();
    others_.clear();  // waits for them
  }

  std::vector<Waiting> waiting;
  std::vector<std::optional<Finished>> results;
  std::vector<std::exception_ptr> thrown;

 private:
  void work() {
    for (std::size_t k = next_++; k < results.size(); k = next_++) {
      try {
        results[k].emplace(owner_.finished(waiting[k]));
      } catch (...) {
        thrown[k] = std::current_exception();
      }
    }
  }

  const TestsSideBySide& owner_;
  std::atomic<std::size_t> next_ = 0;
  std::vector<std::jthread> others_;
};

TestsSideBySide::TestsSideBySide(Evaluate evaluate, ManyThreads threads, EvaluatedTextSink sink)
    : evaluate_(std::move(evaluate)), threads_(std::move(threads)), sink_(std::move(sink)) {
  if (threads_.count == 0) threads_.count = std::max(1u, std::thread::hardware_concurrency());
}

TestsSideBySide::~TestsSideBySide() = default;

// Tests are large: what is made of one is made where it stays, or moved once.
TestsSideBySide::Finished TestsSideBySide::finished(Waiting& waiting) const {
  Finished done{evaluate_(std::move(waiting.test)), {}};
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
  if (waiting_.size() < at_once() && readings_ < readings_at_once) return {};
  return threads_.count == 1 ? finish() : next_batch();
}

Result<void> TestsSideBySide::finish() {
  AXIOMETRY_TRY_VOID(next_batch());
  return next_batch();
}

/// What waits is begun before what is done is handed over, so that the other threads have work meanwhile.
Result<void> TestsSideBySide::next_batch() {
  const std::unique_ptr<Batch> done = std::exchange(batch_, nullptr);
  if (done) done->finish();
  if (!waiting_.empty()) batch_ = std::make_unique<Batch>(*this, std::exchange(waiting_, {}));
  readings_ = 0;
  if (!done) return {};
  auto handed_over = hand_over(*done);
  if (!handed_over) batch_.reset();
  return handed_over;
}

Result<void> TestsSideBySide::hand_over(Batch& batch) {
  for (std::size_t k = 0; k < batch.results.size(); ++k) {
    if (batch.thrown[k]) std::rethrow_exception(batch.thrown[k]);
    auto handed_over = Result<void>();
    if (Finished& result = *batch.results[k]; result.evaluated)
      handed_over = sink_(*std::move(result.evaluated), std::move(result.text));
    else
      handed_over = std::unexpected(std::move(result.evaluated).error());
    if (handed_over) continue;
    Error& error = handed_over.error();
    if (error.at.line == 0 && error.file.empty()) error.at.line = batch.waiting[k].line;
    return handed_over;
  }
  return {};
}

}  // namespace axiometry::app
