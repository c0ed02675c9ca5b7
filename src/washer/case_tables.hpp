#pragma once
#include <optional>
#include <vector>

#include "base/table.hpp"
#include "washer/case.hpp"
#include "washer/case_parts.hpp"
#include "washer/preset.hpp"

namespace washtub {

/// A whole case file while it is read.
struct CaseFile {
  Case result;
  std::optional<WasherSpec> washer;
  std::vector<SolidSpec> solids;  ///< as written, without those of the washer
};

/// The declaration of all keys of a case file.
const Table<CaseFile>& case_table();

Table<FluidCase> fluid_table();
Table<DomainCase> domain_table();
Table<ClothCase> cloth_table();
Table<CouplingCase> coupling_table();
Table<TimeCase> time_table();
Table<SolverCase> solver_table();
Table<OutputCase> output_table();
Table<ScaleCase> scale_table();

/// Refuses what no single key shows; `root` is the whole file, for the place of a key.
/// @throws InputError
void check_case(const CaseFile& file, const Node& root);

}  // namespace washtub
