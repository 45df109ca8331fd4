// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/store/store.h"
#include "cli/exit_code.h"

/// `axiometry store verify` and `axiometry store seal`.
namespace axiometry::cli {

struct ProofFlags {
  std::vector<std::string> seals;  ///< files of seals
  std::string public_key;          ///< key by which the seals must be made; empty: not asked
  bool json = false;
  std::vector<std::string> heads{};  ///< heads of archives, as reports say them
  std::string authority{};           ///< file of certificates whose time stamps the seals must have; empty: not asked
};

/// Prints what was proved, what is wrong and what nobody can see.
Result<int> verify_archive(const store::Store& archive, const ProofFlags& flags);

struct SealFlags {
  std::string file;         ///< the seal; one that is there is followed by a newer one
  std::string key;          ///< file of the key; empty: beside the archive
  bool change_key = false;  ///< also where another key has signed the seal that is there
  std::string authority{};  ///< address of one that stamps the seal; empty: none
};

Result<int> seal_archive(const store::Store& archive, const SealFlags& flags);

}  // namespace axiometry::cli
