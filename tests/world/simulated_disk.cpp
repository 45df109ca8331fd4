// SPDX-License-Identifier: Apache-2.0
#include "simulated_disk.h"

#include <sqlite3.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <stdexcept>
#include <utility>

namespace axiometry::world {
namespace {

using Plate = SimulatedDisk::Plate;

constexpr std::size_t sector = 512;  // bytes that are written as a whole or not at all
constexpr std::size_t changes_while_full = 6;

SimulatedDisk* disk = nullptr;  // SQLite knows functions, not objects
sqlite3_vfs* below = nullptr;   // the file system proper

/// What SQLite holds for an open file: this, and behind it the file system's own.
struct OpenFile {
  sqlite3_file base;
  std::shared_ptr<Plate>* plate;  // null for what nobody would miss: temporary files
};

sqlite3_file* own(sqlite3_file* file) { return reinterpret_cast<sqlite3_file*>(reinterpret_cast<OpenFile*>(file) + 1); }
Plate* plate_of(sqlite3_file* file) {
  auto* const plate = reinterpret_cast<OpenFile*>(file)->plate;
  return plate == nullptr ? nullptr : plate->get();
}

int close(sqlite3_file* file) {
  delete reinterpret_cast<OpenFile*>(file)->plate;
  return own(file)->pMethods == nullptr ? SQLITE_OK : own(file)->pMethods->xClose(own(file));
}

int read(sqlite3_file* file, void* to, int size, sqlite3_int64 at) {
  if (const int code = disk->before_read(); code != SQLITE_OK) return code;
  return own(file)->pMethods->xRead(own(file), to, size, at);
}

int write(sqlite3_file* file, const void* from, int size, sqlite3_int64 at) {
  if (const int code = disk->before_change(); code != SQLITE_OK) return code;
  if (Plate* const plate = plate_of(file))
    plate->unsynced.emplace_back(
        SimulatedDisk::Write{at, std::string(static_cast<const char*>(from), static_cast<std::size_t>(size))});
  return own(file)->pMethods->xWrite(own(file), from, size, at);
}

int truncate(sqlite3_file* file, sqlite3_int64 size) {
  if (const int code = disk->before_change(); code != SQLITE_OK) return code;
  if (Plate* const plate = plate_of(file)) plate->unsynced.emplace_back(SimulatedDisk::Truncation{size});
  return own(file)->pMethods->xTruncate(own(file), size);
}

void put(std::string& bytes, std::int64_t at, std::string_view piece) {
  const auto begin = static_cast<std::size_t>(at);
  if (bytes.size() < begin + piece.size()) bytes.resize(begin + piece.size());
  std::memcpy(bytes.data() + begin, piece.data(), piece.size());
}

void make_change(std::string& bytes, const SimulatedDisk::Change& change) {
  if (const auto* written = std::get_if<SimulatedDisk::Write>(&change))
    put(bytes, written->at, written->bytes);
  else
    bytes.resize(static_cast<std::size_t>(std::get<SimulatedDisk::Truncation>(change).size));
}

/// Reaches the plate at once: the files below are never synced themselves.
int sync(sqlite3_file* file, int) {
  if (const int code = disk->before_change(); code != SQLITE_OK) return code;
  if (Plate* const plate = plate_of(file)) sync_plate(*plate);
  disk->synced();
  return SQLITE_OK;
}

int file_size(sqlite3_file* file, sqlite3_int64* size) { return own(file)->pMethods->xFileSize(own(file), size); }
int lock(sqlite3_file* file, int level) { return own(file)->pMethods->xLock(own(file), level); }
int unlock(sqlite3_file* file, int level) { return own(file)->pMethods->xUnlock(own(file), level); }
int reserved(sqlite3_file* file, int* out) { return own(file)->pMethods->xCheckReservedLock(own(file), out); }
int control(sqlite3_file* file, int what, void* with) {
  return own(file)->pMethods->xFileControl(own(file), what, with);
}
int sector_size(sqlite3_file*) { return static_cast<int>(sector); }
int characteristics(sqlite3_file* file) { return own(file)->pMethods->xDeviceCharacteristics(own(file)); }
int map_shared(sqlite3_file* file, int page, int size, int extend, void volatile** out) {
  return own(file)->pMethods->xShmMap(own(file), page, size, extend, out);
}
int lock_shared(sqlite3_file* file, int offset, int count, int flags) {
  return own(file)->pMethods->xShmLock(own(file), offset, count, flags);
}
void shared_barrier(sqlite3_file* file) { own(file)->pMethods->xShmBarrier(own(file)); }
int unmap_shared(sqlite3_file* file, int remove) { return own(file)->pMethods->xShmUnmap(own(file), remove); }

constexpr sqlite3_io_methods methods = {
    .iVersion = 2,
    .xClose = close,
    .xRead = read,
    .xWrite = write,
    .xTruncate = truncate,
    .xSync = sync,
    .xFileSize = file_size,
    .xLock = lock,
    .xUnlock = unlock,
    .xCheckReservedLock = reserved,
    .xFileControl = control,
    .xSectorSize = sector_size,
    .xDeviceCharacteristics = characteristics,
    .xShmMap = map_shared,
    .xShmLock = lock_shared,
    .xShmBarrier = shared_barrier,
    .xShmUnmap = unmap_shared,
    .xFetch = nullptr,
    .xUnfetch = nullptr,
};

int open(sqlite3_vfs*, const char* name, sqlite3_file* file, int flags, int* out_flags) {
  auto* const opened = reinterpret_cast<OpenFile*>(file);
  *opened = {};
  if (!disk->has_power()) return SQLITE_CANTOPEN;
  const int code = below->xOpen(below, name, own(file), flags, out_flags);
  if (code != SQLITE_OK) return code;
  if (name != nullptr) opened->plate = new std::shared_ptr<Plate>(disk->plate_of(name));
  opened->base.pMethods = &methods;
  return SQLITE_OK;
}

int remove(sqlite3_vfs*, const char* name, int synced) {
  if (const int code = disk->before_change(); code != SQLITE_OK) return code;
  const int code = below->xDelete(below, name, 0);
  if (code == SQLITE_OK) disk->removed(name, synced != 0);
  return code;
}

/// A copy of the file system below but for what opens and removes; what is called with it must be told so.
sqlite3_vfs simulated{};

void write_file(const std::string& path, std::string_view bytes) {
  std::ofstream file(path, std::ios::binary);
  file << bytes;
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace

void sync_plate(Plate& plate) {
  plate.exists = true;
  for (const auto& change : plate.unsynced) make_change(plate.bytes, change);
  plate.unsynced.clear();
}

void settle(std::string& bytes, std::vector<SimulatedDisk::Change> changes, std::minstd_rand& chance) {
  const auto one_in = [&](unsigned n) { return chance() % n == 0; };
  if (one_in(4)) return;                                 // nothing had left the cache
  if (one_in(3)) std::ranges::shuffle(changes, chance);  // else mostly in their order
  const std::size_t last = one_in(2) ? changes.size() : chance() % (changes.size() + 1);
  const bool all = one_in(3);
  for (std::size_t k = 0; k < last; ++k) {
    if (!all && one_in(3)) continue;
    const auto* const written = std::get_if<SimulatedDisk::Write>(&changes[k]);
    if (all || written == nullptr || written->bytes.size() <= sector || !one_in(3)) {
      make_change(bytes, changes[k]);
      continue;
    }
    for (std::size_t at = 0; at < written->bytes.size(); at += sector)
      if (!one_in(2))
        put(bytes, written->at + static_cast<std::int64_t>(at), std::string_view(written->bytes).substr(at, sector));
  }
}

SimulatedDisk::SimulatedDisk() {
  if (disk != nullptr) throw std::logic_error("found a second simulated disk, expected one at a time");
  disk = this;
  below = sqlite3_vfs_find("unix");
  simulated = *below;
  simulated.pNext = nullptr;
  simulated.zName = "simulated";
  simulated.szOsFile = static_cast<int>(sizeof(OpenFile)) + below->szOsFile;
  simulated.xOpen = open;
  simulated.xDelete = remove;
  sqlite3_vfs_register(&simulated, 1);
}

SimulatedDisk::~SimulatedDisk() {
  sqlite3_vfs_unregister(&simulated);
  sqlite3_vfs_register(below, 1);
  disk = nullptr;
}

void SimulatedDisk::plan_trouble(Trouble trouble, std::size_t after) {
  trouble_ = trouble;
  changes_until_trouble_ = after;
}

void SimulatedDisk::calm() { troubled_ = !power_ || full_for_ > 0; }

int SimulatedDisk::before_change() {
  if (!power_) return SQLITE_IOERR;
  if (full_for_ > 0) {
    --full_for_;
    return SQLITE_FULL;
  }
  if (trouble_ == Trouble::none || trouble_ == Trouble::read_fails) return SQLITE_OK;
  if (changes_until_trouble_-- > 0) return SQLITE_OK;
  troubled_ = true;
  const Trouble begins = std::exchange(trouble_, Trouble::none);
  if (begins == Trouble::full) {
    full_for_ = changes_while_full;
    return SQLITE_FULL;
  }
  if (begins == Trouble::power_fails) power_ = false;
  return SQLITE_IOERR_WRITE;
}

int SimulatedDisk::before_read() {
  if (!power_) return SQLITE_IOERR;
  if (trouble_ != Trouble::read_fails || changes_until_trouble_-- > 0) return SQLITE_OK;
  trouble_ = Trouble::none;
  troubled_ = true;
  return SQLITE_IOERR_READ;
}

/// A file that is there before anything is written is on the plate as it is.
std::shared_ptr<Plate> SimulatedDisk::plate_of(const std::string& path) {
  auto& plate = plates_[path];
  if (!plate) {
    plate = std::make_shared<Plate>();
    if (std::ifstream file(path, std::ios::binary); file) {
      plate->bytes.assign(std::istreambuf_iterator<char>(file), {});
      plate->exists = !plate->bytes.empty();
    }
  }
  return plate;
}

void SimulatedDisk::removed(const std::string& path, bool synced) {
  const auto known = plates_.find(path);
  if (known == plates_.end()) return;
  if (synced)
    removed_unsynced_.erase(path);
  else if (known->second->exists)
    removed_unsynced_[path] = known->second;
  plates_.erase(known);
}

void SimulatedDisk::after_power_failure(const std::string& folder, const std::string& into, std::minstd_rand& chance) {
  namespace files = std::filesystem;
  const auto in_folder = [&](const std::string& path) { return into + "/" + files::path(path).filename().string(); };
  for (const auto& file : files::directory_iterator(folder))
    if (file.is_regular_file()) plate_of(file.path().string());  // also what nobody opened
  for (const auto& [path, plate] : removed_unsynced_)
    if (chance() % 2 == 0 && !plates_.contains(path)) write_file(in_folder(path), plate->bytes);
  for (const auto& [path, plate] : plates_) {
    if (path.ends_with("-shm")) continue;  // shared memory, made anew
    if (!plate->exists && (plate->unsynced.empty() || chance() % 2 == 0)) continue;
    std::string bytes = plate->bytes;
    if (!plate->unsynced.empty()) settle(bytes, plate->unsynced, chance);
    write_file(in_folder(path), bytes);
  }
}

}  // namespace axiometry::world
