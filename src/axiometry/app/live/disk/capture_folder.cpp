// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/disk/capture_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <set>
#include <system_error>

#include "axiometry/app/files/synced.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/live/disk/stop_marks.h"
#include "axiometry/app/recordings/raw_log.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

constexpr std::string_view order_prefix = "capture-", order_suffix = ".json";
constexpr std::string_view order_end = "\n}\n";  // what is within the outermost braces stands farther right
constexpr std::string_view test_note = "becomes test ", kept_note = "kept", ended_note = "ended ";
constexpr std::size_t sha256_digits = 64;
constexpr const char *counter_name = "/last-number", *adopting_name = "/adopting";

ErrorKind error_kind_of(int error) {
  if (error == ENOSPC || error == EDQUOT) return ErrorKind::full;
  return error == EROFS || error == EACCES ? ErrorKind::read_only : ErrorKind::unavailable;
}

std::unexpected<Error> fail_of_folder(std::string_view doing) {
  const int error = errno;
  return fail(error_kind_of(error), fmt::format("cannot {}: {}", doing, std::strerror(error)));
}

Result<void> put(int descriptor, std::string_view bytes) {
  const bool kept = written_all(descriptor, bytes) && synced(descriptor);
  return kept ? Result<void>{} : fail_of_folder("keep the order of the capture");
}

/// Lines behind the order in its file, so that all of it goes together.
struct Notes {
  std::vector<std::string> tests;
  std::optional<TableEnd> ended;
  bool kept = false;
};

/// A line that a power failure cut off is none.
Notes notes_in(std::string_view bytes) {
  Notes notes;
  for (const std::string_view line : text::split(bytes, '\n')) {
    if (line == kept_note) notes.kept = true;
    if (line.starts_with(test_note) && line.size() == test_note.size() + sha256_digits)
      notes.tests.emplace_back(line.substr(test_note.size()));
    if (!line.starts_with(ended_note)) continue;
    if (const auto end = json::parse(line.substr(ended_note.size())); end && !notes.ended)
      notes.ended = table_end_from(*end);
  }
  return notes;
}

/// And where what is noted behind it begins. Nothing where it is not whole.
std::optional<std::pair<CaptureOrder, std::size_t>> order_in(std::string_view bytes) {
  if (bytes.size() < order_end.size()) return {};
  const std::size_t notes_at = std::min(bytes.find(order_end), bytes.size() - order_end.size()) + order_end.size();
  const auto value = json::parse(bytes.substr(0, notes_at));
  auto order = value ? capture_order_from(*value) : std::nullopt;
  if (!order) return {};
  return std::pair{*std::move(order), notes_at};
}

/// On a line of its own, whatever became of one before.
Result<void> put_note(int descriptor, std::string_view note, std::string_view of = {}) {
  if ((::fcntl(descriptor, F_GETFL) & O_ACCMODE) == O_RDONLY) {
    errno = EROFS;
    return fail_of_folder("keep the order of the capture");
  }
  return put(descriptor, fmt::format("\n{}{}\n", note, of));
}

/// With its times and what was said at its stops.
void remove_recording(const std::string& raw) {
  ::unlink(marks_name(raw).c_str());
  remove_raw(raw);
}

/// The order last, with what is noted in it, so that what is left of a removal that was cut short is found again.
void remove_files(const std::string& base) {
  const std::string order = base + std::string(order_suffix);
  remove_recording(base + ".raw");
  static_cast<void>(folder_synced(order));
  ::unlink(order.c_str());
}

/// The descriptor of an order that nobody else holds. On a disk that has become read-only it can be read, no more.
Result<int> lock(const std::string& order, store::Id id) {
  constexpr int flags = O_CLOEXEC | O_NOFOLLOW;
  int descriptor = ::open(order.c_str(), flags | O_RDWR | O_APPEND);
  if (descriptor < 0 && (errno == EROFS || errno == EACCES)) descriptor = ::open(order.c_str(), flags | O_RDONLY);
  if (descriptor < 0 && errno == ENOENT)
    return fail(ErrorKind::not_found, fmt::format("found no interrupted capture {}", id));
  if (descriptor < 0) return fail_of_folder("open the order of the capture");
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  const bool held_elsewhere = errno == EWOULDBLOCK;
  const auto failed = fail_of_folder("lock the order of the capture");
  ::close(descriptor);
  if (!held_elsewhere) return failed;
  return fail(ErrorKind::conflict,
              fmt::format("found capture {} running elsewhere, expected one that was interrupted", id));
}

/// Waits for whoever holds it.
bool locked(int descriptor) {
  while (::flock(descriptor, LOCK_EX) != 0)
    if (errno != EINTR) return false;
  return true;
}

/// Held while captures are counted, or taken from an archive: two programs must not take the same number, or capture.
class FolderLock {
 public:
  /// Of the folder, or of a file in it that is made for that.
  static Result<FolderLock> take(const std::string& path, int flags = O_RDONLY) {
    FolderLock lock(::open(path.c_str(), flags | O_CLOEXEC, 0600));
    if (lock.descriptor_ < 0 || !locked(lock.descriptor_)) return fail_of_folder("count the captures");
    return lock;
  }
  ~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  FolderLock(FolderLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  FolderLock& operator=(FolderLock&&) = delete;

 private:
  explicit FolderLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

}  // namespace

HeldCapture::HeldCapture(HeldCapture&& other) noexcept
    : base_(std::move(other.base_)),
      id_(other.id_),
      order_(std::move(other.order_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      noted_tests_(std::move(other.noted_tests_)),
      ended_(std::move(other.ended_)),
      kept_(other.kept_) {}

HeldCapture::~HeldCapture() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::string HeldCapture::raw() const { return base_ + ".raw"; }

Result<void> HeldCapture::note_test(const std::string& sha256) {
  AXIOMETRY_TRY_VOID(put_note(descriptor_, test_note, sha256));
  noted_tests_.push_back(sha256);
  return {};
}

void HeldCapture::remove() {
  static_cast<void>(put_note(descriptor_, kept_note));
  remove_files(base_);
}

Result<void> HeldCapture::end(const TableEnd& end) {
  AXIOMETRY_TRY_VOID(put_note(descriptor_, ended_note, json::dump(to_json(end), 0)));
  ended_ = end;
  remove_recording(raw());
  return {};
}

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

/// In place of the number before, which stands until this one is on the disk.
Result<void> CaptureFolder::count(store::Id id) const {
  const std::string name = path_ + counter_name, beside = name + ".new";
  const int counter = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (counter < 0) return fail_of_folder("count the captures");
  auto counted = put(counter, fmt::format("{}", id));
  ::close(counter);
  if (counted && ::rename(beside.c_str(), name.c_str()) != 0) counted = fail_of_folder("count the captures");
  if (!counted) ::unlink(beside.c_str());
  return counted;
}

Result<HeldCapture> CaptureFolder::add(CaptureOrder order) {
  AXIOMETRY_TRY_VOID(make());
  AXIOMETRY_TRY(const FolderLock counting, FolderLock::take(path_));
  const auto last = whole_file(path_ + counter_name);
  const auto all = ids();
  store::Id id = all.empty() ? 0 : all.back();
  if (const auto count = last ? parse_count(*last) : std::nullopt)
    id = std::max(id, static_cast<store::Id>(std::min<unsigned long long>(*count, std::uint64_t{1} << 52)));
  int descriptor = -1;
  do {
    ++id;
    constexpr int flags = O_RDWR | O_APPEND | O_CREAT | O_EXCL | O_CLOEXEC;
    descriptor = ::open((base(id) + std::string(order_suffix)).c_str(), flags, 0600);
  } while (descriptor < 0 && errno == EEXIST);
  if (descriptor < 0) return fail_of_folder("keep the order of the capture");
  HeldCapture held(base(id), id, std::move(order), descriptor);
  // Another program that looks for captures that were left behind holds it for a moment, and finds no order in it yet.
  auto kept = locked(descriptor) ? count(id) : fail_of_folder("hold the capture");
  if (kept) kept = put(descriptor, json::dump(to_json(held.order())) + "\n");
  if (kept && !folder_synced(path_ + counter_name)) kept = fail_of_folder("keep the order of the capture");
  if (!kept) {
    ::unlink((held.base_ + std::string(order_suffix)).c_str());
    return std::unexpected(std::move(kept).error());
  }
  return held;
}

Result<HeldCapture> CaptureFolder::hold(store::Id id) const {
  const std::string name = base(id) + std::string(order_suffix);
  const auto none = [&] { return fail(ErrorKind::not_found, fmt::format("found no interrupted capture {}", id)); };
  AXIOMETRY_TRY(const int descriptor, lock(name, id));
  HeldCapture held(base(id), id, {}, descriptor);
  const std::string bytes = whole_file(name).value_or("");
  auto order = order_in(bytes);
  if (!order) return none();
  const std::size_t notes_at = order->second;
  held.order_ = std::move(order->first);
  Notes notes = notes_in(std::string_view(bytes).substr(notes_at));
  held.noted_tests_ = std::move(notes.tests);
  held.ended_ = std::move(notes.ended);
  held.kept_ = notes.kept;
  return held;
}

Result<HeldCapture> CaptureFolder::take(store::Id id) {
  auto held = hold(id);
  if (held && (held->kept_ || held->ended_))
    return fail(ErrorKind::not_found, fmt::format("found no interrupted capture {}", id));
  return held;
}

std::vector<CaptureFolder::Ended> CaptureFolder::ended() const {
  std::vector<Ended> ended;
  for (const store::Id id : ids())
    if (auto one = this->ended(id)) ended.push_back(*std::move(one));
  return ended;
}

std::optional<CaptureFolder::Ended> CaptureFolder::ended(store::Id id) const {
  const auto held = hold(id);
  if (!held || !held->ended_ || held->kept_) return std::nullopt;
  return Ended{id, {held->order_, *held->ended_}};
}

Result<void> CaptureFolder::adopt(std::span<const EndedCapture> captures) {
  if (captures.empty()) return {};
  AXIOMETRY_TRY_VOID(make());
  AXIOMETRY_TRY(const FolderLock adopting, FolderLock::take(path_ + adopting_name, O_RDWR | O_CREAT));
  std::set<std::string> here;
  for (const store::Id id : ids())  // whoever holds it
    if (const auto order = order_in(whole_file(base(id) + std::string(order_suffix)).value_or("")))
      here.insert(identity_of(order->first));
  Result<void> all;
  for (const EndedCapture& capture : captures) {
    if (!here.insert(identity_of(capture.order)).second) continue;
    auto held = add(capture.order);
    const auto taken = held ? held->end(capture.end) : std::unexpected(held.error());
    if (!taken && all) all = std::unexpected(taken.error());
  }
  return all;
}

Result<void> CaptureFolder::discard(store::Id id, const std::function<Result<void>(const EndedCapture&)>& note) {
  AXIOMETRY_TRY(HeldCapture held, hold(id));
  if (!held.ended_)
    return fail(ErrorKind::conflict, fmt::format("found capture {} not at its end, expected one that has ended", id));
  if (note) AXIOMETRY_TRY_VOID(note({held.order_, *held.ended_}));
  held.remove();
  return {};
}

std::vector<std::string> CaptureFolder::without_order() const {
  std::vector<std::string> recordings;
  for (const store::Id id : ids()) {
    const auto held = hold(id);
    const std::string raw = base(id) + ".raw";
    std::error_code none;
    if (!held && held.error().kind == ErrorKind::not_found && std::filesystem::file_size(raw, none) > 0 && !none)
      recordings.push_back(raw);
  }
  return recordings;
}

std::vector<CaptureFolder::Left> CaptureFolder::left_behind() {
  std::vector<Left> left;
  for (const store::Id id : ids()) {
    auto held = hold(id);
    if (!held) continue;
    if (held->ended_ && !held->kept_) {
      remove_recording(held->raw());
      continue;
    }
    std::error_code error;
    const auto size = std::filesystem::file_size(held->raw(), error);
    if (error && error != std::errc::no_such_file_or_directory) continue;  // bytes may be there
    if (error || size == 0 || held->kept_)
      remove_files(held->base_);
    else
      left.push_back({id, held->order()});
  }
  return left;
}

}  // namespace axiometry::app
