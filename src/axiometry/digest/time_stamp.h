// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "axiometry/base/result.h"

/// Time stamps after RFC 3161: an authority signs that bytes of a given SHA-256 were there at a moment of its clock.
namespace axiometry {

/// Fails where a text holds no certificate (PEM).
Result<void> check_certificates(std::string_view text);

/// What an authority is asked (TimeStampReq, DER): the hash of the bytes, a random number that its answer must repeat,
/// and its certificate.
std::string time_stamp_request(std::string_view bytes);

struct TimeStamp {
  std::string at;         ///< RFC 3339, UTC, as the authority's clock had it
  std::string authority;  ///< subject of the certificate that signed it, RFC 2253
};

/// Of an answer (TimeStampResp, DER). Fails on what is no such answer, on a refusal, in the authority's words, on one
/// of other bytes, and on a signature that no certificate of `trusted` (PEM, roots of authorities) vouches for at the
/// moment of the stamp. Whether a certificate was revoked since is not asked.
Result<TimeStamp> read_time_stamp(std::string_view answer, std::string_view bytes, std::string_view trusted);

/// Of an answer that just came, where the authority's roots are not known: that it is one to this request, of its bytes
/// and with its number. Fails likewise. Contract: time_stamp_request() made the request.
Result<void> check_answer(std::string_view answer, std::string_view request);

/// Of an answer that lies beside bytes: that it is of these and of no others, whoever signed it. Fails likewise.
Result<void> check_stamped(std::string_view answer, std::string_view bytes);

}  // namespace axiometry
