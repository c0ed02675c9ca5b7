#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "io/history.hpp"
#include "record/declared.hpp"
#include "record/sample.hpp"

namespace washtub {

/// A column as it is declared; its values are taken from what `Source` describes. The name follows
/// that of the solid, probe or piece whose column it is.
template <class Source>
struct DeclaredColumn {
  Declared about;
  double (*take)(const Source&);
  Plot plot = {};
};

/// The declarations of history.csv and tracks.csv, in the order of the columns.
namespace columns {
extern const std::vector<DeclaredColumn<Sample>> run, energy, error, cloth, rings;
extern const std::vector<DeclaredColumn<SolidSample>> solid;
extern const std::vector<DeclaredColumn<Vec<3>>> probe;
extern const std::vector<DeclaredColumn<PieceSample>> group, piece;
}  // namespace columns

/// A column of one run.
struct RecordColumn {
  Column column;
  std::string meaning;
  std::function<double(const Sample&)> take;
};

/// Columns that the tables of a case have.
std::vector<RecordColumn> history_columns(const Case& whole);
std::vector<RecordColumn> track_columns(const Case& whole);  ///< none where there is no cloth

std::vector<Column> header(const std::vector<RecordColumn>& columns);
std::vector<double> row(const std::vector<RecordColumn>& columns, const Sample& sample);

/// "piece 3 r", counted from 1.
std::string piece_column(int piece, const char* what);

/// What is declared of a column, known by its name alone: that of a solid or probe comes first.
struct KnownColumn {
  std::string owner;  ///< "" where it is the run's
  const Declared& about;
  const Plot& plot;
};

/// None for a column of another version.
std::optional<KnownColumn> known_column(const std::string& name);

/// The groups of cloth that have pieces; where there is only one, its columns are the run's.
std::vector<ClothCase> groups_apart(const Case& whole);

/// All pieces of cloth of a case.
int piece_count(const Case& whole);

}  // namespace washtub
