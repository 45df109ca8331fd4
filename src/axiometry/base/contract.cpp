// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/contract.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "axiometry/base/broken_contract.h"

namespace axiometry {
namespace {

std::atomic<int> throwing = 0;  // of the process, as abort() is

}  // namespace

ContractsThrow::ContractsThrow() { ++throwing; }
ContractsThrow::~ContractsThrow() { --throwing; }

void contract_broken(const char* condition, std::source_location where) {
  std::fprintf(stderr, "%s:%u: %s: contract broken: %s\n", where.file_name(), where.line(), where.function_name(),
               condition);
  if (throwing > 0) throw BrokenContract(std::string("contract broken: ") + condition);
  std::abort();
}

}  // namespace axiometry
