// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/evaluate/recognised.h"
#include "axiometry/base/result.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/formats/table/generic_delimited.h"
#include "axiometry/model/test.h"

/// A file of measured tests, read from bytes.
namespace axiometry::app {

/// Bytes with their SHA-256, which is made once.
struct HashedBytes {
  std::string_view bytes;
  std::string sha256;
  std::optional<Recognised> recognised{};  ///< what they were recognised as, where that was looked at before

  static HashedBytes of(std::string_view bytes) { return {bytes, axiometry::sha256(bytes)}; }
};

struct MeasuredTest {
  std::string name;  ///< name of one among many; else empty
  Test test;         ///< as it was measured
};

struct MeasuredFile {
  std::string sha256;
  std::size_t size = 0;
  std::size_t memory = 0;           ///< bytes that the tests take, about; what stands above a table is in each of them
  std::string format;               ///< id of the format
  std::vector<MeasuredTest> tests;  ///< never empty
  /// About the table, where the test was read after one.
  std::optional<formats::Guess> guess{};

  /// nullptr when there is none of that name.
  const Test* find(std::string_view name) const;
};

/// Whatever `axiometry evaluate` reads, recognised by its content and not by the name. Fails as the format does, with
/// the name and the place; on a recording, a plan or a file of lines in space, saying what to do with it; on more than
/// 2000 tests, or 128 MiB of memory for all of them; and on more than 100 pieces of equipment in one. With a profile:
/// the one test that the table holds by it, and a remark that says so.
Result<MeasuredFile> read_measured(const HashedBytes& sent, const std::string& name,
                                   const std::optional<formats::ImportProfile>& profile = {});

/// What a person may be asked about a file that is no recording: the guess about the table in it. Nothing where there
/// is no table.
std::optional<formats::Guess> guess_measured(std::string_view bytes);

}  // namespace axiometry::app
