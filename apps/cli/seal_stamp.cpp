// SPDX-License-Identifier: Apache-2.0
#include "cli/seal_stamp.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "axiometry/app/files/output.h"
#include "axiometry/app/files/whole_file.h"
#include "server/http/post.h"

namespace axiometry::cli {
namespace {

bool is_stamp_of(const std::string& stamp_file, std::string_view seal) {
  const auto stamp = app::whole_file(stamp_file);
  return stamp && check_stamped(*stamp, seal);
}

/// Whether the seal has its stamp under the new name, and none under the other.
bool has_stamp_under_new_name(const SealFile& seal) {
  return !is_stamp_of(stamp_name(seal.name), seal.bytes) && is_stamp_of(new_stamp_name(seal.name), seal.bytes);
}

/// Likewise of the one that is there now.
bool has_stamp_under_new_name(const std::string& seal_file) {
  auto bytes = app::whole_file(seal_file);
  return bytes && has_stamp_under_new_name(SealFile{seal_file, *std::move(bytes)});
}

Result<void> remove_new_stamp(const std::string& seal_file) {
  std::error_code code;
  std::filesystem::remove(new_stamp_name(seal_file), code);
  if (code) return std::unexpected(Error{"cannot remove: " + code.message(), new_stamp_name(seal_file), {}});
  return {};
}

/// A copy first, so that it is never without a name.
Result<void> take_usual_name(const std::string& seal_file) {
  AXIOMETRY_TRY(const std::string stamp, app::whole_file(new_stamp_name(seal_file)));
  AXIOMETRY_TRY_VOID(app::write_file(stamp_name(seal_file), stamp));
  return remove_new_stamp(seal_file);
}

}  // namespace

std::string stamp_name(const std::string& seal_file) { return seal_file + ".tsr"; }

std::string new_stamp_name(const std::string& seal_file) { return stamp_name(seal_file) + ".new"; }

bool has_stamp(const SealFile& seal) {
  std::error_code ignored;
  return std::filesystem::exists(stamp_name(seal.name), ignored) || has_stamp_under_new_name(seal);
}

Result<std::string> asked_stamp(const std::string& url, std::string_view seal) {
  const std::string request = time_stamp_request(seal);
  AXIOMETRY_TRY(std::string answer, server::post({.url = url,
                                                  .type = "application/timestamp-query",
                                                  .body = request,
                                                  .answer_type = "application/timestamp-reply"}));
  AXIOMETRY_TRY_VOID(check_answer(answer, request));
  return answer;
}

Result<void> write_stamped(const std::string& seal_file, const StampedSeal& stamped) {
  AXIOMETRY_TRY_VOID(app::write_file(new_stamp_name(seal_file), stamped.stamp));
  if (auto written = app::write_file(seal_file, stamped.seal); !written) {
    // Of a seal that is there all the same, because only its folder could not be synced, it stays.
    if (!has_stamp_under_new_name(seal_file)) static_cast<void>(remove_new_stamp(seal_file));
    return written;
  }
  return take_usual_name(seal_file);
}

Result<void> settle_stamp(const std::string& seal_file) {
  std::error_code ignored;
  if (!std::filesystem::exists(new_stamp_name(seal_file), ignored)) return {};
  return has_stamp_under_new_name(seal_file) ? take_usual_name(seal_file) : remove_new_stamp(seal_file);
}

Result<FoundStamp> stamp_of(const SealFile& seal, const std::string& authority_file) {
  const std::string file = has_stamp_under_new_name(seal) ? new_stamp_name(seal.name) : stamp_name(seal.name);
  AXIOMETRY_TRY(const std::string stamp, app::whole_file(file));
  AXIOMETRY_TRY(const std::string trusted, app::whole_file(authority_file));
  AXIOMETRY_TRY_VOID(app::in_file(check_certificates(trusted), authority_file));
  AXIOMETRY_TRY(TimeStamp read, app::in_file(read_time_stamp(stamp, seal.bytes, trusted), file));
  return FoundStamp{std::move(read), file};
}

}  // namespace axiometry::cli
