// SPDX-License-Identifier: Apache-2.0
#include "axiometry/digest/sha256.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>

#include "axiometry/base/contract.h"

namespace axiometry {

struct Sha256::State {
  EVP_MD_CTX* context = EVP_MD_CTX_new();
  ~State() { EVP_MD_CTX_free(context); }
};

Sha256::Sha256() : state_(std::make_unique<State>()) {
  AXIOMETRY_CONTRACT(EVP_DigestInit_ex(state_->context, EVP_sha256(), nullptr) == 1);
}
Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

void Sha256::update(std::string_view bytes) {
  AXIOMETRY_CONTRACT(EVP_DigestUpdate(state_->context, bytes.data(), bytes.size()) == 1);
}

std::string Sha256::finish() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned length = 0;
  AXIOMETRY_CONTRACT(EVP_DigestFinal_ex(state_->context, digest.data(), &length) == 1);
  std::string hexadecimal;
  for (unsigned k = 0; k < length; ++k) hexadecimal += fmt::format("{:02x}", digest[k]);
  return hexadecimal;
}

std::string sha256(std::string_view bytes) {
  Sha256 hash;
  hash.update(bytes);
  return hash.finish();
}

}  // namespace axiometry
