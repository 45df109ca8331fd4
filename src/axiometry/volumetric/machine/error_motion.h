// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// The 21 errors of three linear axes, named after ISO 230-1: of axis a the error motions E_Xa, E_Ya, E_Za (µm) and
/// E_Aa, E_Ba, E_Ca (µrad, right-handed about X, Y, Z), functions of the axis' position; and three squareness errors
/// (µrad), with X the primary and Y the secondary axis. Every one of them is the actual less the commanded place of the
/// tool relative to the workpiece, in the directions of the axes, whichever side of the machine moves.
namespace axiometry::volumetric {

inline constexpr std::size_t axis_count = 3;
inline constexpr std::size_t motion_count = 6;  ///< motions of one axis: X, Y, Z, A, B, C
inline constexpr std::size_t first_rotation = 3;

/// One of the 18 functions.
struct ErrorMotion {
  std::size_t axis = 0;    ///< 0 to 2: the axis that moves
  std::size_t motion = 0;  ///< 0 to 5: displacement along X, Y, Z, rotation about X, Y, Z

  bool is_rotation() const { return motion >= first_rotation; }
  bool is_positioning() const { return motion == axis; }
  bool is_straightness() const { return !is_rotation() && motion != axis; }
  friend bool operator==(const ErrorMotion&, const ErrorMotion&) = default;
};

/// "EXY": the displacement along X when Y moves; "EAZ": the rotation about X when Z moves.
std::string error_name(ErrorMotion error);

/// The reverse; absent for other names.
std::optional<ErrorMotion> error_motion_named(std::string_view name);

/// "straightness", "positioning", "roll", "pitch", "yaw". Pitch is the rotation that lifts (about the horizontal axis
/// across the motion), yaw the one that turns in the plane; of a vertical axis pitch is that about X, yaw about Y.
std::string_view error_kind(ErrorMotion error);

/// Squareness of two axes, µrad: by how much the angle between the axes' mean directions departs.
enum class Squareness : std::size_t {
  C0Y,  ///< Y against X: the Y axis is turned by C0Y about Z, δ_x = −C0Y·y
  B0Z,  ///< Z against X: turned by B0Z about Y, δ_x = +B0Z·z
  A0Z,  ///< Z against Y: turned by A0Z about X, δ_y = −A0Z·z
};
inline constexpr std::array<std::string_view, 3> squareness_names = {"C0Y", "B0Z", "A0Z"};

/// "EXX", "EYX", …, "ECZ", "C0Y", "B0Z", "A0Z": all 21 in the order in which they are printed.
std::array<std::string, axis_count * motion_count + 3> error_names();

}  // namespace axiometry::volumetric
