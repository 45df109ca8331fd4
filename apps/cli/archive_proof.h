// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/store/store.h"
#include "commands.h"

/// `axiometry store verify` and `axiometry store seal`.
namespace axiometry::cli {

struct ProofFlags {
  std::vector<std::string> seals;  ///< files
  std::string public_key;          ///< of whom the seals must be; empty: not asked
  bool json = false;
};

/// Prints what was proved, what is wrong and what nobody can see.
Result<int> verify_archive(const store::Store& archive, const ProofFlags& flags);

struct SealFlags {
  std::string file;  ///< the seal; one that is there is followed by a newer one
  std::string key;   ///< file of the key; empty: beside the archive
};

Result<int> seal_archive(const store::Store& archive, const SealFlags& flags);

}  // namespace axiometry::cli
