#pragma once
#include <vector>

#include "base/parallel.hpp"
#include "cloth/boxes.hpp"
#include "cloth/nodal_force.hpp"
#include "cloth/surface.hpp"
#include "contact/pair_list.hpp"
#include "contact/settings.hpp"
#include "grid/mesh.hpp"

namespace washtub {

/// What sheets do to each other within a range d0 that the grid does not resolve: a pressure
///   p(d) = P (1 - d/d0)^2 d0/d
/// between each sample of the surface and the nearest point of other cloth on either side of it;
/// sheets beyond those are not felt through them. Faces of the own piece count where they are
/// farther away along the cloth. Below a knee, where -p' reaches a quarter of what moves a sheet in
/// a step (areal mass over dt^2 where it lets no water through), p goes on linearly, so that an
/// explicit step stays stable. Both sides sample, each for half of
/// it; force and moment add up to nothing.
///
/// Friction is Coulomb's, friction times p against the relative velocity along the sheets, or less
/// where a tenth of the areal mass is stopped by less within the step.
template <int D>
class Repulsion : public NodalForce<D> {
 public:
  /// @param friction  coefficient between groups, [group][group]
  Repulsion(const ClothSurface<D>& surface, const Mesh<D>& mesh, const Parallel& parallel,
            const ContactSettings& settings, std::vector<std::vector<double>> friction);

  void add(const ClothMoment<D>& now, std::vector<Vec<D>>& force) override;
  void state(Archive& archive) override { archive.value("age", age_); }

 private:
  using Weights = std::array<double, D>;
  struct Sample {
    int face;
    Weights weight;
    double area;  ///< [m^2]; in 2-D length [m]
  };
  struct Near {
    float bound;  ///< of the distance, from below, when it was listed [m]
    int face;
    auto operator<=>(const Near&) const = default;
  };
  /// The nearest point of a piece.
  struct Foot {
    int face = -1;
    Weights weight;
    Vec<D> gap;  ///< from it to the sample [m]
    double distance;
  };
  /// None yet, and none wanted from this distance on.
  static Foot no_foot(double beyond) { return {-1, {}, {}, beyond}; }

  void add_samples(int face, int parts);
  bool mine(int face) const { return Share(parallel_).has(piece_[face]); }
  void list();
  void list_faces_near(int face, const BoxLists<D>& faces);
  void list_near(const Sample& s);
  void measure_faces();
  bool apart(int a, int b) const;
  Vec<D> at(const Sample& s, const std::vector<Vec<D>>& x) const;
  /// How a face lies to a sample, at little cost.
  struct View {
    Vec<D> way;                     ///< from its centre to the sample [m]
    std::array<Vec<D>, D> corners;  ///< from its centre [m]
    double bound;                   ///< of its distance from below [m]
    int side;                       ///< of the sample's face; 2: some of it on either
  };
  View view(const Vec<D>& x, const Vec<D>& normal, int face) const;
  void look(const View& view, const Vec<D>& normal, int face, std::array<Foot, 2>& sides) const;
  static double nearest_found(const View& view, const std::array<Foot, 2>& sides);
  void push_off(std::size_t sample, double moved, double dt);
  void push(const Sample& s, const Foot& foot, double dt);
  double pressure(double d, double dt) const;
  Vec<D> drag(const Sample& s, const Foot& foot, double normal, double dt) const;

  const ClothSurface<D>& surface_;
  Mesh<D> mesh_;
  Parallel parallel_;
  ContactSettings set_;
  std::vector<std::vector<double>> friction_;
  std::vector<Sample> samples_;  ///< of this rank's pieces
  std::vector<int> piece_;       ///< of each face
  double age_ = 0;               ///< time since the start [s]
  // Faces near each sample, the nearest first. They hold while no point has moved by half the skin.
  double skin_;
  std::vector<Vec<D>> where_;
  std::vector<std::size_t> first_;  ///< of each sample, and the end of the last
  std::vector<Near> near_;
  std::vector<int> about_;  ///< faces near one face

  std::vector<Vec<D>> x_, v_;   ///< of the points now [m], [m/s]
  std::vector<Vec<D>> centre_;  ///< of each face [m]
  std::vector<Vec<D>> normal_;  ///< of each face, unit length
  std::vector<Vec<D>> sum_;     ///< force of each node [N]
  std::vector<double> radius_;  ///< of each face about its centre [m]
};

}  // namespace washtub
