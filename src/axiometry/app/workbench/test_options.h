// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"

/// How a test of the archive is evaluated, beside what its file says.
namespace axiometry::app {

/// Metadata over what the file says: key and text as for `--set`, in the order given. An empty text takes the value
/// away. A list of records (equipment, sensors) has one record per line and takes the place of the file's list.
using Changes = std::vector<std::pair<std::string, std::string>>;

/// A log of temperatures about the test (4.1): a file of the archive, by its bytes.
struct KeptTemperatures {
  std::string sha256;
  std::string name;  ///< name of the file
  std::string began{}, ended{};
  formats::SensorRoles roles{};
  std::optional<double> lowest_C{}, highest_C{}, rate_C_per_h{}, gradient_C{};  ///< as the parties agreed (7)

  friend bool operator==(const KeptTemperatures&, const KeptTemperatures&) = default;
};

struct TestOptions {
  bool gum = true;  ///< costs a millisecond; Annex A is always there
  bool monte_carlo = false;
  std::optional<std::size_t> trials{};  ///< none: until two digits are stable
  std::uint64_t seed = 1;
  double coverage = 0.95;
  std::vector<std::string> corrections{};  ///< "nde", "air=ciddor", … as for --correct
  std::optional<KeptTemperatures> temperatures{};

  friend bool operator==(const TestOptions&, const TestOptions&) = default;
};

/// {"methods", "trials", "seed", "coverage", "corrections"}, and "temperatures" where there is a log.
json::Value to_json(const TestOptions& options);
json::Value to_json(const Changes& changes);

/// Members that are absent keep their default. Each fails, with line and column, on what is of another kind, on an
/// unknown member, method or correction, on trials outside 100 to 10 million, on a coverage outside 0.5 to 0.9999, and
/// of a log on a hash that is none, a role that is none and limits as the flags of `evaluate` refuse.
Result<TestOptions> test_options_from(const json::Value& value);

/// Fails on a key that the vocabulary does not have, and on texts as given_text() does; the values are checked by the
/// evaluation, which knows the kind of the axis.
Result<Changes> changes_from(const json::Value& value);

/// What evaluate_test() is asked for, but for the bytes of a log of temperatures. Fails on an unknown correction.
Result<EvaluateOptions> evaluate_options(const TestOptions& options);

/// Changes as EvaluateOptions::metadata wants them: a list of records is emptied, then given record by record.
std::vector<std::pair<std::string, std::string>> metadata_items(const Changes& changes);

}  // namespace axiometry::app
