// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/results/outputs.h"

#include <gtest/gtest.h>

namespace axiometry::app {
namespace {

std::string fault_of_many(const std::string& report) {
  OutputNames names;
  names.reports = {report};
  const auto outputs = ManyOutputs::create(names, {});
  return outputs ? "" : outputs.error().message;
}

TEST(ManyOutputs, AreRefusedBeforeTheFirstTestWhereTheirFolderIsNotThere) {
  EXPECT_EQ(fault_of_many("no-such-folder/{name}.pdf"),
            "found no folder \"no-such-folder\" for the reports, expected one that is there");
  EXPECT_EQ(fault_of_many("{name}.pdf"), "");
  EXPECT_EQ(fault_of_many("./{name}.pdf"), "");
  EXPECT_EQ(fault_of_many("{name}/report.pdf"), "") << "not known before the name is";
}

}  // namespace
}  // namespace axiometry::app
