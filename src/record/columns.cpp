#include "record/columns.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace washtub {

namespace {

/// The columns of one kind, appended for one thing that a sample holds.
class Columns {
 public:
  explicit Columns(int dimension) : dimension_(dimension) {}

  /// `of` finds the thing in a sample; `owner`: its name, "" where there is only one of its kind.
  template <class Source, class Of>
  void add(const std::vector<DeclaredColumn<Source>>& declared, Of of,
           const std::string& owner = "", bool moving = false) {
    for (const auto& column : declared) {
      const Declared& about = column.about;
      if (!about.applies(dimension_, moving)) continue;
      all.push_back(
          {{owner.empty() ? about.name : owner + ' ' + about.name, about.unit.in(dimension_)},
           about.meaning,
           [of, take = column.take](const Sample& s) { return take(of(s)); }});
    }
  }
  std::vector<RecordColumn> all;

 private:
  int dimension_;
};

std::string piece_name(int piece) { return fmt::format("piece {}", piece); }

const Sample& itself(const Sample& s) { return s; }

bool has_rings(const Case& whole) {
  return std::any_of(whole.cloth.begin(), whole.cloth.end(),
                     [](const ClothCase& cloth) { return cloth.arrangement == Arrangement::ring; });
}

void add_cloth(Columns& columns, const Case& whole) {
  columns.add(columns::cloth, itself);
  const auto groups = groups_apart(whole);
  for (std::size_t i = 0; i < groups.size(); ++i)
    columns.add(
        columns::group, [i](const Sample& s) { return s.groups[i]; }, groups[i].name);
  for (std::size_t i = 0; i < whole.probes.size(); ++i)
    columns.add(
        columns::probe, [i](const Sample& s) { return s.probes[i]; }, whole.probes[i].name);
  if (has_rings(whole)) columns.add(columns::rings, itself);
}

}  // namespace

std::vector<ClothCase> groups_apart(const Case& whole) {
  std::vector<ClothCase> groups;
  for (const ClothCase& cloth : whole.cloth)
    if (cloth.count > 0) groups.push_back(cloth);
  return groups.size() > 1 ? groups : std::vector<ClothCase>{};
}

std::vector<RecordColumn> history_columns(const Case& whole) {
  Columns columns(whole.dimension);
  columns.add(columns::run, itself);
  if (is_closed(whole)) columns.add(columns::energy, itself);
  for (std::size_t i = 0; i < whole.solids.size(); ++i)
    columns.add(
        columns::solid, [i](const Sample& s) { return s.solids[i]; }, whole.solids[i].name,
        whole.solids[i].drive.moving());
  const std::size_t before = columns.all.size();
  if (whole.exact) columns.add(columns::error, itself);
  if (whole.exact && whole.exact->relative)
    for (std::size_t i = before; i < columns.all.size(); ++i) columns.all[i].column.unit = "";
  if (!whole.cloth.empty()) add_cloth(columns, whole);
  return columns.all;
}

std::vector<RecordColumn> track_columns(const Case& whole) {
  Columns columns(whole.dimension);
  if (whole.cloth.empty()) return {};
  columns.add(std::vector{columns::run.front()}, itself);
  for (int p = 0; p < piece_count(whole); ++p)
    columns.add(
        columns::piece, [i = static_cast<std::size_t>(p)](const Sample& s) { return s.pieces[i]; },
        piece_name(p + 1));
  return columns.all;
}

std::vector<Column> header(const std::vector<RecordColumn>& columns) {
  std::vector<Column> header;
  for (const RecordColumn& column : columns) header.push_back(column.column);
  return header;
}

std::vector<double> row(const std::vector<RecordColumn>& columns, const Sample& sample) {
  std::vector<double> row;
  for (const RecordColumn& column : columns) row.push_back(column.take(sample));
  return row;
}

namespace {

/// The one with the longest name that ends a column's name, and what comes before it.
template <class Source>
void find_owned(const std::vector<DeclaredColumn<Source>>& declared, const std::string& name,
                std::optional<KnownColumn>& best) {
  for (const auto& column : declared) {
    const std::string tail = std::string(" ") + column.about.name;
    if (!name.ends_with(tail) || name.size() == tail.size()) continue;
    std::string owner = name.substr(0, name.size() - tail.size());
    if (!best || owner.size() < best->owner.size())
      best.emplace(KnownColumn{std::move(owner), column.about, column.plot});
  }
}

}  // namespace

std::optional<KnownColumn> known_column(const std::string& name) {
  for (const auto* declared :
       {&columns::run, &columns::energy, &columns::error, &columns::cloth, &columns::rings})
    for (const auto& column : *declared)
      if (name == column.about.name) return KnownColumn{"", column.about, column.plot};
  std::optional<KnownColumn> best;
  find_owned(columns::solid, name, best);
  find_owned(columns::probe, name, best);
  find_owned(columns::group, name, best);
  return best;
}

std::string piece_column(int piece, const char* what) {
  return fmt::format("{} {}", piece_name(piece), what);
}

int piece_count(const Case& whole) {
  int pieces = 0;
  for (const ClothCase& cloth : whole.cloth) pieces += cloth.count;
  return pieces;
}

}  // namespace washtub
