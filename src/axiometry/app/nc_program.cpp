// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/nc_program.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <vector>

#include "axiometry/app/output.h"
#include "axiometry/app/source.h"
#include "axiometry/base/text.h"
#include "axiometry/formats/plan_json.h"

namespace axiometry::app {
namespace {

constexpr std::size_t plan_limit = std::size_t{64} << 20;

Result<Plan> read_plan_file(const std::string& name) {
  AXIOMETRY_TRY(Source source, Source::open(name));
  AXIOMETRY_TRY(const std::string bytes, source.read_all(plan_limit));
  auto plan = formats::read_plan(bytes);
  if (!plan) {
    Error error = std::move(plan).error();
    error.file = name;
    return std::unexpected(std::move(error));
  }
  return plan;
}

}  // namespace

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
    return std::unexpected(
        Error{fmt::format("found part {} asked for, expected {}", request.part, expected), request.plan, {}});
  }
  auto program = dialect->write(request.part == 1 ? plan : plan.further[request.part - 2], request.options);
  if (!program) return std::unexpected(Error{std::move(program).error().message, request.plan, {}});
  return program;
}

Result<void> write_nc_program(const NcRequest& request, const std::string& output) {
  std::error_code none;  // where a file does not exist there is nothing to spare
  if (output != "-" && request.plan != "-" && std::filesystem::equivalent(request.plan, output, none))
    return std::unexpected(Error{"found the plan itself, expected another file for the program", output, {}});
  AXIOMETRY_TRY(const std::string program, nc_program(request));
  return write_file(output, program);
}

}  // namespace axiometry::app
