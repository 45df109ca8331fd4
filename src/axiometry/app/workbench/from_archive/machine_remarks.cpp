// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/from_archive/machine_remarks.h"

#include <fmt/format.h>

#include <set>
#include <utility>

#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

Result<std::vector<std::string>> remarks_on(const store::Transaction& archive, const store::MachineRecord& stated) {
  AXIOMETRY_TRY(const store::MachineMeant meant, archive.meant(stated));
  std::vector<std::string> remarks;
  if (meant.takes_number)
    remarks.push_back(fmt::format("machine {} had no serial number and takes over {}, which this test states",
                                  meant.known->id, text::quoted(stated.serial_number)));
  const auto has_number = [](const store::MachineRecord& machine) {
    return !text::trim(machine.serial_number).empty();
  };
  const bool by_number = meant.known && !meant.takes_number && has_number(stated) && !stated.name.empty();
  if (by_number && !text::equal_ignoring_case(text::trim(stated.name), text::trim(meant.known->value.name)))
    remarks.push_back(fmt::format(
        "this test calls its machine {}: by the serial number {} alone it is kept with machine {}, called {}",
        text::quoted(stated.name), text::quoted(stated.serial_number), meant.known->id,
        text::quoted(meant.known->value.name)));
  if (meant.known && !has_number(stated) && has_number(meant.known->value))
    remarks.push_back(
        fmt::format("this test states no serial number: by the name {} alone it is kept with machine {}, whose number "
                    "is {}",
                    text::quoted(stated.name), meant.known->id, text::quoted(meant.known->value.serial_number)));
  if (meant.others > 0)
    remarks.push_back(fmt::format(
        "{} machines of the archive are called {}, and no serial number in this test tells them apart: it is "
        "kept with a machine without a number",
        meant.others + (meant.known ? 1 : 0), text::quoted(stated.name)));
  return remarks;
}

}  // namespace

Result<std::vector<std::vector<std::string>>> machine_remarks(const store::Transaction& archive,
                                                              std::span<const store::NewTest> tests) {
  std::set<std::pair<std::string, std::string>> told;
  std::vector<std::vector<std::string>> all;
  for (const store::NewTest& test : tests) {
    auto& remarks = all.emplace_back();
    const store::MachineRecord& machine = test.state.machine;
    if (!told.emplace(machine.name, machine.serial_number).second) continue;
    AXIOMETRY_TRY(remarks, remarks_on(archive, machine));
  }
  return all;
}

}  // namespace axiometry::app
