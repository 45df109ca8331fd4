// SPDX-License-Identifier: Apache-2.0
//
// A Content-Type on the first line and a body: the parts of a form lie within the body, in their order, without
// overlap.
#include "described.h"
#include "server/forms/multipart.h"

using namespace axiometry;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto [type, body] = fuzzing::parted(fuzzing::as_text(data, size));
  const auto parts = server::form_parts(type, body);
  if (!parts) {
    fuzzing::check_error(parts.error());
    return 0;
  }
  const char* before = body.data();
  for (const server::FormPart& part : *parts) {
    AXIOMETRY_CONTRACT(part.bytes.data() >= before &&
                       part.bytes.data() + part.bytes.size() <= body.data() + body.size());
    before = part.bytes.data() + part.bytes.size();
    server::header_parameter(part.content_type, "charset");
  }
  return 0;
}
