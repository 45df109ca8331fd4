// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace axiometry {

/// A broken contract, where it does not end the process.
class BrokenContract : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// While one of these lives, a broken contract is told as ever and then thrown as BrokenContract, in all threads: for a
/// program of many tasks, of which the one with the fault shall end and no other. What nobody catches still ends the
/// process, and so does a contract that breaks in a destructor.
class ContractsThrow {
 public:
  ContractsThrow();
  ~ContractsThrow();
  ContractsThrow(const ContractsThrow&) = delete;
  ContractsThrow& operator=(const ContractsThrow&) = delete;
};

}  // namespace axiometry
