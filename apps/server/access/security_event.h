// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace axiometry::server {

/// What of an answer concerns security, and is told in the log by these names with hyphens.
enum class SecurityEvent {
  none,
  signed_in,
  signed_in_ending_another,  ///< there were as many sessions as there may be: that which was unused for longest ended
  sign_in_refused,
  signed_out,
  session_refused,  ///< one that was shown is over, or never was
  token_missing,
  token_refused,
  host_refused,
  origin_refused,  ///< what another page has the browser ask
  method_refused,
  quota_refused,  ///< too large, too many, or no memory left for it
};

}  // namespace axiometry::server
