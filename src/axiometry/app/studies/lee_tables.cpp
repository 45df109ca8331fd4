// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/studies/lee_tables.h"

namespace axiometry::app::lee {
namespace {

constexpr std::array<Row, row_count> table = {{
    {"x, +", {1, 0, 0}, {-1.00, 0.00, 0.00}, {0.06, -0.10, -0.01}},
    {"x, −", {-1, 0, 0}, {1.00, 0.00, 0.00}, {-0.06, 0.10, 0.02}},
    {"y, +", {0, 1, 0}, {0.00, -1.00, 0.00}, {0.15, -0.25, -0.03}},
    {"y, −", {0, -1, 0}, {0.00, 1.01, 0.01}, {-0.14, 0.24, 0.04}},
    {"z, +", {0, 0, 1}, {0.00, 0.00, -0.99}, {0.01, -0.01, -0.04}},
    {"z, −", {0, 0, -1}, {0.01, 0.00, 1.00}, {-0.02, 0.03, 0.40}},
    {"x and y, +", {1, 1, 0}, {-1.00, -1.00, 0.01}, {0.21, -0.35, -0.04}},
    {"x and y, −", {-1, -1, 0}, {1.00, 1.00, 0.01}, {-0.20, 0.35, 0.05}},
    {"x and z, +", {1, 0, 1}, {-1.00, 0.00, -0.99}, {0.06, -0.11, -0.05}},
    {"x and z, −", {-1, 0, -1}, {1.00, 0.00, 1.01}, {-0.06, 0.11, 0.06}},
    {"y and z, +", {0, 1, 1}, {0.01, -1.00, -1.00}, {0.15, -0.25, -0.07}},
    {"y and z, −", {0, -1, -1}, {0.00, 1.00, 1.01}, {-0.14, 0.25, 0.08}},
}};

/// Points relative to the station.
struct Relative {
  std::string_view name;
  double error;
  bool about_home;
  bool refined;
  std::array<Vector3, 6> points_mm;
};
constexpr std::array<Relative, 5> relative = {{
    {"F1",
     1e-3,
     false,
     false,
     {{{-52, -18, 337}, {103, 80, 84}, {93, 124, 387}, {88, 28, 217}, {-99, -66, 147}, {-183, 297, 511}}}},
    {"F2",
     1e-3,
     false,
     true,
     {{{-78, -110, 125}, {-458, 462, 267}, {244, 471, 246}, {143, 130, 101}, {269, 31, 210}, {104, -4, 116}}}},
    {"F3",
     1e-4,
     true,
     true,
     {{{-163, 412, 146}, {-608, 479, 218}, {-248, 166, 95}, {-86, 248, 166}, {-62, 226, 107}, {-82, 142, 110}}}},
    {"F4",
     1e-4,
     false,
     false,
     {{{178, 178, 80}, {189, -163, 369}, {-249, -360, 111}, {301, -408, 417}, {-134, 55, 160}, {150, -497, 400}}}},
    {"F5",
     1e-2,
     false,
     false,
     {{{-447.7, 492.8, 449.3},
       {317.6, 137.1, 86.9},
       {-408.7, -401.3, 385.6},
       {322.4, -158.4, 142.4},
       {-325.2, 149.2, 87.4},
       {415.2, 411.8, 389.8}}}},
}};

}  // namespace

std::span<const Row, row_count> rows() { return table; }

Vector3 table3_corrected_mm(std::size_t row) {
  Vector3 shift = table[row].table3_mm;
  if (row == misprinted_row) shift.z = misprinted_mm;
  return shift;
}

std::vector<Vector3> points_mm() {
  return {{800, 0, 850}, {200, -200, 900}, {1100, -200, 400}, {250, -350, 400}, {700, -50, 700}, {550, 450, 450}};
}

std::vector<Fixture> fixtures() {
  std::vector<Fixture> list;
  for (const Relative& r : relative) {
    Fixture f{.name = std::string(r.name),
              .error = r.error,
              .station_mm = station_mm,
              .origin_mm = r.about_home ? Vector3{} : station_mm,
              .refined = r.refined,
              .points_mm = {}};
    for (const Vector3 point : r.points_mm) f.points_mm.push_back(station_mm + point);
    list.push_back(std::move(f));
  }
  return list;
}

}  // namespace axiometry::app::lee
