// SPDX-License-Identifier: Apache-2.0
#include "axiometry/digest/ed25519.h"

#include <gtest/gtest.h>

namespace axiometry {
namespace {

// RFC 8032, 7.1, test 2: the secret in PKCS #8 as RFC 8410 wraps it.
constexpr std::string_view published_secret =
    "-----BEGIN PRIVATE KEY-----\n"
    "MC4CAQAwBQYDK2VwBCIEIEzNCJso/5banbbDRuwRTg9bijGfNaumJNqM9u1PuKb7\n"
    "-----END PRIVATE KEY-----\n";
constexpr std::string_view published_key = "3d4017c3e843895a92b70aa74d1b7ebc9c982ccf2ec4968cc0cd55f12af4660c";
constexpr std::string_view published_signature =
    "92a009a9f0d4cab8720e820b5f642540a2b27b5416503f8fb3762223ebdb69da085ac1e43e15996e458f3613d0f11d8c387b2eaeb4302aeeb0"
    "0d291612bb0c00";

TEST(Ed25519, AgreesWithThePublishedExample) {
  const auto key = SigningKey::from_pem(published_secret);
  ASSERT_TRUE(key);
  EXPECT_EQ(key->public_key(), published_key);
  EXPECT_EQ(key->signature("\x72"), published_signature);
  EXPECT_EQ(key->pem(), published_secret);
  EXPECT_TRUE(is_signed("\x72", published_signature, published_key));
}

TEST(Ed25519, TakesNothingForSignedThatIsNot) {
  EXPECT_FALSE(is_signed("\x73", published_signature, published_key));
  EXPECT_FALSE(is_signed("\x72", published_signature, SigningKey::make().public_key()));
  EXPECT_FALSE(is_signed("\x72", "", published_key));
  EXPECT_FALSE(is_signed("\x72", published_signature, "3D"));
}

TEST(Ed25519, MakesANewKeyEachTimeAndReadsNoneFromOtherText) {
  EXPECT_NE(SigningKey::make().public_key(), SigningKey::make().public_key());
  EXPECT_FALSE(SigningKey::from_pem(""));
  EXPECT_FALSE(SigningKey::from_pem("-----BEGIN PRIVATE KEY-----\nabc\n-----END PRIVATE KEY-----\n"));
}

}  // namespace
}  // namespace axiometry
