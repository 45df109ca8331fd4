// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/contract.h"

#include <gtest/gtest.h>

#include <string>

#include "axiometry/base/broken_contract.h"

namespace axiometry {
namespace {

void break_one() { AXIOMETRY_CONTRACT(1 + 1 == 3); }

TEST(ContractDeathTest, ends_the_process_where_nobody_asked_for_more) {
  EXPECT_DEATH(break_one(), "contract broken: 1 \\+ 1 == 3");
}

TEST(Contract, is_thrown_while_that_is_asked_for) {
  const ContractsThrow asked;
  try {
    break_one();
    FAIL() << "nothing was thrown";
  } catch (const BrokenContract& broken) {
    EXPECT_EQ(std::string(broken.what()), "contract broken: 1 + 1 == 3");
  }
}

TEST(ContractDeathTest, ends_the_process_again_afterwards) {
  { const ContractsThrow asked; }
  EXPECT_DEATH(break_one(), "contract broken");
}

}  // namespace
}  // namespace axiometry
