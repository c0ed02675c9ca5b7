#pragma once
#include <nlohmann/json.hpp>

#include "io/table.hpp"

namespace washtub {

/// What is declared of the columns of a history: the list of ColumnIndex of
/// viewer/src/model/bundle.ts. Solids that turn come first; columns of another version are left
/// out.
nlohmann::ordered_json columns_index(const CsvTable& history);

}  // namespace washtub
