#pragma once
#include <optional>
#include <vector>

#include "base/table.hpp"
#include "case/case.hpp"
#include "case/parts.hpp"
#include "case/preset.hpp"

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
/// What follows from other keys of `[[cloth]]`, and names of groups that have none.
void complete_cloth(CaseFile& file, const Node& root, int dimension);
/// The key of a member of the i-th of `total` cloth tables.
std::string cloth_key(size_t i, size_t total, const std::string& name);
/// Adds the keys that say where and how cloth starts.
void add_start(Table<ClothCase>& table);
Table<ProbeCase> probe_table();
Table<ExactCase> exact_table();
Table<CouplingCase> coupling_table();
Table<ContactCase> contact_table();
Table<SettleCase> settle_table();
/// Whether cloth settles before the run, and how, where the file does not say.
void complete_settle(CaseFile& file, const Node& root, int dimension);
Table<TimeCase> time_table();
Table<SolverCase> solver_table();
Table<OutputCase> output_table();
Table<CheckpointCase> checkpoint_table();
Table<ScaleCase> scale_table();

/// Refuses what no single key shows; `root` is the whole file, for the place of a key.
/// @throws InputError
void check_case(const CaseFile& file, const Node& root);
void check_sides(const Case& whole, const Node& root);
void check_solids(const CaseFile& file, const Node& root);
void check_cloth(const CaseFile& file, const Node& root);
void check_probes(const Case& whole, const Node& root);
void check_contact(const Case& whole, const Node& root);
void check_settle(const Case& whole, const Node& root);

/// Shortens the window of the statistics, and the interval of the rows, that a file gives to a run
/// that --set has made shorter, and says so.
void fit_output(CaseFile& file, const Node& root, int dimension);
/// Notes what the case allows but hardly means.
void note_jumps(CaseFile& file, const Node& root, int dimension);

/// An error at a key of the file; where the file does not give the key, at the file, with the
/// value that was filled in, as its default.
InputError error_at_key(const Node& root, const std::string& key, const std::string& value,
                        const std::string& message);
std::string metres(double length);  ///< `"0.5 m"`

}  // namespace washtub
