// SPDX-License-Identifier: Apache-2.0
//
// Loaded in front of the C library (LD_PRELOAD): the NAMES_FAIL_AT-th change of a name that has NAMES_FAIL_OF in it
// fails with EIO, or ends the program before or after it is made (NAMES_FAIL_HOW: fails, before, after).
#include <dlfcn.h>
#include <signal.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace {

int changes = 0;

std::string_view asked(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

void end_if(bool that) {
  if (that) static_cast<void>(::raise(SIGKILL));
}

template <typename Change>
int changed(const char* name, Change change) {
  const std::string_view of = asked("NAMES_FAIL_OF"), how = asked("NAMES_FAIL_HOW");
  const bool is_it = !of.empty() && std::string_view(name).find(of) != std::string_view::npos &&
                     ++changes == std::atoi(asked("NAMES_FAIL_AT").data());
  if (is_it && how == "fails") {
    errno = EIO;
    return -1;
  }
  end_if(is_it && how == "before");
  const int done = change();
  end_if(is_it && how == "after");
  return done;
}

}  // namespace

extern "C" int rename(const char* from, const char* to) noexcept {
  using Real = int (*)(const char*, const char*);
  static const Real real = reinterpret_cast<Real>(::dlsym(RTLD_NEXT, "rename"));
  return changed(to, [&] { return real(from, to); });
}

extern "C" int remove(const char* name) noexcept {
  using Real = int (*)(const char*);
  static const Real real = reinterpret_cast<Real>(::dlsym(RTLD_NEXT, "remove"));
  return changed(name, [&] { return real(name); });
}
