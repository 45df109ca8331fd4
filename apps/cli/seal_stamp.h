// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/digest/time_stamp.h"

/// Time stamps of seals (RFC 3161): an authority outside vouches for the moment at which a seal was there.
///
/// Two files cannot take the places of two others at once. So a new stamp is on the disk under a name of its own before
/// the new seal takes the place of the old one, and only then takes that of the old stamp: at every moment the seal
/// that is there has its stamp under one of the two names.
namespace axiometry::cli {

/// Of the stamp beside a seal, "today.seal.tsr".
std::string stamp_name(const std::string& seal_file);
/// Until the seal stands, "today.seal.tsr.new".
std::string new_stamp_name(const std::string& seal_file);

/// A seal as it was read: what is asked of it more than once is asked of the same bytes, whoever replaces the file.
struct SealFile {
  std::string name;
  std::string bytes;
};

bool has_stamp(const SealFile& seal);

/// Of the authority at that address, over the bytes of a seal; checked but for who signed it. Fails as server::post()
/// and check_answer() do.
Result<std::string> asked_stamp(const std::string& url, std::string_view seal);

struct StampedSeal {
  std::string seal;
  std::string stamp;
};

/// In the places of those that are there. On failure these still stand, or the new ones do, the stamp under its new
/// name.
Result<void> write_stamped(const std::string& seal_file, const StampedSeal& stamped);

/// Brings to its end what write_stamped() could not; nothing where it could.
Result<void> settle_stamp(const std::string& seal_file);

struct FoundStamp {
  TimeStamp stamp;
  std::string file;  ///< name of the file where it lies
};

/// What lies beside a seal. Fails when it is not there, and as read_time_stamp() does, of the certificates in that
/// file.
Result<FoundStamp> stamp_of(const SealFile& seal, const std::string& authority_file);

}  // namespace axiometry::cli
