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
/// explicit step stays stable. Both sides sample, each for half of it; force and moment add up to
/// nothing.
///
/// Friction is Coulomb's, friction times p against the relative velocity of the water along the
/// sheets, or less where a tenth of the areal mass is stopped by less within the step.
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
  /// A face near a sample, as it lay when it was last looked at. Its distance is now at least
  /// bound - loss(), and all of it still on the side of `aside` where |aside| > loss_aside().
  struct Near {
    int face;
    float bound;  ///< distance, plus loss() then [m]
    float aside;  ///< least distance of its corners from the plane of the sample's face, plus
                  ///< loss_aside() then: above 0 on the first side, below 0 on the second, 0 if
                  ///< on both [m]
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
  bool is_outdated() const;
  void list();
  void list_faces_near(int face, const BoxLists<D>& faces);
  void list_near(const Sample& s);
  void measure_faces();
  bool apart(int a, int b) const;
  Vec<D> at(const Sample& s, const std::vector<Vec<D>>& x) const;
  /// The nearest points on either side of a sample's face.
  using Feet = std::array<Foot, 2>;
  static double farther(const Feet& feet) { return std::max(feet[0].distance, feet[1].distance); }
  static std::size_t side_of(double height) { return height > 0 ? 1 : 0; }
  /// How much a bound from below of a distance may have lost since the list was made [m].
  double loss() const { return 2 * travelled_; }
  /// The same of the distance from the plane of a face.
  double loss_aside(int face) const { return loss() + far_ * turned_[face]; }
  bool may_be_nearest(const Near& near, const Sample& s, const Feet& feet) const;
  double bound(const Vec<D>& way, int face) const;
  void look(const Sample& s, const Vec<D>& x, Near& near, Feet& feet) const;
  void push_off(std::size_t sample, double dt);
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
  // Faces near each sample. They hold while no point has moved by half the skin.
  double skin_;
  std::vector<Vec<D>> where_;
  std::vector<std::size_t> first_;  ///< of each sample, and the end of the last
  std::vector<Near> near_;
  double travelled_ = 0;        ///< bound of the way of any point since then [m]
  double far_ = 0;              ///< corners of faces within the range are no farther away [m]
  std::vector<double> turned_;  ///< bound of the change of each face's normal since then
  std::vector<int> about_;      ///< faces near one face

  std::vector<Vec<D>> x_, v_;   ///< of the points now [m], [m/s]
  std::vector<Vec<D>> before_;  ///< where they were in the step before [m]
  std::vector<Vec<D>> centre_;  ///< of each face [m]
  std::vector<Vec<D>> normal_;  ///< of each face, unit length
  std::vector<Vec<D>> sum_;     ///< force of each node [N]
  std::vector<double> radius_;  ///< of each face about its centre [m]
};

}  // namespace washtub
