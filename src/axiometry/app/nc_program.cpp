// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/nc_program.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <vector>

#include "axiometry/app/output.h"
#include "axiometry/app/plan.h"
#include "axiometry/app/whole_file.h"
#include "axiometry/base/text.h"
#include "axiometry/standards/iso230_2_plan.h"

namespace axiometry::app {

Result<const nc::Dialect*> dialect_of(std::string_view id) {
  if (const nc::Dialect* dialect = nc::find_dialect(id)) return dialect;
  std::vector<std::string_view> known;
  for (const nc::Dialect* dialect : nc::dialect_table()) known.push_back(dialect->id);
  const auto near = text::nearest(id, known);
  return fail(fmt::format("found the unknown dialect {}, expected {}", text::quoted(id),
                          near ? fmt::format("perhaps {}", *near) : fmt::format("one of {}", fmt::join(known, ", "))));
}

Result<std::string> nc_program(const NcRequest& request) {
  AXIOMETRY_TRY(const nc::Dialect* const dialect, dialect_of(request.dialect));
  AXIOMETRY_TRY(const Plan plan, read_plan_file(request.plan));
  if (request.part < 1 || request.part > plan.further.size() + 1) {
    const std::string expected = plan.further.empty() ? "1" : fmt::format("1 to {}", plan.further.size() + 1);
    return std::unexpected(in_file(
        Error{fmt::format("found part {} asked for, expected {}", request.part, expected), {}, {}}, request.plan));
  }
  const Plan& part = request.part == 1 ? plan : plan.further[request.part - 2];
  nc::ProgramOptions options = request.options;
  options.duration = iso230_2::estimated_duration(part, iso230_2::usual_acceleration(part.axis.kind));
  return in_file(dialect->write({&part, 1}, options), request.plan);
}

Result<void> write_nc_program(const NcRequest& request, const std::string& output) {
  std::error_code none;  // where a file does not exist there is nothing to spare
  if (output != "-" && request.plan != "-" && std::filesystem::equivalent(request.plan, output, none))
    return std::unexpected(Error{"found the plan itself, expected another file for the program", output, {}});
  AXIOMETRY_TRY(const std::string program, nc_program(request));
  return write_file(output, program);
}

}  // namespace axiometry::app
