// SPDX-License-Identifier: Apache-2.0
#include "simulated_files.h"

#include <fcntl.h>
#include <sqlite3.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace axiometry::world {
namespace {

using Plate = SimulatedDisk::Plate;

SimulatedFiles* files = nullptr;  // the system calls functions, not objects

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

SimulatedFiles::SimulatedFiles(SimulatedDisk& disk, const std::string& folder, std::minstd_rand& chance)
    : disk_(disk), folder_(folder), chance_(chance) {
  if (files != nullptr) throw std::logic_error("found a second folder of simulated files, expected one at a time");
  if (std::filesystem::is_directory(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      auto plate = std::make_shared<Plate>();
      plate->bytes = bytes_of(entry.path().string());
      names_[entry.path().string()] = plate;
    }
  on_plate_ = names_;
  files = this;
}

SimulatedFiles::~SimulatedFiles() { files = nullptr; }

bool SimulatedFiles::has(const std::string& path) const { return std::filesystem::path(path).parent_path() == folder_; }

int SimulatedFiles::before_change() const {
  const int code = disk_.before_change();
  return code == SQLITE_OK ? 0 : code == SQLITE_FULL ? ENOSPC : EIO;
}

void SimulatedFiles::make(Names& names, const std::vector<Renaming>& change) {
  for (const Renaming& one : change)
    if (one.file)
      names[one.path] = one.file;
    else
      names.erase(one.path);
}

void SimulatedFiles::change_names(std::vector<Renaming> change) {
  make(names_, change);
  unsynced_.push_back(std::move(change));
}

void SimulatedFiles::opened(int descriptor, const std::string& path, bool truncated) {
  if (!names_.contains(path)) change_names({{path, std::make_shared<Plate>()}});
  files_[descriptor] = names_[path];
  if (truncated) files_[descriptor]->unsynced.emplace_back(SimulatedDisk::Truncation{0});
}

void SimulatedFiles::written(int descriptor, std::int64_t at, std::string_view bytes) {
  files_.at(descriptor)->unsynced.emplace_back(SimulatedDisk::Write{at, std::string(bytes)});
}

void SimulatedFiles::truncated(int descriptor, std::int64_t size) {
  files_.at(descriptor)->unsynced.emplace_back(SimulatedDisk::Truncation{size});
}

void SimulatedFiles::synced(int descriptor) {
  if (const auto file = files_.find(descriptor); file != files_.end()) return sync_plate(*file->second);
  for (const auto& change : unsynced_) make(on_plate_, change);
  unsynced_.clear();
}

void SimulatedFiles::closed(int descriptor) {
  files_.erase(descriptor);
  folders_.erase(descriptor);
}

void SimulatedFiles::renamed(const std::string& from, const std::string& to) {
  const File file = names_.at(from);
  change_names({{from, nullptr}, {to, file}});
}

void SimulatedFiles::linked(const std::string& from, const std::string& to) { change_names({{to, names_.at(from)}}); }

void SimulatedFiles::removed(const std::string& path) { change_names({{path, nullptr}}); }

void SimulatedFiles::after_power_failure(const std::string& into) {
  const std::size_t there = chance_() % 2 == 0 ? unsynced_.size() : chance_() % (unsynced_.size() + 1);
  for (std::size_t k = 0; k < there; ++k) make(on_plate_, unsynced_[k]);
  std::map<Plate*, std::string> settled;  // a file may have two names
  std::filesystem::create_directories(into);
  for (const auto& [path, plate] : on_plate_) {
    const auto [found, is_new] = settled.try_emplace(plate.get(), plate->bytes);
    if (is_new) settle(found->second, plate->unsynced, chance_);
    std::ofstream(into + "/" + std::filesystem::path(path).filename().string(), std::ios::binary) << found->second;
  }
}

}  // namespace axiometry::world

namespace {

using axiometry::world::files;

/// Whether the call must not be made; errno says why.
bool is_refused() {
  errno = files->before_change();
  return errno != 0;
}

std::string absolute(const char* path) { return std::filesystem::absolute(path).lexically_normal().string(); }

}  // namespace

extern "C" {

int __real_open(const char* path, int flags, ...);
int __real_close(int descriptor);
ssize_t __real_write(int descriptor, const void* bytes, size_t count);
int __real_fsync(int descriptor);
int __real_fdatasync(int descriptor);
int __real_ftruncate(int descriptor, off_t size);
int __real_rename(const char* from, const char* to);
int __real_link(const char* from, const char* to);
int __real_unlink(const char* path);

int __wrap_open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const unsigned mode = (flags & O_CREAT) != 0 ? va_arg(rest, unsigned) : 0;
  va_end(rest);
  const std::string name = files == nullptr ? "" : absolute(path);
  if (files != nullptr && files->is_folder(name)) {
    const int folder = __real_open(path, flags);
    if (folder >= 0) files->opened_folder(folder);
    return folder;
  }
  // Also of who only reads: a descriptor for reading brings a file onto the plate as any other does.
  const bool is_ours = files != nullptr && files->has(name);
  const bool changes =
      is_ours && (flags & O_ACCMODE) != O_RDONLY && ((flags & O_TRUNC) != 0 || !std::filesystem::exists(name));
  if (changes && is_refused()) return -1;
  const int descriptor = __real_open(path, flags, mode);
  if (is_ours && descriptor >= 0) files->opened(descriptor, name, (flags & O_TRUNC) != 0);
  return descriptor;
}

int __wrap_close(int descriptor) {
  if (files != nullptr) files->closed(descriptor);
  return __real_close(descriptor);
}

ssize_t __wrap_write(int descriptor, const void* bytes, size_t count) {
  if (files == nullptr || !files->knows(descriptor)) return __real_write(descriptor, bytes, count);
  if (is_refused()) return -1;
  if (count > 1 && files->is_cut_short()) count /= 2;
  const off_t at = (::fcntl(descriptor, F_GETFL) & O_APPEND) != 0 ? ::lseek(descriptor, 0, SEEK_END)
                                                                  : ::lseek(descriptor, 0, SEEK_CUR);
  const ssize_t put = __real_write(descriptor, bytes, count);
  if (put > 0) files->written(descriptor, at, {static_cast<const char*>(bytes), static_cast<std::size_t>(put)});
  return put;
}

/// Reaches the plate at once: the files below are never synced themselves.
int __wrap_fsync(int descriptor) {
  if (files == nullptr || !files->knows(descriptor)) return __real_fsync(descriptor);
  if (is_refused()) return -1;
  files->synced(descriptor);
  return 0;
}

int __wrap_fdatasync(int descriptor) {
  return files == nullptr || !files->knows(descriptor) ? __real_fdatasync(descriptor) : __wrap_fsync(descriptor);
}

int __wrap_ftruncate(int descriptor, off_t size) {
  if (files == nullptr || !files->knows(descriptor)) return __real_ftruncate(descriptor, size);
  if (is_refused()) return -1;
  files->truncated(descriptor, size);
  return __real_ftruncate(descriptor, size);
}

int __wrap_rename(const char* from, const char* to) {
  if (files == nullptr || !files->has(absolute(from))) return __real_rename(from, to);
  if (is_refused()) return -1;
  const int done = __real_rename(from, to);
  if (done == 0) files->renamed(absolute(from), absolute(to));
  return done;
}

int __wrap_link(const char* from, const char* to) {
  if (files == nullptr || !files->has(absolute(from))) return __real_link(from, to);
  if (is_refused()) return -1;
  const int done = __real_link(from, to);
  if (done == 0) files->linked(absolute(from), absolute(to));
  return done;
}

int __wrap_unlink(const char* path) {
  if (files == nullptr || !files->has(absolute(path))) return __real_unlink(path);
  if (is_refused()) return -1;
  const int done = __real_unlink(path);
  if (done == 0) files->removed(absolute(path));
  return done;
}

}  // extern "C"
