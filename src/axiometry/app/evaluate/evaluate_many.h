// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/evaluate/evaluate.h"

/// The tests of a file of many, evaluated on several threads and handed over in their order.
namespace axiometry::app {

/// What is made of every test of many on the thread that evaluates it. Called from several threads.
using MakeText = std::function<Result<std::string>(Evaluated& evaluated)>;
/// Called from one thread; the text is empty of the only test of a file.
using EvaluatedTextSink = std::function<Result<void>(Evaluated&& evaluated, std::string&& text)>;

struct ManyThreads {
  unsigned count = 0;  ///< 0: as many as the machine has
  MakeText make_text;  ///< may be empty
};

/// As evaluate_file() of evaluate.h. Where the tests of many are stated in full and no Monte Carlo runs (which has
/// threads of its own), they are evaluated side by side, so that some are read before the first is handed over.
Result<void> evaluate_file(const std::string& file, const EvaluateOptions& options, const ManyThreads& threads,
                           const EvaluatedTextSink& sink);

/// As evaluate_file(), once recognised. False for what was found in a folder and no format recognises: it is passed
/// over, unless it is to be read after a profile.
Result<bool> evaluate_input(const InputFile& input, const EvaluateOptions& options, const ManyThreads& threads,
                            const EvaluatedTextSink& sink);

/// Gathers tests and evaluates some at once, the other threads while this one reads the next and writes the last.
/// Whatever fails, all tests before it are handed over, and none after.
class TestsSideBySide {
 public:
  /// Called from several threads. An error that has neither file nor line gets the line where its test began.
  using Evaluate = std::function<Result<Evaluated>(Test&& test)>;

  TestsSideBySide(Evaluate evaluate, ManyThreads threads, EvaluatedTextSink sink);
  ~TestsSideBySide();
  TestsSideBySide(const TestsSideBySide&) = delete;
  TestsSideBySide& operator=(const TestsSideBySide&) = delete;

  Result<void> add(Test&& test, std::string name, std::size_t line);
  Result<void> finish();  ///< what has been gathered and not yet handed over

 private:
  struct Waiting {
    Test test;
    std::string name;
    std::size_t line = 0;
  };
  struct Finished {
    Result<Evaluated> evaluated;  ///< what was found, or why there is nothing, or no text of it
    std::string text;
  };
  class Batch;
  Finished finished(Waiting& waiting) const;
  std::size_t at_once() const;
  Result<void> next_batch();
  Result<void> hand_over(Batch& batch);

  Evaluate evaluate_;
  ManyThreads threads_;
  EvaluatedTextSink sink_;
  std::vector<Waiting> waiting_;
  std::size_t readings_ = 0;      ///< readings of those that wait
  std::unique_ptr<Batch> batch_;  ///< tests that are being evaluated
};

}  // namespace axiometry::app
