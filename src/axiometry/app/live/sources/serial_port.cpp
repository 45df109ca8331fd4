// SPDX-License-Identifier: Apache-2.0
//
// A file of its own: <asm/termbits.h>, which knows arbitrary baud rates, and <termios.h> exclude each other.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "axiometry/app/live/sources/live_source.h"

#if defined(__linux__)
#include <asm/ioctls.h>
#include <asm/termbits.h>
#include <sys/ioctl.h>
#endif

namespace axiometry::app {

Result<int> open_serial(const std::string& device, [[maybe_unused]] unsigned baud) {
  const auto failed = [&](std::string_view doing) {
    return std::unexpected(Error{fmt::format("cannot {}: {}", doing, std::strerror(errno)), device, {}});
  };
#if defined(__linux__)
  // Without waiting for the carrier; reading waits again.
  const int descriptor = ::open(device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return failed("open");
  struct termios2 settings {};
  if (::ioctl(descriptor, TCGETS2, &settings) != 0) {
    auto error = failed("use as a serial port");
    ::close(descriptor);
    return error;
  }
  settings.c_iflag = IGNBRK | IGNPAR;
  settings.c_oflag = 0;
  settings.c_lflag = 0;
  settings.c_cflag = CS8 | CREAD | CLOCAL | BOTHER | (BOTHER << IBSHIFT);
  settings.c_ispeed = settings.c_ospeed = baud;
  settings.c_cc[VMIN] = 1;
  settings.c_cc[VTIME] = 0;
  if (::ioctl(descriptor, TCSETS2, &settings) != 0) {
    auto error = failed(fmt::format("set {} baud", baud));
    ::close(descriptor);
    return error;
  }
  return descriptor;
#else
  errno = ENOTSUP;
  return failed("open a serial port on this system");
#endif
}

}  // namespace axiometry::app
