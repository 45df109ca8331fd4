// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/capture_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "axiometry/app/raw_log.h"
#include "axiometry/app/synced.h"
#include "axiometry/app/whole_file.h"
#include "axiometry/base/json.h"
#include "axiometry/base/number_text.h"
#include "axiometry/formats/plan_json.h"

namespace axiometry::app {
namespace {

using json::Kind;
using json::Value;

constexpr std::string_view order_prefix = "capture-", order_suffix = ".json";
constexpr const char* counter_name = "/last-number";

ErrorKind error_kind_of(int error) {
  if (error == ENOSPC || error == EDQUOT) return ErrorKind::full;
  return error == EROFS || error == EACCES ? ErrorKind::read_only : ErrorKind::unavailable;
}

std::unexpected<Error> fail_of_folder(std::string_view doing) {
  const int error = errno;
  return fail(error_kind_of(error), fmt::format("cannot {}: {}", doing, std::strerror(error)));
}

Result<void> put(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return fail_of_folder("keep the order of the capture");
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return synced(descriptor) ? Result<void>{} : fail_of_folder("keep the order of the capture");
}

std::string text_of(const CaptureOrder& order) {
  Value options = Value::object();
  for (const auto& [name, text] : order.options) options.add(name, text);
  Value value = Value::object();
  value.add("plan", static_cast<double>(order.plan));
  value.add("part", order.part);
  value.add("source", order.source);
  value.add("layout", order.layout);
  value.add("options", std::move(options));
  value.add("actor", order.actor);
  value.add("started", order.started);
  value.add("walked", formats::plan_value(order.walked));
  return json::dump(value) + "\n";
}

std::optional<CaptureOrder> order_from(std::string_view bytes) {
  const auto value = json::parse(bytes);
  if (!value || !value->is(Kind::object)) return {};
  const auto text = [&](std::string_view name) {
    const Value* member = value->find(name);
    return member != nullptr && member->is(Kind::text) ? member->text() : std::string();
  };
  const auto number = [&](std::string_view name) {
    const Value* member = value->find(name);
    return member != nullptr && member->is(Kind::number) ? member->number() : 0.0;
  };
  const Value* walked = value->find("walked");
  if (walked == nullptr) return {};
  auto plan = formats::plan_from_value(*walked);
  if (!plan) return {};
  CaptureOrder order{.plan = static_cast<store::Id>(number("plan")),
                     .part = static_cast<std::size_t>(number("part")),
                     .walked = *std::move(plan),
                     .source = text("source"),
                     .layout = text("layout"),
                     .options = {},
                     .actor = text("actor"),
                     .started = text("started")};
  if (const Value* options = value->find("options"); options != nullptr && options->is(Kind::object))
    for (const auto& [name, option] : options->members())
      if (option.is(Kind::text)) order.options.emplace_back(name, option.text());
  return order;
}

std::string kept_name(const std::string& base) { return base + ".kept"; }

/// The order last, so that what is left of a removal that was cut short is found again.
void remove_files(const std::string& base) {
  for (const std::string& name : {base + ".raw", times_name(base + ".raw"), times_name(base + ".raw") + ".old",
                                  kept_name(base), base + std::string(order_suffix)})
    ::unlink(name.c_str());
}

/// The descriptor of an order that nobody else holds, or -1.
int lock(const std::string& base) {
  const int descriptor = ::open((base + std::string(order_suffix)).c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
  if (descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  if (descriptor >= 0) ::close(descriptor);
  return -1;
}

}  // namespace

HeldCapture::HeldCapture(HeldCapture&& other) noexcept
    : base_(std::move(other.base_)),
      id_(other.id_),
      order_(std::move(other.order_)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

HeldCapture::~HeldCapture() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::string HeldCapture::raw() const { return base_ + ".raw"; }

Result<void> HeldCapture::note_kept(store::Id test) {
  const int descriptor = ::open(kept_name(base_).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (descriptor < 0) return fail_of_folder("note the test of the capture");
  auto noted = put(descriptor, fmt::format("{}\n", test));
  ::close(descriptor);
  if (noted && !folder_synced(kept_name(base_))) return fail_of_folder("note the test of the capture");
  return noted;
}

void HeldCapture::remove() { remove_files(base_); }

Result<void> CaptureFolder::make() const {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error)
    return fail(error_kind_of(error.value()), fmt::format("cannot make the folder of captures: {}", error.message()));
  ::chmod(path_.c_str(), 0700);
  return {};
}

std::string CaptureFolder::base(store::Id id) const { return fmt::format("{}/{}{}", path_, order_prefix, id); }

std::vector<store::Id> CaptureFolder::ids() const {
  std::vector<store::Id> ids;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(path_, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(order_prefix) || !name.ends_with(order_suffix)) continue;
    const auto id = parse_count(
        std::string_view(name).substr(order_prefix.size(), name.size() - order_prefix.size() - order_suffix.size()));
    if (id && *id > 0 && *id < std::uint64_t{1} << 53) ids.push_back(static_cast<store::Id>(*id));
  }
  std::ranges::sort(ids);
  return ids;
}

Result<HeldCapture> CaptureFolder::add(CaptureOrder order) {
  AXIOMETRY_TRY_VOID(make());
  const auto last = whole_file(path_ + counter_name);
  const auto all = ids();
  store::Id id = all.empty() ? 0 : all.back();
  if (const auto count = last ? parse_count(*last) : std::nullopt)
    id = std::max(id, static_cast<store::Id>(std::min<unsigned long long>(*count, std::uint64_t{1} << 52)));
  int descriptor = -1;
  do {
    ++id;
    descriptor = ::open((base(id) + std::string(order_suffix)).c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  } while (descriptor < 0 && errno == EEXIST);
  if (descriptor < 0) return fail_of_folder("keep the order of the capture");
  HeldCapture held(base(id), id, std::move(order), descriptor);
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) return fail_of_folder("hold the capture");
  const int counter = ::open((path_ + counter_name).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  auto kept = counter < 0 ? fail_of_folder("count the captures") : put(counter, fmt::format("{}", id));
  if (counter >= 0) ::close(counter);
  if (kept) kept = put(descriptor, text_of(held.order()));
  if (kept && !folder_synced(path_ + counter_name)) kept = fail_of_folder("keep the order of the capture");
  if (!kept) {
    held.remove();
    return std::unexpected(std::move(kept).error());
  }
  return held;
}

Result<HeldCapture> CaptureFolder::take(store::Id id) {
  const auto bytes = whole_file(base(id) + std::string(order_suffix));
  auto read = bytes ? order_from(*bytes) : std::nullopt;
  if (!read) return fail(ErrorKind::not_found, fmt::format("found no interrupted capture {}", id));
  const int descriptor = lock(base(id));
  if (descriptor < 0)
    return fail(ErrorKind::conflict,
                fmt::format("found capture {} running elsewhere, expected one that was interrupted", id));
  return HeldCapture(base(id), id, *std::move(read), descriptor);
}

std::vector<CaptureFolder::Left> CaptureFolder::left_behind() {
  std::vector<Left> left;
  for (const store::Id id : ids()) {
    auto held = take(id);
    if (!held) continue;
    std::error_code error;
    const auto size = std::filesystem::file_size(held->raw(), error);
    if (error && error != std::errc::no_such_file_or_directory) continue;  // bytes may be there
    if (error || size == 0 || ::access(kept_name(base(id)).c_str(), F_OK) == 0)
      held->remove();
    else
      left.push_back({id, held->order()});
  }
  return left;
}

}  // namespace axiometry::app
