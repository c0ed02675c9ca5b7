#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/vec.hpp"

namespace washtub {

/// Kinds of numbers that an archive holds.
enum class Number { real64, real32, int64, int32, byte };

template <class T>
constexpr Number number_of() {
  if constexpr (std::is_same_v<T, double>) {
    return Number::real64;
  } else if constexpr (std::is_same_v<T, float>) {
    return Number::real32;
  } else if constexpr (std::is_same_v<T, long>) {
    return Number::int64;
  } else if constexpr (std::is_same_v<T, int>) {
    return Number::int32;
  } else {
    static_assert(std::is_arithmetic_v<T> && sizeof(T) == 1, "no archive holds such numbers");
    return Number::byte;
  }
}

constexpr std::size_t size_of(Number kind) {
  return kind == Number::byte ? 1 : kind == Number::real32 || kind == Number::int32 ? 4 : 8;
}

/// Types made of nothing but doubles: places, and structs that say so.
template <class T>
concept OfDoubles = std::is_base_of_v<Eigen::MatrixBase<T>, T> || requires {
  requires T::of_doubles;
};

/// Which part of a grid's values a rank has, and where they lie in its memory; slowest axis first.
/// One layer of ghosts beyond each side of the box belongs to the whole.
struct GridPart {
  using Triple = std::array<std::size_t, 3>;
  Triple extent{1, 1, 1};              ///< of the whole, layers beyond the sides included
  Triple offset{}, count{1, 1, 1};     ///< in the whole: what this rank has and no other
  Triple near{}, near_count{1, 1, 1};  ///< in the whole: that and its ghosts
  Triple memory{1, 1, 1};              ///< extent of the array in memory, which begins with `near`
  std::size_t start = 0;               ///< of the array, from the first value in memory

  std::size_t values() const { return memory[0] * memory[1] * memory[2]; }
};

/// What state goes into or comes out of. A class that carries values from one step to the next
/// names each of them once, in `void state(Archive&)`; nothing else knows what a checkpoint holds.
/// Lists are the same on all ranks, grids are shared out among them.
class Archive {
 public:
  /// `within`: what all names begin with, as in "flow/".
  explicit Archive(std::string within = "") : prefix_(std::move(within)) {}
  virtual ~Archive() = default;

  /// Whether values are taken out of the archive and put into the object.
  virtual bool reading() const = 0;

  /// A number, truth value or enumerator, a place, a list of them (whose length the archive knows),
  /// or whatever else has a state.
  template <class T>
  void value(const std::string& name, T& x) {
    if constexpr (std::is_same_v<T, bool> || std::is_enum_v<T>) {
      int number = static_cast<int>(x);
      list(path(name), Number::int32, &number, 1);
      x = static_cast<T>(number);
    } else if constexpr (std::is_arithmetic_v<T>) {
      list(path(name), number_of<T>(), &x, 1);
    } else if constexpr (OfDoubles<T>) {
      list(path(name), Number::real64, &x, sizeof(T) / sizeof(double));
    } else {
      const std::string outer = prefix_;
      prefix_ = path(name) + "/";
      enter(prefix_);
      x.state(*this);
      prefix_ = outer;
    }
  }
  template <class T>
  void value(const std::string& name, std::vector<T>& x) {
    if constexpr (std::is_arithmetic_v<T> || OfDoubles<T>) {
      constexpr std::size_t n = OfDoubles<T> ? sizeof(T) / sizeof(double) : 1;
      constexpr Number kind = [] {
        if constexpr (OfDoubles<T>)
          return Number::real64;
        else
          return number_of<T>();
      }();
      x.resize(length(path(name), x.size() * n) / n);
      list(path(name), kind, x.data(), x.size() * n);
    } else {
      std::size_t i = 0;
      for (T& part : x) value(name + " " + std::to_string(i++), part);
    }
  }
  void value(const std::string& name, std::string& text) {
    text.resize(length(path(name), text.size()));
    list(path(name), Number::byte, text.data(), text.size());
  }
  /// A list that is as long as it was when the archive was written.
  /// @throws InputError where it is not
  template <class T>
  void same_length(const std::string& name, std::vector<T>& x) {
    const std::size_t before = x.size();
    value(name, x);
    if (x.size() != before) wrong_length(path(name), x.size(), before);
  }
  /// The values of a grid, as `Storage` holds them.
  template <class Values>
  void grid(const std::string& name, Values& values, const GridPart& part) {
    using T = std::remove_cvref_t<decltype(values[0])>;
    grid_values(path(name), number_of<T>(), values.data() + part.start, part);
  }
  /// One grid for each axis: "velocity x", "velocity y".
  template <class Values, std::size_t D>
  void grids(const std::string& name, std::array<Values, D>& values, const GridPart& part) {
    for (std::size_t d = 0; d < D; ++d)
      grid(std::string(name).append(1, ' ').append(1, "xyz"[d]), values[d], part);
  }

 protected:
  /// Called before the values whose names begin with `prefix`, as in "flow/".
  virtual void enter(const std::string& prefix) = 0;
  virtual void list(const std::string& path, Number kind, void* data, std::size_t count) = 0;
  /// Length of a list in the archive; `now` where it is being written.
  virtual std::size_t length(const std::string& path, std::size_t now) = 0;
  /// `data`: the first value of the array in memory.
  virtual void grid_values(const std::string& path, Number kind, void* data,
                           const GridPart& part) = 0;

 private:
  std::string path(const std::string& name) const { return prefix_ + name; }
  [[noreturn]] static void wrong_length(const std::string& path, std::size_t archived,
                                        std::size_t here);

  std::string prefix_;
};

}  // namespace washtub
