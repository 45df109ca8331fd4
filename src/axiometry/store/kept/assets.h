// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "axiometry/store/database/connection.h"
#include "axiometry/store/proof/attested.h"
#include "axiometry/store/records.h"

/// Machines, axes, instruments, plans, calibrations and compensations within a transaction; Asset is one of the six. As
/// in store.h.
namespace axiometry::store {

template <typename Asset>
Result<Versioned<Asset>> add_asset(Connection& connection, const Asset& asset, const Change& change);

template <typename Asset>
Result<Versioned<Asset>> change_asset(Connection& connection, const Versioned<Asset>& changed);  ///< its new version

template <typename Asset>
Result<Versioned<Asset>> get_asset(Connection& connection, Id id, std::optional<int> version = {});

/// Latest versions, called v, that the rest of a statement asks for: conditions, and an order.
template <typename Asset>
Result<std::vector<Versioned<Asset>>> latest_assets(Connection& connection, std::string_view rest,
                                                    std::span<const Parameter> parameters);

template <typename Asset>
Result<std::vector<Versioned<Asset>>> all_assets(Connection& connection);  ///< latest versions, by id

/// Likewise, of one machine.
Result<std::vector<Versioned<AxisRecord>>> axes_of(Connection& connection, Id machine);

template <typename Asset>
Result<std::vector<Versioned<Asset>>> asset_versions(Connection& connection, Id id);

/// Whether each version has the hash that it was kept with and that the audit trail knows, and the versions and ids are
/// complete.
template <typename Asset>
Result<void> verify_assets(Connection& connection, const Attested& attested, std::vector<std::string>& problems);

/// The next number of a table whose numbers have no gaps. Only within a transaction that writes.
Result<Id> next_id(Connection& connection, std::string_view table);

/// "$3, $4, $5".
std::string places(std::size_t first, std::size_t count);

std::vector<Parameter> parameters_of(const std::vector<Cell>& cells);

/// All these rows by as few statements as there can be.
Result<void> insert_rows(Connection& connection, std::string_view table, std::string_view columns,
                         std::span<const Row> rows);

}  // namespace axiometry::store
