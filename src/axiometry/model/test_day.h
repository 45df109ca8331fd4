// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

/// The day on which a test can have been made, of the text that its metadata hold.
namespace axiometry {

/// From 1950, before which there was no numerical control, to the last day that it is anywhere: "2014-05-15".
bool can_be_day_of_test(std::string_view iso_day);

/// iso_date() of such a text; empty where it is none, or where no test can have been made on that day.
std::string day_of_test(std::string_view date);

}  // namespace axiometry
